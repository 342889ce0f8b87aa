//! # Isolate
//!
//! *Closes:* one equation whose only unknown is linear in it, or is written once; also one given piece by piece, where a
//! single piece depends on the unknown; a product that is one power of a positive unknown.
//!
//! *On paper:* bring the unknown to one side: `m v2 = m v1 + J` gives `v2 = v1 + J / m`.
//!
//! *Refuses:* an unknown of second degree together with its first power, and one inside and outside a function.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::block::Block;
use super::closing::{Closing, Refusal, ValuesOfUnknown};
use super::inverse::undo;
use super::tidy::{
    cancelled, cancelled_where, difference, forward, is_negative, negative, occurrences, over, replaced,
};
use crate::Move;

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (equation, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let values = isolated(left, right, unknown, &|symbol| block.positive(symbol))?;
    let value = values.first().cloned().ok_or(Refusal::NotApplicable)?;
    let moves = vec![Move::Isolate { equation, unknown, value }];
    Ok(ValuesOfUnknown { moves, values }.closing(unknown))
}

/// Every value of `unknown` for which the sides are equal, where it can be brought to one side.
pub(super) fn isolated(
    left: &Expr,
    right: &Expr,
    unknown: Symbol,
    positive: &dyn Fn(Symbol) -> bool,
) -> Result<Vec<Expr>, Refusal> {
    if *left == Expr::Symbol(unknown) && !right.contains(unknown) {
        return Ok(vec![right.clone()]);
    }
    if *right == Expr::Symbol(unknown) && !left.contains(unknown) {
        return Ok(vec![left.clone()]);
    }
    let residual = difference(left, right);
    if let Some((coefficients, rest)) = residual.linear_coefficients(&[unknown])
        && let Some(coefficient) = coefficients.into_iter().next()
    {
        return linear_root(&coefficient, &rest).map(|value| vec![value]);
    }
    let once = |side: &Expr, other: &Expr| occurrences(side, unknown) == 1 && !other.contains(unknown);
    let values = if once(left, right) {
        undo(left, right.clone(), unknown, positive)
    } else if once(right, left) {
        undo(right, left.clone(), unknown, positive)
    } else {
        None
    };
    let values = values.or_else(|| pure_power(&residual, unknown, positive));
    let values = values.or_else(|| one_power(left, right, unknown, positive));
    let values = values.or_else(|| one_power(right, left, unknown, positive));
    let values = values.or_else(|| in_one_piece(&residual, unknown).map(|value| vec![value]));
    let values = values.ok_or(Refusal::NotApplicable)?;
    Ok(values.into_iter().map(|value| cancelled_where(value, positive)).collect())
}

/// The root of `coefficient x + rest`.
pub(super) fn linear_root(coefficient: &Expr, rest: &Expr) -> Result<Expr, Refusal> {
    if coefficient.is_zero() {
        return Err(dropped_out(rest));
    }
    let minus = is_negative(coefficient);
    let value = if minus { over(rest, &negative(coefficient)) } else { over(&negative(rest), coefficient) };
    Ok(forward(cancelled(value)))
}

/// Judges an equation from which the unknown drops out.
pub(super) fn dropped_out(rest: &Expr) -> Refusal {
    match rest.simplify().as_number() {
        Some(value) if !value.is_zero() => Refusal::Contradiction,
        _ => Refusal::Dependent,
    }
}

/// The root of a term given piece by piece where one piece only depends on the unknown, and is linear in it: a push that
/// grows and then stays the same. Whether the root lies within its piece, the equation itself tells.
fn in_one_piece(residual: &Expr, unknown: Symbol) -> Option<Expr> {
    let mut pieces = Vec::new();
    let whole = piecewise_in(residual, unknown)?;
    let Expr::Piecewise(piecewise) = whole else { return None };
    for (_, piece) in &piecewise.pieces {
        let rest = replaced(residual, whole, piece);
        if rest.contains(unknown) {
            pieces.push(rest);
        }
    }
    let [only] = &pieces[..] else { return None };
    let (coefficients, rest) = only.linear_coefficients(&[unknown])?;
    linear_root(coefficients.first()?, &rest).ok()
}

/// A function within a term that is given piece by piece and in which the unknown stands.
fn piecewise_in(term: &Expr, unknown: Symbol) -> Option<&Expr> {
    match term {
        Expr::Piecewise(_) => term.contains(unknown).then_some(term),
        other => other.children().find_map(|part| piecewise_in(part, unknown)),
    }
}

/// The root of `c x^p = d` for a positive unknown that is written several times: `x sqrt(x/a) = d`.
fn one_power(side: &Expr, other: &Expr, unknown: Symbol, positive: &dyn Fn(Symbol) -> bool) -> Option<Vec<Expr>> {
    if !positive(unknown) || other.contains(unknown) {
        return None;
    }
    let (power, coefficient) = as_power(side, unknown).filter(|(power, _)| !power.is_zero())?;
    Some(vec![over(other, &coefficient).power(Expr::Number(Rational::ONE / power))])
}

/// A product as a power of an unknown that is positive, and what it is multiplied by.
fn as_power(term: &Expr, unknown: Symbol) -> Option<(Rational, Expr)> {
    match term {
        term if !term.contains(unknown) => Some((Rational::ZERO, term.clone())),
        Expr::Symbol(_) => Some((Rational::ONE, Expr::one())),
        Expr::Product(factors) => {
            let parts: Option<Vec<(Rational, Expr)>> = factors.iter().map(|factor| as_power(factor, unknown)).collect();
            let (powers, coefficients): (Vec<Rational>, Vec<Expr>) = parts?.into_iter().unzip();
            Some((powers.into_iter().fold(Rational::ZERO, |sum, power| sum + power), Expr::product(coefficients)))
        }
        Expr::Power(pair) => {
            let exponent = pair.1.as_number()?;
            let (power, coefficient) = as_power(&pair.0, unknown)?;
            Some((power * exponent, coefficient.power(pair.1.clone())))
        }
        _ => None,
    }
}

/// The roots of `a x^n + c` or `a x + c` after algebra.
fn pure_power(residual: &Expr, unknown: Symbol, positive: &dyn Fn(Symbol) -> bool) -> Option<Vec<Expr>> {
    let (coefficients, _) = residual.collect(unknown)?;
    let mut powers = (1..).zip(coefficients.iter().skip(1)).filter(|(_, coefficient)| !coefficient.is_zero());
    let (power, coefficient) = powers.next()?;
    if powers.next().is_some() {
        return None;
    }
    let value = over(&negative(coefficients.first()?), coefficient);
    undo(&Expr::Symbol(unknown).powi(power), value, unknown, positive)
}
