//! Reading: one grammar for all that students type. What cannot be read is told, with its place, and never marked.

mod answer;
mod arithmetic;
mod calculation;
mod choice;
mod comments;
mod components;
mod direction;
mod doubtful;
mod ending;
mod form;
mod formula;
mod functions;
mod hats;
mod heading;
mod interval;
mod latex;
mod mixed;
mod multiple;
mod numeral;
mod plain;
mod predicate;
mod quantity;
mod reasons;
mod remarks;
mod several;
mod unit;
mod unit_cache;
mod unit_vectors;
mod unreadable;
mod value;
mod vector;
mod vulgar;
mod wrapping;
mod yes_or_no;

pub use answer::{
    Answer, ChoiceAnswer, EndAnswer, FormulaAnswer, IntervalAnswer, NumberAnswer, Sense, VectorAnswer, Written,
};
pub(super) use ending::Endings;
pub use formula::{
    BehindBars, Letters, MAX_FORMULA, Manner, WrittenNumber, WrittenTerm, half_of_last_place, read_term,
};
pub use numeral::DecimalMark;
pub use plain::MAX_LENGTH;
pub use several::read_several;
pub use unreadable::{Unreadable, UnreadableKind};

use super::expected::ExpectedKind;

/// Reads what a student typed as an answer to this part.
///
/// Of the part only its form is looked at: the unit and direction words, or the options; never the right value.
///
/// ```
/// use momentous_grade::{DecimalMark, ExpectedKind, read};
/// let options = vec!["conserved".to_owned(), "not conserved".to_owned()];
/// let asked = ExpectedKind::Choice { question: String::new(), options, right: 0, because: String::new() };
/// assert_eq!(read("(b)", &asked, DecimalMark::Point)?.echo(), "not conserved");
/// let fault = read("maybe", &asked, DecimalMark::Point).unwrap_err();
/// assert_eq!(fault.kind.code(), "no_option");
/// # Ok::<(), momentous_grade::Unreadable>(())
/// ```
///
/// # Errors
/// Where the text cannot be read, or in two ways; the fault says where and what to write instead.
pub fn read(text: &str, asked: &ExpectedKind, mark: DecimalMark) -> Result<Answer, Unreadable> {
    let (before, text) = wrapping::unwrapped(text, asked);
    let answer = match asked {
        ExpectedKind::Number(number) => quantity::read(text, number, mark).map(Answer::Number),
        ExpectedKind::Vector(vector) => vector::read(text, vector, mark).map(Answer::Vector),
        ExpectedKind::Formula(formula) => formula::read(text, formula, mark).map(Answer::Formula),
        ExpectedKind::Interval(interval) => interval::read(text, interval, mark).map(Answer::Interval),
        ExpectedKind::Choice { question, options, .. } => choice::read(text, question, options).map(Answer::Choice),
    };
    answer.map_err(|fault| Unreadable { at: fault.at + before, ..fault })
}
