//! Readings of answers, in words, before anybody judges them.

use momentous_expr::{Leaf, LeafKind, Math};
use momentous_grade as grade;
use momentous_grade::Answer;
use momentous_grade::DecimalMark;
use momentous_grade::Reading;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Worked;

use super::Exercise;
use super::ROOTS_JOINED;
use super::marker::Blank;
use super::rules::Rules;

/// The reading of an answer to a part, or why it cannot be read; none where there is no answer. Where several values are asked,
/// each is read by itself, in the order in which they were typed. The right answer is not looked at.
pub(super) fn echo(worked: Worked<'_>, part: &Part, text: &str, mark: DecimalMark) -> Option<Result<String, String>> {
    let blank = Blank::new(Rules { problem: worked.problem, form: worked.form }, part);
    let asked = blank.expected(worked);
    let read = |text: &str| {
        let Reading { answer, told } = Reading::of(text, &asked.kind, mark)?;
        Some(if answer.is_ok() { Ok(told) } else { Err(told) })
    };
    let values = values(worked, part, text);
    let values: Option<Result<Vec<String>, String>> = values.iter().map(|value| read(value)).collect();
    values.map(|read| read.map(|values| values.join(ROOTS_JOINED)))
}

/// The values in an answer to a part: where several are asked, each as a text of its own.
pub(super) fn values(worked: Worked<'_>, part: &Part, text: &str) -> Vec<String> {
    let values = match &part.kind {
        PartKind::Number(number) if number.every_root || worked.variant.has_others() => grade::read_several(text),
        _ => Vec::new(),
    };
    if values.len() < 2 { vec![text.to_owned()] } else { values }
}

impl Exercise {
    /// The reading of an answer to a part, in words, or why it cannot be read; none where there is no answer. The right answer is
    /// not looked at.
    #[must_use]
    pub fn echo(&self, part: &Part, text: &str, mark: DecimalMark) -> Option<Result<String, String>> {
        echo(self.worked(), part, text, mark)
    }

    /// An answer that is a formula, as mathematics in the letters of the sheet; nothing where the part asks for something else, or the
    /// answer cannot be read. The right answer is not looked at.
    #[must_use]
    pub fn typeset(&self, part: &Part, text: &str, mark: DecimalMark) -> Option<Math> {
        if !matches!(part.kind, PartKind::Formula(_)) {
            return None;
        }
        let worked = self.worked();
        let asked = Blank::new(Rules { problem: worked.problem, form: worked.form }, part).expected(worked);
        let Ok(Answer::Formula(read)) = Reading::of(text, &asked.kind, mark)?.answer else { return None };
        Some(read.formula.layout(&|letter| Leaf { math: worked.problem.math_of(letter), kind: LeafKind::Name }))
    }
}
