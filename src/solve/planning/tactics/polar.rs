//! # Polar
//!
//! *Closes:* two equations, linear in `R cos(theta)` and `R sin(theta)`, for R and theta.
//!
//! *On paper:* square and add for the magnitude, divide for the angle.
//!
//! *Takes:* the magnitude that is not negative. *Refuses:* R or theta standing anywhere else.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;

use super::block::Block;
use super::closing::{Closing, Refusal};
use super::tidy::{cancelled, factors, negative, over, terms};
use crate::{Closed, Move, Root};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let [first, second] = block.unknowns.as_slice() else { return Err(Refusal::NotApplicable) };
    let residuals = block.residuals().ok_or(Refusal::NotApplicable)?;
    let [one, two] = residuals.as_slice() else { return Err(Refusal::NotApplicable) };
    let read = |magnitude, angle| {
        Some((magnitude, angle, Components::of(one, magnitude, angle)?, Components::of(two, magnitude, angle)?))
    };
    let (magnitude, angle, one, two) =
        read(*first, *second).or_else(|| read(*second, *first)).ok_or(Refusal::NotApplicable)?;
    let (x, y) = solved(&one, &two).ok_or(Refusal::NotApplicable)?;
    let [first, second] = block.equations.as_slice() else { return Err(Refusal::NotApplicable) };
    let equations = if one.cosine.is_zero() { [*second, *first] } else { [*first, *second] };
    let length = Expr::sum([x.clone().powi(2), y.clone().powi(2)]).sqrt();
    let values = vec![(magnitude, Closed::Formula(length)), (angle, Closed::Formula(y.clone().atan2(x.clone())))];
    Ok(Closing {
        unknowns: vec![magnitude, angle],
        moves: vec![Move::Polar { equations, magnitude, angle, x, y }],
        roots: vec![Root { values }],
    })
}

/// `cosine R cos(theta) + sine R sin(theta) + rest`.
struct Components {
    cosine: Expr,
    sine: Expr,
    rest: Expr,
}

impl Components {
    fn of(residual: &Expr, magnitude: Symbol, angle: Symbol) -> Option<Self> {
        let part = |function| Expr::apply(function, Expr::Symbol(angle));
        let (mut cosine, mut sine, mut rest) = (Vec::new(), Vec::new(), Vec::new());
        for term in terms(residual) {
            if !term.contains(magnitude) && !term.contains(angle) {
                rest.push(term.clone());
                continue;
            }
            let involved = |factor: &&Expr| factor.contains(magnitude) || factor.contains(angle);
            let mut involving: Vec<&Expr> = factors(term).iter().filter(involved).collect();
            involving.sort();
            let coefficient = Expr::product(factors(term).iter().filter(|factor| !involved(factor)).cloned());
            let sum = |function, sum: &mut Vec<Expr>| {
                let is_polar = involving == [&Expr::Symbol(magnitude), &part(function)];
                if is_polar {
                    sum.push(coefficient.clone());
                }
                is_polar
            };
            if !sum(Function::Cos, &mut cosine) && !sum(Function::Sin, &mut sine) {
                return None;
            }
        }
        Some(Self { cosine: Expr::sum(cosine), sine: Expr::sum(sine), rest: Expr::sum(rest) })
    }
}

/// The two components, where the equations determine them.
fn solved(one: &Components, two: &Components) -> Option<(Expr, Expr)> {
    let share = |rest: &Expr, coefficient: &Expr| cancelled(over(&negative(rest), coefficient));
    if one.sine.is_zero() && two.cosine.is_zero() {
        return Some((share(&one.rest, &one.cosine), share(&two.rest, &two.sine)));
    }
    if one.cosine.is_zero() && two.sine.is_zero() {
        return Some((share(&two.rest, &two.cosine), share(&one.rest, &one.sine)));
    }
    let cross = |a: &Expr, b: &Expr, c: &Expr, d: &Expr| cancelled(a.clone() * b.clone() - c.clone() * d.clone());
    let determinant = cross(&one.cosine, &two.sine, &two.cosine, &one.sine);
    if momentous_expr::equal(&determinant, &Expr::zero()) {
        return None;
    }
    let x = over(&cross(&one.sine, &two.rest, &two.sine, &one.rest), &determinant);
    let y = over(&cross(&two.cosine, &one.rest, &one.cosine, &two.rest), &determinant);
    Some((cancelled(x), cancelled(y)))
}
