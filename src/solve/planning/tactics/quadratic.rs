//! # Quadratic
//!
//! *Closes:* one equation of second degree in its unknown.
//!
//! *On paper:* `a x^2 + b x + c = 0`, and the formula.
//!
//! *Computes with:* the form of each root in which `-b` and the root of the discriminant do not cancel.
//! (Press et al., Numerical Recipes, 5.6.)

use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Piecewise;
use crate::expr::Symbol;

use super::tidy::{difference, negative};
use super::{Block, Closing, Refusal};
use crate::solve::{Closed, Move, Root};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (equation, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let solved = Quadratic::of(&difference(left, right), unknown).ok_or(Refusal::NotApplicable)?;
    let root = |value| Root { values: vec![(unknown, Closed::Formula(value))] };
    Ok(Closing {
        unknowns: vec![unknown],
        roots: solved.roots().into_iter().map(root).collect(),
        moves: vec![solved.into_move(equation, unknown)],
    })
}

/// `a x^2 + b x + c`, and the factor that cleared the denominators.
pub(super) struct Quadratic {
    factor: Expr,
    a: Expr,
    b: Expr,
    c: Expr,
}

impl Quadratic {
    /// The coefficients of a term that is of second degree in the unknown, once denominators are cleared.
    pub(super) fn of(residual: &Expr, unknown: Symbol) -> Option<Self> {
        let (mut coefficients, factor) = residual.collect(unknown)?;
        if coefficients.len() != 3 {
            return None;
        }
        let (a, b, c) = (coefficients.pop()?, coefficients.pop()?, coefficients.pop()?);
        Some(Self { factor, a, b, c })
    }

    pub(super) fn into_move(self, equation: usize, unknown: Symbol) -> Move {
        let Self { factor, a, b, c } = self;
        Move::Quadratic { equation, factor, unknown, a, b, c }
    }

    /// Both roots: the one with plus before the square root, then the one with minus.
    pub(super) fn roots(&self) -> Vec<Expr> {
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
