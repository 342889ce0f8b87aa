//! Whether the answers of a table could be read: where most could not, an option is wrong rather than the students.

use std::ops::AddAssign;

use crate::grade::PartReport;
use crate::grade::Verdict;

use super::Mark;

/// The codes of faults that come of the mark between whole and decimal digits.
const OF_MARKS: [&str; 3] = ["ambiguous_mark", "marks", "other_mark"];

/// How many answers there were, and how many could not be read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Legibility {
    answered: u64,
    unread: u64,
    /// Those of the unread that the other decimal mark may read.
    of_marks: u64,
}

impl Legibility {
    /// The answer to one part.
    pub(super) fn of(part: &PartReport) -> Self {
        let unread = part.is_unread();
        let of_marks = part.fault.as_ref().is_some_and(|fault| OF_MARKS.contains(&fault.code));
        Self {
            answered: u64::from(part.verdict != Verdict::Unanswered),
            unread: u64::from(unread),
            of_marks: u64::from(unread && of_marks),
        }
    }

    /// The remark where most answers could not be read, with this mark.
    pub(super) fn told(&self, mark: Mark) -> Option<String> {
        let Self { answered, unread, of_marks } = *self;
        if unread * 2 <= answered {
            return None;
        }
        let said = format!("warning: {unread} of {answered} answers could not be read");
        let other = match mark {
            Mark::Point => "comma",
            Mark::Comma => "point",
        };
        Some(if of_marks * 2 > unread {
            format!(
                "{said}, {of_marks} of them because of their decimal marks\nhelp: `--decimal {other}` reads numbers as these are written"
            )
        } else {
            format!(
                "{said}\nhelp: the reasons stand beside the marks; see whether each column holds the answers to its own part"
            )
        })
    }
}

impl AddAssign for Legibility {
    fn add_assign(&mut self, other: Self) {
        self.answered += other.answered;
        self.unread += other.unread;
        self.of_marks += other.of_marks;
    }
}
