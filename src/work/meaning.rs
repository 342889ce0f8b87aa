//! The meanings of the numbers in a line: a number may be that of a given, a constant such as the 2 of a square, or computed from others.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::Worked;
use momentous_quantity::Dimension;

use momentous_grade::WrittenNumber;
use momentous_quantity::coherent_unit;

use super::written::Written;

/// The most sets of meanings that are tried for a line.
const MOST: usize = 96;

/// The meaning of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    /// The value of a given, or its negative where the sign is written before it.
    Given {
        /// The given.
        symbol: Symbol,
        /// Whether the given has the opposite sign.
        reversed: bool,
    },
    /// Itself, in every variant.
    Constant,
    /// A value that was worked out, perhaps rounded.
    Computed,
}

/// The meanings of the numbers of a line; a number that is not in it is computed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Meanings(BTreeMap<Symbol, Meaning>);

impl Meanings {
    /// The meaning of one number.
    pub(crate) fn of(&self, symbol: Symbol) -> Meaning {
        self.0.get(&symbol).copied().unwrap_or(Meaning::Computed)
    }

    /// Whether a number is that of a given.
    pub(crate) fn is_given(&self, symbol: Symbol) -> bool {
        matches!(self.of(symbol), Meaning::Given { .. })
    }

    /// Whether no number was worked out.
    pub(crate) fn is_general(&self, line: &Written) -> bool {
        line.numbers.iter().all(|number| self.of(number.symbol) != Meaning::Computed)
    }

    /// A side with its numbers as what they stand for.
    pub(crate) fn put_into(&self, line: &Written, side: &Expr) -> Expr {
        side.substitute(&|symbol| {
            let number = line.number(symbol)?;
            match self.of(symbol) {
                Meaning::Given { symbol, reversed: false } => Some(symbol.into()),
                Meaning::Given { symbol, reversed: true } => Some(-Expr::from(symbol)),
                Meaning::Constant => Some(Expr::Number(number.value.clone())),
                Meaning::Computed => None,
            }
        })
    }
}

/// The sets of meanings that the numbers of a line may have, those with the fewest computed numbers first. In a line in symbols a
/// bare whole number is no result.
pub(crate) fn meanings(line: &Written, worked: Worked<'_>) -> Vec<Meanings> {
    let in_symbols = line.is_in_symbols();
    let choices: Vec<(Symbol, Vec<Meaning>)> =
        line.numbers.iter().map(|number| (number.symbol, choices(number, worked, in_symbols))).collect();
    // However many numbers there are, they may all be constants, or all be given.
    let each = |first: &dyn Fn(&[Meaning]) -> Option<Meaning>| {
        let set = choices.iter().filter_map(|(symbol, meanings)| Some((*symbol, first(meanings)?)));
        Meanings(set.collect())
    };
    let constants =
        each(&|meanings| meanings.iter().find(|meaning| **meaning == Meaning::Constant).or(meanings.first()).copied());
    let givens = each(&|meanings| meanings.first().copied());
    let mut sets = vec![Meanings::default()];
    for (symbol, choices) in &choices {
        let longer = |set: &Meanings| {
            let with = |choice: &Meaning| {
                let mut longer = set.clone();
                longer.0.insert(*symbol, *choice);
                longer
            };
            choices.iter().map(with).collect::<Vec<_>>()
        };
        sets = sets.iter().flat_map(longer).take(MOST).collect();
    }
    sets.extend([constants, givens]);
    let computed = |set: &Meanings| set.0.values().filter(|meaning| **meaning == Meaning::Computed).count();
    sets.sort_by_key(computed);
    sets.dedup();
    sets
}

fn choices(number: &WrittenNumber, worked: Worked<'_>, in_symbols: bool) -> Vec<Meaning> {
    let mut choices: Vec<Meaning> = worked
        .form
        .told
        .iter()
        .flat_map(|symbol| [false, true].map(|reversed| (*symbol, reversed)))
        .filter(|(symbol, reversed)| is_given(number, worked, *symbol, *reversed))
        .map(|(symbol, reversed)| Meaning::Given { symbol, reversed })
        .collect();
    let is_bare = number.unit.is_none();
    if is_bare || number.value.is_zero() {
        choices.push(Meaning::Constant);
    }
    if !(number.value.is_zero() || is_bare && in_symbols && number.value.is_int()) {
        choices.push(Meaning::Computed);
    }
    choices
}

/// Whether a number is written as the value of a given, in its unit or a bare number in that of the sheet.
fn is_given(number: &WrittenNumber, worked: Worked<'_>, symbol: Symbol, reversed: bool) -> bool {
    let written = if reversed { -number.value.clone() } else { number.value.clone() };
    if written.is_zero() {
        return false;
    }
    let model = worked.problem.model();
    let literal = || {
        model
            .literals
            .iter()
            .find(|(literal, _)| *literal == symbol)
            .map(|(_, quantity)| (quantity.value.clone(), quantity.unit.clone()))
    };
    let Some((value, unit)) = worked.variant.given(symbol).or_else(literal) else { return false };
    let value = value.to_rational();
    let dimension = model.symbols.entry(symbol).dimension;
    match &number.unit {
        Some(written_unit) => {
            written_unit.dimension() == dimension
                && written_unit.factor().pi == unit.factor().pi
                && written * written_unit.factor().rational == value * unit.factor().rational
        }
        None if written == value => true,
        None => {
            let coherent = coherent_unit(dimension, worked.problem.units()).factor();
            dimension != Dimension::NONE
                && unit.factor().pi == 0
                && written * coherent.rational == value * unit.factor().rational
        }
    }
}
