//! Two terms compared with the numbers of a variant, as closely as its data are told.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Model;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;
use momentous_quantity::half_unit;
use momentous_solve::Bounded;
use momentous_solve::Real;
use momentous_solve::evaluate;

use super::super::questions::equality::Equality;
use super::super::questions::equality::Sides;
use super::super::questions::equality::half_of_last_place;
use super::super::sampling::say;
use super::super::sampling::variant::Worked;

/// How close two values are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Closeness {
    /// Equal, exactly.
    Exact,
    /// Equal within the precision of the data.
    WithinData,
    /// Neither equal within the data nor clearly different.
    Between,
    /// Different.
    Apart,
}

/// The share of its larger term from which on a difference of two is one, whatever the precision of three figures.
const CLEAR: f64 = 0.5;

/// Figures of the values that a reason prints.
const FIGURES: usize = 4;

impl Closeness {
    /// Whether the values are taken as equal.
    #[must_use]
    pub fn is_equal(self) -> bool {
        matches!(self, Self::Exact | Self::WithinData)
    }
}

impl Equality {
    /// How close the terms are in a variant.
    pub(super) fn closeness(&self, worked: &Worked<'_>) -> Closeness {
        match self {
            Self::Always => Closeness::Exact,
            Self::Never => Closeness::Apart,
            Self::InNumbers(sides) => sides.closeness(worked),
        }
    }

    /// Both values, where they are compared as numbers: `222.8 J before and 222.7 J after`.
    pub(super) fn in_words(&self, worked: &Worked<'_>) -> Option<String> {
        let Self::InNumbers(sides) = self else { return None };
        if sides.terms[1].is_zero() {
            return None;
        }
        let model = worked.problem.model();
        let dimension = sides.terms.iter().find(|side| !side.is_zero())?.dimension(&model.symbols).ok()?;
        let unit = coherent_unit(dimension, worked.problem.units());
        let said = |side: &Expr| in_unit(worked, side, &unit);
        Some(format!("{} before and {} after", said(&sides.terms[0])?, said(&sides.terms[1])?))
    }
}

/// The value of a term in a unit, as a reason prints it.
pub(super) fn in_unit(worked: &Worked<'_>, term: &Expr, unit: &Unit) -> Option<String> {
    let value = evaluate(term, &|symbol| value_of(worked, symbol)).value / unit.factor().to_f64();
    Some(say::quantity(&Printed::new(value, FIGURES)?.to_decimal(), unit))
}

impl Worked<'_> {
    /// How close a difference is to zero, beside the precision of the data.
    #[must_use]
    pub fn closeness_to_zero(&self, difference: &Expr) -> Closeness {
        close(self, difference)
    }
}

impl Sides {
    fn closeness(&self, worked: &Worked<'_>) -> Closeness {
        let whole = self.terms[0].clone() - self.terms[1].clone();
        let Some((clock, moments)) = &self.clock else { return close(worked, &whole) };
        let at = |moment: &Expr| whole.substitute(&|symbol| (symbol == *clock).then(|| moment.clone()));
        // A law that is told for the stage alone has no value after it.
        let has_value = |term: &Expr| !term.evaluate(&|symbol| value_of(worked, symbol).value).is_nan();
        let terms = moments.iter().map(at).filter(has_value);
        terms.map(|term| close(worked, &term)).max().unwrap_or(Closeness::Apart)
    }
}

/// How close a difference is to zero.
fn close(worked: &Worked<'_>, whole: &Expr) -> Closeness {
    let sum: Bounded = evaluate(whole, &|symbol| value_of(worked, symbol));
    let size = sum.value.abs();
    if size <= sum.error {
        return Closeness::Exact;
    }
    // Where the difference is a good part of its terms, no datum of three figures makes up for it.
    let terms = if let Expr::Sum(terms) = whole { &terms[..] } else { &[] };
    let value = |term: &Expr| term.evaluate(&|symbol| value_of(worked, symbol).value).abs();
    let figures = worked.problem.loaded().draft.significant_figures();
    if figures >= 3 && terms.len() == 2 && size > CLEAR * terms.iter().map(value).fold(0.0, f64::max) {
        return Closeness::Apart;
    }
    let reach = reach(worked, whole);
    if size <= reach {
        Closeness::WithinData
    } else if size <= 2.0 * reach {
        Closeness::Between
    } else {
        Closeness::Apart
    }
}

fn value_of(worked: &Worked<'_>, symbol: Symbol) -> Bounded {
    worked.variant.value(symbol).unwrap_or_else(Bounded::not_real)
}

/// How far the precision of the data lets a difference be off: the sum of its slopes by what is given, each times half a unit of the
/// last place.
fn reach(worked: &Worked<'_>, whole: &Expr) -> f64 {
    let model = worked.problem.model();
    let figures = worked.problem.loaded().draft.significant_figures();
    let told: BTreeMap<Symbol, f64> = (worked.variant.all_given().iter())
        .map(|(symbol, value, unit)| (*symbol, half_of_last_place(value, unit, name(model, *symbol), figures)))
        .collect();
    let values = BTreeMap::new();
    let mut parts = BTreeMap::new();
    for symbol in whole.symbols().into_iter().filter(|symbol| !told.contains_key(symbol)) {
        parts.extend(worked.in_givens(symbol, &values).map(|formula| (symbol, formula)));
    }
    let written = whole.substitute(&|symbol| parts.get(&symbol).cloned());
    let value = |symbol: Symbol| value_of(worked, symbol).value;
    let half = |symbol: Symbol| told.get(&symbol).copied().unwrap_or_else(|| half_unit(value(symbol), figures));
    let moved = |symbol: Symbol| {
        let half = half(symbol);
        if half == 0.0 { 0.0 } else { written.differentiate(symbol).evaluate(&value).abs() * half }
    };
    let reach: f64 = written.symbols().into_iter().map(moved).sum();
    if reach.is_finite() { reach } else { 0.0 }
}

fn name(model: &Model, symbol: Symbol) -> &str {
    &model.symbols.entry(symbol).name
}
