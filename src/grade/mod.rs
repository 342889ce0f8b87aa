//! Marking: what a student typed is read generously ([`read()`]), judged exactly ([`judge()`]) and answered usefully ([`Report`]).
//!
//! The three stand apart. Reading knows no right value, so nothing can be read "towards" it; judging knows no text;
//! reporting knows only verdicts and the rubric.

mod expected;
pub mod judge;
mod messages;
mod number;
pub mod read;
pub mod report;
mod rubric;
mod statistics;
mod verdict;

pub use expected::{Expected, ExpectedKind, ExpectedNumber, Tolerance};
pub use judge::{Judgement, judge};
pub use messages::Message;
pub use number::Number;
pub use read::{Answer, DecimalMark, Unreadable, UnreadableKind, read};
pub use report::{InputFault, PartReport, Points, Report, grade};
pub use rubric::Rubric;
pub use statistics::{Gathering, Item, ItemStatistics, Statistics, VerdictCount};
pub use verdict::Verdict;
