//! Assignments, and what is changed in them afterwards.

use serde::{Deserialize, Serialize};

use momentous_problem::CourseSymbols;

use super::key::Key;
use super::moment::Moment;
use super::people::{Course, Member};
use super::weights::Weights;

/// Problems that are handed out together, under one policy.
#[derive(Clone, Debug, Deserialize, Eq, PartialEq, Serialize)]
pub struct Assignment {
    /// The key by which other records name it.
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
    /// The key by which other records name it.
    pub key: Key<Item>,
    /// The assignment.
    pub assignment: Key<Assignment>,
    /// Its place in the assignment, from 0.
    pub position: u32,
    /// The problem's identity.
    pub problem: String,
    /// The form's name, where the problem has forms with names.
    pub form: Option<String>,
    /// The points of the whole item; the points of the problem's parts are scaled to them.
    pub points: u32,
    /// How much its parts count beside each other.
    #[serde(default, skip_serializing_if = "Weights::is_empty")]
    pub weights: Weights,
    /// Which of the items that ask the same problem in the same form it is, from 0; each draws other numbers.
    #[serde(default)]
    pub repeat: u32,
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

/// The choice about old sheets where a corrected problem no longer draws them.
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
    /// The choice about the old sheets.
    pub choice: CorrectionChoice,
    /// Whether it was not to lower anybody's points.
    #[serde(default)]
    pub never_lower: bool,
    /// Why it was taken in; students are told.
    #[serde(default)]
    pub reason: String,
    /// A further remark to students; empty where there is none.
    #[serde(default)]
    pub comment: String,
    /// When.
    pub at: Moment,
}

impl Item {
    /// The digest of the file that is right, as far as is known: that of its last correction, whatever was chosen for the marks; else the
    /// one from which its sheets are drawn. Worked solutions and keys are made from it.
    ///
    /// `corrections` are those of the assignment, the earliest first.
    #[must_use]
    pub fn right_digest<'a>(&'a self, corrections: &'a [Correction]) -> Option<&'a str> {
        let last =
            corrections.iter().rfind(|correction| correction.item == self.key).map(|correction| correction.to.as_str());
        last.or(self.digest.as_deref())
    }
}
