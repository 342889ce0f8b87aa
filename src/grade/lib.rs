//! Marking: what a student typed is read generously ([`read()`]), judged exactly ([`judge()`]) and answered usefully ([`Report`]).
//!
//! The three stand apart. Reading knows no right value, so nothing can be read "towards" it; judging knows no text;
//! reporting knows only verdicts and the rubric.

pub mod catalogue;
pub mod diagnose;
mod expected;
mod follow;
mod frequent;
mod history;
pub mod judge;
mod marks;
mod messages;
mod number;
mod points;
pub mod read;
mod reading;
pub mod report;
mod rows;
mod rubric;
mod sitting;
mod statistics;
mod swapped;
mod verdict;

pub use diagnose::Diagnosis;
pub use expected::{
    Called, Expected, ExpectedEnd, ExpectedFormula, ExpectedInterval, ExpectedKind, ExpectedNumber, ExpectedVector,
    Frame, FrameAxis, Multiple, Reference, Units, Writing,
};
pub use follow::Follows;
pub use frequent::WrongAnswer;
pub use history::{History, Mark, PartHistory, Typed};
pub use judge::{BESIDE_A_WHOLE_NUMBER, Judgement, VerdictWindow, brought_near, judge, too_few_figures, windows};
pub use marks::Points;
pub use messages::Message;
pub use number::Number;
pub use read::{
    Answer, BehindBars, DecimalMark, FormulaAnswer, Letters, MAX_FORMULA, Manner, Unreadable, UnreadableKind,
    WrittenNumber, WrittenTerm, half_of_last_place, read, read_several, read_term,
};
pub use reading::{Reading, Readings};
pub use report::{Entry, InputFault, PartReport, Report, grade, grade_read, not_right, some_values};
pub use rows::RowCounts;
pub use rubric::{Attempts, FeedbackTime, HintsSeen, Keep, Rubric};
pub use sitting::Sitting;
pub use statistics::{Gathering, Item, ItemStatistics, MistakeCount, Statistics, VerdictCount};
pub use verdict::Verdict;
