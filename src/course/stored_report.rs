//! Stored reports of marked attempts, and what a student may see of them.

use std::borrow::Cow;

use serde::{Deserialize, Serialize, Serializer};

use momentous_grade::Diagnosis;
use momentous_grade::Entry;
use momentous_grade::Follows;
use momentous_grade::History;
use momentous_grade::PartReport;
use momentous_grade::Points;
use momentous_grade::Verdict;
use momentous_laws::wrong;
use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::handed_in::{Attempt, HintShown};
use super::moment::Moment;
use super::window::{Late, Window};

/// The stored report of a marked attempt. Points are exact. It holds all that the next attempt must know of those before it.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct StoredReport {
    /// The parts, in the order of the sheet.
    pub parts: Vec<StoredPart>,
    /// The points of this sheet.
    #[serde(with = "exact")]
    pub total: Rational,
    /// The points that can be reached.
    pub out_of: u32,
    /// How late it was, where it was.
    pub late: Option<Late>,
    /// The history of the student's hand-ins.
    pub history: History,
    /// The work that stands; nothing where none was handed in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<StoredWork>,
}

/// The stored work beside the answers.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct StoredWork {
    /// Its lines.
    pub text: String,
    /// The number of times that work was handed in that differed from the one before.
    pub made: u32,
    /// The share of its points that the time leaves to it.
    #[serde(with = "exact")]
    pub factor: Rational,
}

/// The stored report of a part.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct StoredPart {
    /// The name of the part in answers.
    pub id: String,
    /// The points that can be reached.
    pub out_of: u32,
    /// How the answer came into this attempt.
    pub entry: Entry,
    /// When the answer was entered that stands; nothing where there is none.
    pub since: Option<Moment>,
    /// The reading of the answer that stands. It is known without the right one, as are the next two.
    pub read: Option<String>,
    /// Why what was typed cannot be read, where it cannot.
    pub unread: Option<String>,
    /// The number of attempts that were counted at the part by now.
    pub made: u32,
    /// The verdict.
    pub verdict: Verdict,
    /// The points reached.
    #[serde(with = "exact")]
    pub points: Rational,
    /// The message to the student.
    pub message: String,
    /// The usual mistakes that lead to the answer, by their codes.
    pub mistakes: Vec<String>,
    /// The hints on them, a question first, each plainer than the one before; the message has the first.
    pub hints: Vec<String>,
    /// The earlier parts from which the answer follows.
    pub follows_from: Vec<String>,
    /// The values that would have followed from the student's own answers, once no attempt is left.
    pub own_values: Option<String>,
}

/// The part of an attempt's report that a student may see.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ShownReport {
    /// The parts, in the order of the sheet.
    pub parts: Vec<ShownPart>,
    /// The points of this sheet, once verdicts are shown.
    pub total: Option<Points>,
    /// The points that can be reached.
    pub out_of: u32,
    /// How late it was, where it was.
    pub late: Option<Late>,
}

/// The part of a part's report that a student may see.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ShownPart {
    /// The name of the part in answers.
    pub id: String,
    /// The points that can be reached.
    pub out_of: u32,
    /// How the answer came into this attempt.
    pub entry: Entry,
    /// The reading of the answer that stands.
    pub read: Option<String>,
    /// Why what was typed cannot be read, where it cannot.
    pub unread: Option<String>,
    /// The number of attempts that were counted at the part by now.
    pub made: u32,
    /// The finding, once verdicts are shown.
    pub found: Option<Found>,
}

/// The finding on a part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Found {
    /// The code of the verdict.
    pub verdict: Verdict,
    /// Whether the answer is right.
    pub right: bool,
    /// The points reached; a page says them as they are printed everywhere.
    #[serde(serialize_with = "printed")]
    pub points: Points,
    /// The message to the student.
    pub message: String,
    /// The values that would have followed from the student's own answers, once no attempt is left.
    pub own_values: Option<String>,
}

fn printed<S: Serializer>(points: &Points, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(points)
}

/// A hint that can be shown next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NextHint {
    /// Its number among the further hints at the part, from 1.
    pub number: u32,
    /// Its text.
    pub text: String,
}

impl StoredReport {
    /// Reads the stored report of an attempt.
    ///
    /// # Errors
    /// Where it was written by another program, or another version of this one.
    pub fn of(attempt: &Attempt) -> Result<Self, serde_json::Error> {
        serde_json::from_str(attempt.report.get())
    }

    /// The report that the student may see at a moment. Before verdicts are shown it is what was read, and nothing that depends
    /// on what is right.
    #[must_use]
    pub fn shown(&self, window: &Window, at: Moment) -> ShownReport {
        let released = window.shows_verdicts(at);
        ShownReport {
            parts: self.parts.iter().map(|part| part.shown(released)).collect(),
            total: released.then(|| Points(self.total.clone())),
            out_of: self.out_of,
            late: self.late.clone(),
        }
    }

    /// The part of that name.
    #[must_use]
    pub fn part(&self, id: &str) -> Option<&StoredPart> {
        self.parts.iter().find(|part| part.id == id)
    }

    /// The parts as marking reports them, for statistics: this attempt is the one that counts, or it is not.
    pub fn reports(&self, counts: bool) -> impl Iterator<Item = PartReport> {
        self.parts.iter().map(move |part| part.report(counts))
    }
}

impl StoredPart {
    fn shown(&self, released: bool) -> ShownPart {
        let finding = || Found {
            verdict: self.verdict,
            right: self.verdict.is_right(),
            points: Points(self.points.clone()),
            message: self.message.clone(),
            own_values: self.own_values.clone(),
        };
        ShownPart {
            id: self.id.clone(),
            out_of: self.out_of,
            // That a part is locked says that it is right.
            entry: if self.entry == Entry::Locked && !released { Entry::Carried } else { self.entry },
            read: self.read.clone(),
            unread: self.unread.clone(),
            made: self.made,
            found: released.then(finding),
        }
    }

    /// The further hints on this answer that were shown already.
    pub fn hints_shown<'a>(&'a self, shown: &'a [HintShown]) -> impl Iterator<Item = &'a str> {
        self.hints.iter().skip(1).take(self.shown_here(shown)).map(String::as_str)
    }

    /// The next further hint on this answer, where there is one and verdicts are shown. Whoever shows it records it.
    #[must_use]
    pub fn next_hint(&self, shown: &[HintShown], window: &Window, at: Moment) -> Option<NextHint> {
        let text = self.hints.get(self.shown_here(shown) + 1).filter(|_| window.shows_verdicts(at))?;
        let before = shown.iter().filter(|hint| self.is_on(hint)).map(|hint| hint.number).max();
        Some(NextHint { number: before.unwrap_or(0).saturating_add(1), text: text.clone() })
    }

    fn shown_here(&self, shown: &[HintShown]) -> usize {
        shown.iter().filter(|hint| self.is_on(hint) && self.since.is_some_and(|since| hint.at >= since)).count()
    }

    fn is_on(&self, hint: &HintShown) -> bool {
        hint.part.as_deref() == Some(self.id.as_str())
    }

    fn report(&self, counts: bool) -> PartReport {
        let codes: Vec<&'static str> = self.mistakes.iter().filter_map(|code| Some(wrong::find(code)?.id)).collect();
        let diagnosis = (!codes.is_empty()).then(|| Diagnosis { codes, step: None, hints: self.hints.clone() });
        let follows = (!self.follows_from.is_empty()).then(|| Follows {
            from: self.follows_from.clone(),
            by: Vec::new(),
            unphysical: None,
        });
        PartReport {
            id: self.id.clone(),
            verdict: self.verdict,
            points: Points(self.points.clone()),
            out_of: self.out_of,
            understood: self.read.clone(),
            fault: None,
            message: Cow::Owned(self.message.clone()),
            diagnosis,
            follows,
            own_values: self.own_values.clone(),
            entry: self.entry,
            counts,
        }
    }
}

#[cfg(test)]
mod tests {
    use momentous_quantity::Rational;

    use super::*;

    #[test]
    fn a_page_says_points_as_they_are_printed_everywhere() {
        let points = Points(Rational::from(2) / Rational::from(3));
        let finding = Found { verdict: Verdict::Right, right: true, points, message: String::new(), own_values: None };
        let said = serde_json::to_value(finding).map(|json| json["points"].clone());
        assert_eq!(said.ok(), Some("0.67".into()));
    }
}
