//! Assignments, and what is changed in them afterwards.

use serde::{Deserialize, Serialize};

use crate::problem::CourseSymbols;

use super::key::Key;
use super::moment::Moment;
use super::people::{Course, Member};

/// Problems that are handed out together, under one policy.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Assignment {
    /// What other records call it.
    pub key: Key<Assignment>,
    /// The course.
    pub course: Key<Course>,
    /// Its title.
    pub title: String,
    /// When and how it is worked on and marked.
    pub policy: super::Policy,
    /// When its problems were pinned, which is when it first opened.
    pub pinned: Option<Moment>,
}

/// A problem of an assignment.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Item {
    /// What other records call it.
    pub key: Key<Item>,
    /// The assignment.
    pub assignment: Key<Assignment>,
    /// Its place in the assignment, from 0.
    pub position: u32,
    /// The problem's identity.
    pub problem: String,
    /// The form's name, where the problem has forms with names.
    pub form: Option<String>,
    /// What the whole item is worth; the points of the problem's parts are scaled to it.
    pub points: u32,
    /// The digest of the file from which its sheets are drawn, once the assignment has opened.
    pub digest: Option<String>,
    /// The letters in which its sheets are printed, once it has opened; the problem's own come first.
    pub letters: CourseSymbols,
    /// Which issue of its sheets counts: it grows where sheets were issued anew.
    pub issue: u32,
    /// Whether it no longer counts.
    pub dropped: bool,
}

/// More time for one student: it replaces these instants of the policy.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Extension {
    /// The assignment.
    pub assignment: Key<Assignment>,
    /// The student.
    pub member: Key<Member>,
    /// When answers are due.
    pub due: Moment,
    /// Until when they are taken late, where they are.
    pub late_until: Option<Moment>,
    /// When the assignment closes.
    pub closes: Moment,
    /// Why it was given.
    pub reason: String,
}

/// What becomes of old sheets where a corrected problem no longer draws them.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CorrectionChoice {
    /// They are marked by the corrected problem, which draws and asks the same.
    Remark,
    /// Everybody has full marks.
    FullMarks,
    /// The item no longer counts.
    Drop,
    /// New sheets are issued; the old ones no longer count.
    IssueAnew,
}

/// A corrected problem taken into an assignment.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Correction {
    /// The item.
    pub item: Key<Item>,
    /// The digest before.
    pub from: String,
    /// The digest after.
    pub to: String,
    /// What became of the old sheets.
    pub choice: CorrectionChoice,
    /// When.
    pub at: Moment,
}
