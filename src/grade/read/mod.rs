//! Reading: one grammar for all that students type. What cannot be read is told, with its place, and never marked.

mod answer;
mod arithmetic;
mod choice;
mod direction;
mod functions;
mod numeral;
mod plain;
mod quantity;
mod unreadable;

pub use answer::{Answer, ChoiceAnswer, NumberAnswer, Sense, Written};
pub use numeral::DecimalMark;
pub use unreadable::{Unreadable, UnreadableKind};

use super::expected::ExpectedKind;

/// The longest answer that is read, in characters.
pub const MAX_LENGTH: usize = 200;

/// Reads what a student typed as an answer to this part.
///
/// Of the part only its form is looked at: the unit and direction words, or the options; never the right value.
///
/// ```
/// use momentous::grade::{DecimalMark, ExpectedKind, read};
/// let options = vec!["conserved".to_owned(), "not conserved".to_owned()];
/// let asked = ExpectedKind::Choice { options, right: 0, because: String::new() };
/// assert_eq!(read("(b)", &asked, DecimalMark::Point)?.echo(), "not conserved");
/// let fault = read("maybe", &asked, DecimalMark::Point).unwrap_err();
/// assert_eq!(fault.kind.code(), "no_option");
/// # Ok::<(), momentous::grade::Unreadable>(())
/// ```
///
/// # Errors
/// Where the text cannot be read, or in two ways; the fault says where and what to write instead.
pub fn read(text: &str, asked: &ExpectedKind, mark: DecimalMark) -> Result<Answer, Unreadable> {
    match asked {
        ExpectedKind::Number(number) => {
            quantity::read(text, number.senses.as_ref(), &number.unit, mark).map(Answer::Number)
        }
        ExpectedKind::Choice { options, .. } => choice::read(text, options).map(Answer::Choice),
    }
}
