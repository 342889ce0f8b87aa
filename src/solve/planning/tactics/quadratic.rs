//! # Quadratic
//!
//! *Closes:* one equation of second degree in its unknown, or in the square of its unknown.
//!
//! *On paper:* `a x^2 + b x + c = 0`, and the formula.
//!
//! *Computes with:* the form of each root in which `-b` and the root of the discriminant do not cancel.
//! (Press et al., Numerical Recipes, 5.6.)

use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Piecewise;
use crate::expr::Symbol;

use super::inverse::undo;
use super::tidy::{difference, is_negative, negative};
use super::{Block, Closing, Found, Refusal};
use crate::solve::Move;

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (equation, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let positive = |symbol| block.positive(symbol);
    let found = rooted(&difference(left, right), equation, unknown, &positive).ok_or(Refusal::NotApplicable)?;
    Ok(found.closing(unknown))
}

/// The roots of an equation, all of it on one side, that is quadratic in the unknown or in its square.
pub(super) fn rooted(
    residual: &Expr,
    equation: usize,
    unknown: Symbol,
    positive: &dyn Fn(Symbol) -> bool,
) -> Option<Found> {
    if let Some(quadratic) = Quadratic::of(residual, unknown) {
        let values = quadratic.roots();
        return Some(Found { moves: vec![quadratic.into_move(equation, unknown)], values });
    }
    let quadratic = Quadratic::of_square(residual, unknown)?;
    let undone = |square| undo(&Expr::from(unknown).powi(2), square, unknown, positive);
    let values: Vec<Expr> = quadratic.taught().into_iter().filter_map(undone).flatten().collect();
    let value = values.first()?.clone();
    let Quadratic { factor, a, b, c } = quadratic;
    let moves = vec![
        Move::Biquadratic { equation, factor, unknown, coefficients: Box::new([a, b, c]) },
        Move::Isolate { equation, unknown, value },
    ];
    Some(Found { moves, values })
}

/// `a x^2 + b x + c`, and the factor that cleared the denominators.
struct Quadratic {
    factor: Expr,
    a: Expr,
    b: Expr,
    c: Expr,
}

impl Quadratic {
    /// The coefficients of a term that is of second degree in the unknown, once denominators are cleared.
    fn of(residual: &Expr, unknown: Symbol) -> Option<Self> {
        let (mut coefficients, factor) = residual.collect(unknown)?;
        if coefficients.len() != 3 {
            return None;
        }
        let (a, b, c) = (coefficients.pop()?, coefficients.pop()?, coefficients.pop()?);
        Some(Self { factor, a, b, c })
    }

    /// The coefficients of a term that is of second degree in the square of the unknown.
    fn of_square(residual: &Expr, unknown: Symbol) -> Option<Self> {
        let (coefficients, factor) = residual.collect(unknown)?;
        match <[Expr; 5]>::try_from(coefficients).ok()? {
            [c, first, b, third, a] if first.is_zero() && third.is_zero() && !c.is_zero() => {
                let turns = |term: Expr| if is_negative(&a) { negative(&term) } else { term };
                Some(Self { factor: turns(factor), b: turns(b), c: turns(c), a: turns(a.clone()) })
            }
            _ => None,
        }
    }

    /// Both roots as the formula is taught.
    fn taught(&self) -> [Expr; 2] {
        let Self { a, b, c, .. } = self;
        let root = (b.clone().powi(2) - Expr::integer(4) * a.clone() * c.clone()).sqrt();
        [root.clone(), -root].map(|root| Expr::sum([negative(b), root]) / (Expr::integer(2) * a.clone()))
    }

    fn into_move(self, equation: usize, unknown: Symbol) -> Move {
        let Self { factor, a, b, c } = self;
        Move::Quadratic { equation, factor, unknown, a, b, c }
    }

    /// Both roots: the one with plus before the square root, then the one with minus.
    fn roots(&self) -> Vec<Expr> {
        let (a, b, c) = (&self.a, &self.b, &self.c);
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
            Some(value) if *value <= crate::quantity::Rational::ZERO => not_positive,
            Some(_) => positive,
            None => Expr::Piecewise(Arc::new(Piecewise {
                variable: b.clone(),
                pieces: vec![(Some(Expr::zero()), not_positive), (None, positive)],
            })),
        };
        vec![chosen(textbook(plus.clone()), stable(minus.clone())), chosen(stable(plus), textbook(minus))]
    }
}
