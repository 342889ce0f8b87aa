//! # Quadratic
//!
//! *Closes:* one equation of second degree in its unknown, or in the square of its unknown.
//!
//! *On paper:* `a x^2 + b x + c = 0`, and the formula.
//!
//! *Computes with:* the form of each root in which `-b` and the root of the discriminant do not cancel.
//! (Press et al., Numerical Recipes, 5.6.)

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Piecewise;
use momentous_expr::Symbol;

use super::block::Block;
use super::closing::{Closing, Refusal, ValuesOfUnknown};
use super::inverse::undo;
use super::tidy::{difference, is_negative, negative};
use crate::{Move, quadratic_formula};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (equation, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let positive = |symbol| block.positive(symbol);
    let roots = rooted(&difference(left, right), equation, unknown, &positive).ok_or(Refusal::NotApplicable)?;
    Ok(roots.closing(unknown))
}

/// The roots of an equation, all of it on one side, that is quadratic in the unknown or in its square.
pub(super) fn rooted(
    residual: &Expr,
    equation: usize,
    unknown: Symbol,
    positive: &dyn Fn(Symbol) -> bool,
) -> Option<ValuesOfUnknown> {
    let (coefficients, factor) = residual.collect(unknown)?;
    let coefficients = match <[Expr; 3]>::try_from(coefficients) {
        Ok([c, b, a]) => {
            let values = roots([&a, &b, &c]);
            return Some(ValuesOfUnknown {
                moves: vec![Move::Quadratic { equation, factor, unknown, a, b, c }],
                values,
            });
        }
        Err(others) => others,
    };
    let (factor, [a, b, c]) = of_square(factor, coefficients)?;
    let undone = |square| undo(&Expr::from(unknown).powi(2), square, unknown, positive);
    let values: Vec<Expr> = quadratic_formula([&a, &b, &c]).into_iter().filter_map(undone).flatten().collect();
    let value = values.first()?.clone();
    let moves = vec![
        Move::Biquadratic { equation, factor, unknown, coefficients: Box::new([a, b, c]) },
        Move::Isolate { equation, unknown, value },
    ];
    Some(ValuesOfUnknown { moves, values })
}

/// The coefficients of an equation of fourth degree without odd powers, the leading one not negative, and its factor.
fn of_square(factor: Expr, coefficients: Vec<Expr>) -> Option<(Expr, [Expr; 3])> {
    match <[Expr; 5]>::try_from(coefficients).ok()? {
        [c, first, b, third, a] if first.is_zero() && third.is_zero() && !c.is_zero() => {
            let minus = is_negative(&a);
            let turns = |term: Expr| if minus { negative(&term) } else { term };
            Some((turns(factor), [a, b, c].map(turns)))
        }
        _ => None,
    }
}

/// Both roots: the one with plus before the square root, then the one with minus.
fn roots([a, b, c]: [&Expr; 3]) -> Vec<Expr> {
    if c.is_zero() {
        return vec![Expr::zero(), super::tidy::over(&negative(b), a)];
    }
    let root = (b.clone().powi(2) - Expr::integer(4) * a.clone() * c.clone()).sqrt();
    let minus_b = negative(b);
    let textbook = |sum: Expr| sum / (Expr::integer(2) * a.clone());
    let stable = |sum: Expr| Expr::integer(2) * c.clone() / sum;
    let plus = Expr::sum([minus_b.clone(), root.clone()]);
    let minus = Expr::sum([minus_b, -root]);
    let chosen = |not_positive: Expr, positive: Expr| match b.as_number() {
        Some(value) if *value <= momentous_quantity::Rational::ZERO => not_positive,
        Some(_) => positive,
        None => Expr::Piecewise(Arc::new(Piecewise {
            variable: b.clone(),
            pieces: vec![(Some(Expr::zero()), not_positive), (None, positive)],
        })),
    };
    vec![chosen(textbook(plus.clone()), stable(minus.clone())), chosen(stable(plus), textbook(minus))]
}
