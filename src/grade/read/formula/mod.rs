//! A formula in the symbols of the sheet, in plain text, Unicode or LaTeX, with or without signs of multiplication.
//!
//! Characters become tokens (`lexer`), words become names and functions (`resolve`), and tokens become a term (`grammar`).

mod applied;
mod grammar;
mod latex;
mod lexer;
mod named;
mod names;
mod over;
mod resolve;
mod signs;
mod systems;
mod term;
mod token;
mod vocabulary;
mod word;

use momentous_expr::Expr;
use momentous_quantity::Rational;

use super::super::expected::ExpectedFormula;
use super::answer::FormulaAnswer;
use super::numeral::DecimalMark;
use super::unreadable::{Unreadable, UnreadableKind};
use grammar::Grammar;
use names::Names;
pub use term::{WrittenNumber, WrittenTerm, half_of_last_place, read_term};
use token::{Lexeme, Token};
use vocabulary::Vocabulary;
pub use vocabulary::{BehindBars, Letters, Manner};

/// The longest formula that is read, in characters.
pub const MAX_FORMULA: usize = 1000;
/// The most decimals that are taken for rounded numbers.
const MAX_DECIMALS: usize = 6;

/// The letters of a name, in every way in which they are written.
pub(super) fn spellings(name: &str) -> Vec<Vec<char>> {
    let mut spellings = names::letters(name);
    spellings.push(name.chars().filter(|sign| sign.is_alphanumeric()).collect());
    spellings
}

/// The character that is meant, on the line.
pub(super) fn lowered(character: char) -> char {
    signs::unlowered(character).unwrap_or_else(|| signs::plain(character))
}

/// Reads a formula.
pub(super) fn read(answer: &str, asked: &ExpectedFormula, mark: DecimalMark) -> Result<FormulaAnswer, Unreadable> {
    if answer.len() > MAX_FORMULA && answer.chars().nth(MAX_FORMULA).is_some() {
        return Err(Unreadable { at: MAX_FORMULA, kind: UnreadableKind::TooLong(MAX_FORMULA) });
    }
    let fault = |(at, kind)| Unreadable { at, kind };
    let vocabulary = Vocabulary::of(asked);
    let names = Names::new(&vocabulary);
    let lexemes = lexer::lexemes(answer, mark, names.has_own_e()).map_err(fault)?;
    let lexemes = resolve::resolve(lexemes, &names).map_err(fault)?;
    let end = answer.trim_end().chars().count();
    let formula = Grammar::new(&lexemes, end, &vocabulary).whole().map_err(fault)?;
    let shifted = shifted(&lexemes, end, &vocabulary);
    Ok(FormulaAnswer { text: formula.text(&asked.symbols), formula, shifted })
}

/// The formula with each decimal that may be rounded larger by half a unit of its last place.
fn shifted(lexemes: &[Lexeme], end: usize, vocabulary: &Vocabulary<'_>) -> Vec<Expr> {
    let places = lexemes.iter().enumerate().filter_map(|(place, lexeme)| match &lexeme.token {
        Token::Number { value, half: Some(half) } => Some((place, value + half)),
        _ => None,
    });
    let formula = |(place, value): (usize, Rational)| {
        let mut lexemes = lexemes.to_vec();
        lexemes.get_mut(place)?.token = Token::Number { value, half: None };
        Grammar::new(&lexemes, end, vocabulary).whole().ok()
    };
    places.take(MAX_DECIMALS).filter_map(formula).collect()
}
