//! All that is kept about one student in one course, to be handed to that student.

use std::collections::BTreeMap;

use serde::Serialize;

use super::assignment::Extension;
use super::corrected::WorkedSheet;
use super::handed_in::{Draft, HintShown, Override, OverrideRule};
use super::moment::Moment;
use super::people::{Course, Member, Person};
use super::stored_report::{ShownReport, StoredReport};

/// All that is kept about one student in one course. What the student may not see yet is left out, and so are seeds, which draw
/// answers.
#[derive(Clone, Debug, Serialize)]
pub struct StudentData<'a> {
    /// The title of the course.
    pub course: &'a str,
    /// The name by which the student signs in.
    pub login: &'a str,
    /// The name of the student.
    pub name: &'a str,
    /// The section.
    pub section: &'a str,
    /// When the student left the course.
    pub left: Option<Moment>,
    /// The sheets.
    pub sheets: Vec<SheetData<'a>>,
    /// Extensions.
    pub extensions: &'a [Extension],
    /// Answers that were not handed in.
    pub drafts: &'a [Draft],
}

/// The data kept about a sheet.
#[derive(Clone, Debug, Serialize)]
pub struct SheetData<'a> {
    /// The problem.
    pub problem: &'a str,
    /// The form.
    pub form: Option<&'a str>,
    /// The text as it was shown.
    pub statement: &'a str,
    /// When it was first seen.
    pub seen: Moment,
    /// The attempts.
    pub attempts: Vec<AttemptData<'a>>,
    /// The hints that were shown.
    pub hints: &'a [HintShown],
    /// The points set by hand, without who set them.
    pub by_hand: Vec<ByHandData<'a>>,
}

/// The data kept about an attempt.
#[derive(Clone, Debug, Serialize)]
pub struct AttemptData<'a> {
    /// Its number.
    pub number: u32,
    /// When the server had it.
    pub received: Moment,
    /// The typed answers.
    pub answers: &'a BTreeMap<String, String>,
    /// The report of its marks that the student may see.
    pub report: Option<ShownReport>,
}

/// Points that were set by hand.
#[derive(Clone, Debug, Serialize)]
pub struct ByHandData<'a> {
    /// The points.
    pub points: Option<&'a str>,
    /// How they count beside those of marking.
    pub rule: OverrideRule,
    /// Why.
    pub reason: &'a str,
    /// A further remark to the student.
    pub comment: &'a str,
    /// When.
    pub at: Moment,
}

impl<'a> StudentData<'a> {
    /// The data kept about a student, as they may be seen at a moment.
    #[must_use]
    pub fn of(
        (course, member, person): (&'a Course, &'a Member, &'a Person),
        sheets: &'a [(WorkedSheet<'a>, Vec<Override>)],
        extensions: &'a [Extension],
        drafts: &'a [Draft],
        at: Moment,
    ) -> Self {
        let sheets = sheets.iter().filter(|(worked, _)| worked.sheet.member == member.key);
        Self {
            course: &course.title,
            login: &person.login,
            name: &person.name,
            section: &member.section,
            left: member.left,
            sheets: sheets.map(|(worked, by_hand)| SheetData::of(worked, by_hand, at)).collect(),
            extensions,
            drafts,
        }
    }
}

impl<'a> SheetData<'a> {
    fn of(worked: &'a WorkedSheet<'a>, by_hand: &'a [Override], at: Moment) -> Self {
        let issued = &worked.sheet.issued;
        let attempt = |(place, attempt): (usize, &'a super::handed_in::Attempt)| AttemptData {
            number: attempt.number,
            received: attempt.received,
            answers: &attempt.answers,
            report: worked.reports.get(place).map(|report: &StoredReport| report.shown(&worked.window, at)),
        };
        let released = worked.window.shows_verdicts(at);
        let by_hand = by_hand.iter().filter(|decision| released && !decision.reason.is_empty());
        Self {
            problem: &issued.problem,
            form: issued.form.as_deref(),
            statement: &issued.statement,
            seen: worked.sheet.seen,
            attempts: worked.attempts.iter().enumerate().map(attempt).collect(),
            hints: worked.hints,
            by_hand: by_hand
                .map(|decision| ByHandData {
                    points: decision.points.as_deref(),
                    rule: decision.rule,
                    reason: &decision.reason,
                    comment: &decision.comment,
                    at: decision.at,
                })
                .collect(),
        }
    }
}
