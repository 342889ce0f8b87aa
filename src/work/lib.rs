//! The work, not only the answer: whether a line that a student writes follows from the scene, from which laws or from which mistake.
//!
//! Nothing is authored for it. The equations of a form's scene have many solutions, one for each variant; a line follows if it holds for
//! all of them (`holds.rs`), whatever its form. Its laws are the fewest equations whose slopes add up to its own
//! (`support.rs`). A line that does not follow is tried in the systems that come of usual mistakes (`wrong.rs`).
//! Numbers are read as what they stand for (`meaning.rs`): `2.0 * 3.0` as `m_A v_A1`.

mod aliases;
mod alphabet;
mod alternatives;
mod bare_units;
mod clash;
mod convention;
mod cross;
mod direction;
mod elsewhere;
mod equal_givens;
mod failing;
mod found;
mod ground;
mod holding;
mod holds;
mod integrals;
mod judge;
mod letters;
mod meaning;
mod message;
mod multiples;
mod naming;
mod next_step;
mod one_meaning;
mod own_letters;
mod phrases;
mod planning;
mod printing;
mod progress;
mod prose;
mod rates;
mod reader;
mod report;
mod result;
mod series;
mod setting;
mod sides;
mod spelling;
mod support;
mod together;
mod unread;
mod vectors;
mod verdict;
mod way;
mod written;
mod wrong;

pub use judge::{Judge, MOST_LINES};
pub use letters::{Letter, letters};
pub use report::{AnswerNeeded, JudgedLine, LawNeeded, NextStep, WorkReport};
pub use verdict::Verdict;

use momentous_grade::DecimalMark;
use momentous_problem::Worked;

/// The lines of a student's work that are judged: those that are not empty, up to [`MOST_LINES`].
pub fn lines(work: &str) -> impl Iterator<Item = &str> {
    work.lines().map(str::trim).filter(|line| !line.is_empty()).take(MOST_LINES)
}

/// Judges a student's work on a variant, line by line, and says what comes next; nothing where the lines hold all that the answers need.
#[must_use]
pub fn judge(worked: Worked<'_>, work: &str, mark: DecimalMark) -> (WorkReport, Option<NextStep>) {
    let mut judge = Judge::new(worked, mark);
    let judged = lines(work).map(|line| judge.line(line)).collect();
    judge.conclude(judged)
}
