//! Divisors of an equation on the way to a quantity: none of them may be zero.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::derivation::Line;

/// The factors by which a line is divided when it is solved for `unknown`, which then equals `value`: what stands below
/// a bar for the first time, and what was cancelled.
pub(crate) fn of_solution(lines: &[&Line], unknown: Symbol, value: &Expr) -> Vec<Expr> {
    let mut before = Vec::new();
    lines.iter().flat_map(|line| [&line.left, &line.right]).for_each(|side| add_denominators(side, &mut before));
    let mut factors = of_term(value);
    factors.retain(|factor| !before.contains(factor));
    if let [line] = lines
        && let Some((coefficients, _)) = (line.left.clone() - line.right.clone()).linear_coefficients(&[unknown])
        && let Some(coefficient) = coefficients.into_iter().next()
    {
        let cancelled = (coefficient / Expr::product(factors.iter().cloned())).simplify();
        add_factors(&cancelled, &mut factors);
    }
    factors
}

/// The factors of a coefficient by which an equation is divided.
pub(crate) fn of_coefficient(coefficient: &Expr) -> Vec<Expr> {
    let mut factors = Vec::new();
    add_factors(coefficient, &mut factors);
    factors
}

/// The factors that stand below a bar in a term.
pub(crate) fn of_term(term: &Expr) -> Vec<Expr> {
    let mut factors = Vec::new();
    add_denominators(term, &mut factors);
    factors
}

fn add_denominators(term: &Expr, factors: &mut Vec<Expr>) {
    if let Expr::Power(pair) = term
        && pair.1.as_number().is_some_and(|power| *power < Rational::ZERO)
    {
        add_factors(&pair.0, factors);
    }
    term.children().for_each(|part| add_denominators(part, factors));
}

/// The factors of a term above the bar, pure numbers left out.
fn add_factors(term: &Expr, divisors: &mut Vec<Expr>) {
    match term {
        Expr::Number(_) | Expr::Pi => {}
        Expr::Product(factors) => factors.iter().for_each(|factor| add_factors(factor, divisors)),
        Expr::Power(pair) if pair.1.as_number().is_some_and(|power| *power < Rational::ZERO) => {}
        Expr::Power(pair) => add_factors(&pair.0, divisors),
        other if divisors.contains(other) => {}
        other => divisors.push(other.clone()),
    }
}

/// Those of which it is not plain that they are positive, or negative.
pub(super) fn doubtful(factors: Vec<Expr>, positive: &BTreeSet<Symbol>) -> Vec<Expr> {
    let is_plain = |factor: &Expr| is_positive(factor, positive) || is_positive(&opposite(factor), positive);
    factors.into_iter().filter(|factor| !is_plain(factor)).collect()
}

fn opposite(term: &Expr) -> Expr {
    match term {
        Expr::Sum(parts) => Expr::sum(parts.iter().map(|part| (-part.clone()).simplify())),
        _ => (-term.clone()).simplify(),
    }
}

fn is_positive(term: &Expr, positive: &BTreeSet<Symbol>) -> bool {
    match term {
        Expr::Number(number) => *number > Rational::ZERO,
        Expr::Pi | Expr::Apply(Function::Exp, _) => true,
        Expr::Symbol(symbol) => positive.contains(symbol),
        Expr::Sum(parts) => {
            parts.iter().all(|part| is_positive(part, positive) || is_square(part, positive))
                && (parts.iter().any(|part| is_positive(part, positive)) || has_sine_and_cosine(parts))
        }
        Expr::Product(parts) => parts.iter().all(|part| is_positive(part, positive)),
        Expr::Power(pair) => is_positive(&pair.0, positive),
        Expr::Apply(..) | Expr::Piecewise(_) => false,
    }
}

/// Whether a term is a square times what is positive, so that it is not negative.
fn is_square(term: &Expr, positive: &BTreeSet<Symbol>) -> bool {
    match term {
        Expr::Product(parts) => parts.iter().all(|part| is_square(part, positive) || is_positive(part, positive)),
        Expr::Power(pair) => pair.1.as_number().is_some_and(|power| power.is_int() && (power.numerator() % 2_i8) == 0),
        _ => false,
    }
}

/// Whether the squares of the sine and of the cosine of one angle are among the terms: they are never both zero.
fn has_sine_and_cosine(parts: &[Expr]) -> bool {
    let squared = |function: Function| {
        let factors = parts.iter().flat_map(|part| match part {
            Expr::Product(factors) => factors.to_vec(),
            other => vec![other.clone()],
        });
        factors.filter_map(move |factor| match factor {
            Expr::Power(pair) => match &pair.0 {
                Expr::Apply(applied, angle) if *applied == function => Some(angle.to_vec()),
                _ => None,
            },
            _ => None,
        })
    };
    squared(Function::Sin).any(|angle| squared(Function::Cos).any(|other| other == angle))
}
