//! The fate of the rows of a file of submissions.

use std::fmt;
use std::ops::AddAssign;

use serde::Serialize;

/// How many rows there were, each marked or refused.
///
/// ```
/// use momentous_grade::RowCounts;
/// let counts = RowCounts { read: 3, marked: 2, answers: 6, refused: 1, not_issued: 1 };
/// assert_eq!(counts.to_string(), "3 rows read: 2 marked (6 answers), 1 refused; 1 of the marked rows belongs to a sheet that was not issued");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RowCounts {
    /// Rows that stood in the file, of whatever kind.
    pub read: u64,
    /// Rows that have marks.
    pub marked: u64,
    /// Parts that were marked in them.
    pub answers: u64,
    /// Rows that could not be used.
    pub refused: u64,
    /// Rows, of the marked, that answer a sheet which the student was not given.
    pub not_issued: u64,
}

impl RowCounts {
    /// Whether every row that was read was marked or refused.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.marked + self.refused == self.read
    }
}

impl AddAssign for RowCounts {
    fn add_assign(&mut self, other: Self) {
        self.read += other.read;
        self.marked += other.marked;
        self.answers += other.answers;
        self.refused += other.refused;
        self.not_issued += other.not_issued;
    }
}

impl fmt::Display for RowCounts {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { read, marked, answers, refused, not_issued } = self;
        let counted = |count: &u64, what: &str| format!("{count} {what}{}", if *count == 1 { "" } else { "s" });
        let (rows, answers) = (counted(read, "row"), counted(answers, "answer"));
        write!(out, "{rows} read: {marked} marked ({answers}), {refused} refused")?;
        match not_issued {
            0 => Ok(()),
            1 => out.write_str("; 1 of the marked rows belongs to a sheet that was not issued"),
            _ => write!(out, "; {not_issued} of the marked rows belong to sheets that were not issued"),
        }
    }
}
