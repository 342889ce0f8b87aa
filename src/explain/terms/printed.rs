//! Answers as they are printed: numbers, vectors, formulas and intervals, each with its unit.

use std::sync::Arc;

use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_problem::End;
use momentous_problem::FormulaPart;
use momentous_problem::Interval;
use momentous_problem::NumberPart;
use momentous_problem::RangePart;
use momentous_problem::VectorPart;
use momentous_problem::Worked;
use momentous_quantity::coherent_unit;
use momentous_solve::Bounded;

use super::super::Inline;
use super::algebra::positive_first;
use super::display::Display;
use super::display::number_math;
use super::display::printed;
use super::display::with_unit;

/// A value to the figures that are asked.
pub(crate) fn shown(number: &NumberPart, value: f64) -> Math {
    if number.whole {
        return Math::Number(format!("{value:.0}"));
    }
    number_math(printed(value, number.figures))
}

/// An answer as it is printed, with its unit.
pub(crate) fn answer(display: Display<'_>, number: &NumberPart, answer: Bounded) -> Math {
    let shown = |value: f64| shown(number, value);
    match &number.unit {
        AskedUnit::Unit(_) => display.in_unit_of(number, shown(answer.for_print())),
        AskedUnit::InTermsOf(..) if answer.is_zero() => shown(0.0),
        AskedUnit::InTermsOf(symbol, unit) if unit.is_none() => multiple(display, shown(answer.for_print()), *symbol),
        AskedUnit::InTermsOf(symbol, unit) => {
            let number = Math::Bracketed(Arc::new(with_unit(shown(answer.for_print()), unit)));
            multiple(display, number, *symbol)
        }
    }
}

/// A multiple of a quantity.
pub(crate) fn multiple(display: Display<'_>, number: Math, symbol: Symbol) -> Math {
    Math::Row(vec![number, Math::Operator(Operator::Juxtapose), display.name(symbol)])
}

/// A multiple that has a unit, as papers print it: `6 m` in newton seconds, with m in kilograms.
pub(crate) fn as_taught(display: Display<'_>, number: &NumberPart) -> Vec<Inline> {
    let AskedUnit::InTermsOf(symbol, unit) = &number.unit else { return Vec::new() };
    let answer = display.worked.answer(number);
    if unit.is_none() || answer.is_zero() {
        return Vec::new();
    }
    let problem = display.worked.problem;
    let unit_of = |symbol: Symbol| coherent_unit(problem.model().symbols.entry(symbol).dimension, problem.units());
    vec![
        Inline::Text(" (".into()),
        Inline::Math(multiple(display, shown(number, answer.for_print()), *symbol)),
        Inline::Text(format!(" in {}, with ", unit_of(number.symbol).unicode())),
        Inline::Math(display.name(*symbol)),
        Inline::Text(format!(" in {})", unit_of(*symbol).unicode())),
    ]
}

/// A formula as it is printed.
pub(crate) fn formula(display: Display<'_>, part: &FormulaPart) -> Option<Math> {
    let formula = display.worked.formula(part)?;
    Some(display.symbolic(&positive_first(&formula)))
}

/// A vector as it is printed: its components in brackets, and their unit.
#[must_use]
pub fn printed_vector(worked: Worked<'_>, vector: &VectorPart) -> Math {
    let mut row = Vec::new();
    for (index, number) in vector.components.iter().enumerate() {
        row.extend((index > 0).then(|| Math::Text(",\u{a0}".into())));
        row.push(shown(number, worked.answer(number).for_print()));
    }
    let bracketed = Math::Bracketed(Arc::new(Math::Row(row)));
    match vector.components.first().map(|first| &first.unit) {
        Some(AskedUnit::Unit(unit)) => with_unit(bracketed, unit),
        Some(AskedUnit::InTermsOf(symbol, _)) => {
            let name = worked.problem.math_of(*symbol);
            Math::Row(vec![bracketed, Math::Operator(Operator::Juxtapose), name])
        }
        None => bracketed,
    }
}

/// An interval as it is printed: `0.25 < e <= 1`; nothing where a variant has none.
#[must_use]
pub fn printed_range(worked: Worked<'_>, range: &RangePart) -> Option<Math> {
    let name = worked.problem.math_of(range.number.symbol);
    Some(chain(range, name, &worked.interval(range)?))
}

/// An interval with the name of its quantity.
pub(crate) fn chain(range: &RangePart, name: Math, interval: &Interval) -> Math {
    let value = |end: &End| {
        let value = end.value.for_print();
        let number = if end.is_limit { Math::Number(value.to_string()) } else { shown(&range.number, value) };
        with_unit(number, &range.number.plain_unit())
    };
    let below = |end: &End| Math::Operator(if end.closed { Operator::AtMost } else { Operator::Less });
    match (&interval.low, &interval.high) {
        (Some(low), None) => {
            Math::relation(name, if low.closed { Operator::AtLeast } else { Operator::Greater }, value(low))
        }
        (low, high) => {
            let mut row = low.iter().flat_map(|low| [value(low), below(low)]).collect::<Vec<_>>();
            row.push(name);
            row.extend(high.iter().flat_map(|high| [below(high), value(high)]));
            Math::Row(row)
        }
    }
}
