//! Judging: an answer that was read against the exact value. It knows no text and no points.

mod angle;
mod closeness;
mod figures;
mod formula;
mod formula_cache;
mod interval;
mod judgement;
mod number;
mod proof;
mod slip;
mod vector;
mod windows;

use super::expected::{Expected, ExpectedKind};
use super::messages::Message;
use super::read::{Answer, ChoiceAnswer};
use super::verdict::Verdict;

pub use figures::too_few_figures;
pub use judgement::Judgement;
pub use windows::{BESIDE_A_WHOLE_NUMBER, VerdictWindow, brought_near, windows};

/// Judges an answer to a part.
#[must_use]
pub fn judge(expected: &Expected, answer: &Answer) -> Judgement {
    match (&expected.kind, answer) {
        (ExpectedKind::Number(number), Answer::Number(answer)) => number::judge(number, answer),
        (ExpectedKind::Vector(vector), Answer::Vector(answer)) => vector::judge(vector, answer),
        (ExpectedKind::Formula(formula), Answer::Formula(answer)) => {
            formula_cache::judged(formula, answer, || formula::judge(formula, answer))
        }
        (ExpectedKind::Interval(interval), Answer::Interval(answer)) => interval::judge(interval, answer),
        (ExpectedKind::Choice { right, because, .. }, Answer::Choice(answer)) => judge_choice(*right, because, answer),
        // Reading answers a part in its own kind; an answer of another kind is none to this part.
        _ => Judgement::of(Verdict::Wrong, Message::Wrong),
    }
}

fn judge_choice(right: usize, because: &str, answer: &ChoiceAnswer) -> Judgement {
    if answer.option == right {
        Judgement::of(Verdict::Right, Message::RightBecause(because.to_owned()))
    } else {
        Judgement::of(Verdict::ChoiceWrong, Message::ChoiceWrong)
    }
}
