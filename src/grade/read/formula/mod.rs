//! A formula in the symbols of the sheet, in plain text, Unicode or LaTeX, with or without signs of multiplication.
//!
//! Characters become tokens (`lexer`), words become names and functions (`resolve`), and tokens become a term (`grammar`).

mod applied;
mod grammar;
mod latex;
mod lexer;
mod named;
mod names;
mod resolve;
mod signs;
mod token;
mod word;

use crate::expr::Symbol;

use super::super::expected::ExpectedFormula;
use super::answer::FormulaAnswer;
use super::numeral::DecimalMark;
use super::unreadable::{Unreadable, UnreadableKind};
use grammar::Grammar;
use names::Names;
use token::Token;

/// The longest formula that is read, in characters.
pub const MAX_FORMULA: usize = 1000;
/// How deeply brackets, functions and powers may be nested.
const MAX_DEPTH: usize = 24;

/// Reads a formula.
pub(super) fn read(answer: &str, asked: &ExpectedFormula, mark: DecimalMark) -> Result<FormulaAnswer, Unreadable> {
    if answer.len() > MAX_FORMULA && answer.chars().nth(MAX_FORMULA).is_some() {
        return Err(Unreadable { at: MAX_FORMULA, kind: UnreadableKind::TooLong(MAX_FORMULA) });
    }
    let fault = |(at, kind)| Unreadable { at, kind };
    let names = Names::new(asked);
    let lexemes = lexer::lexemes(answer, mark, names.has_own_e()).map_err(fault)?;
    let lexemes = resolve::resolve(lexemes, &names).map_err(fault)?;
    let end = answer.trim_end().chars().count();
    let formula = Grammar::new(&lexemes, end, asked).whole().map_err(fault)?;
    let decimal = lexemes.iter().any(|own| matches!(own.token, Token::Number { decimal: true, .. }));
    Ok(FormulaAnswer { text: formula.text(&asked.symbols), formula, decimal })
}

/// The symbols that a formula may contain.
fn allowed(asked: &ExpectedFormula) -> impl Iterator<Item = Symbol> + '_ {
    asked.domain.iter().map(|(symbol, ..)| *symbol).chain(asked.values.iter().map(|(symbol, _)| *symbol))
}
