//! A block of equations that must be solved together.

use crate::{Statement, System};
use momentous_expr::{Expr, Symbol};
use momentous_quantity::Rational;

use super::tidy;

/// An irreducible block: as many equations as unknowns, and all other symbols known.
#[derive(Clone, Debug)]
pub(in crate::planning) struct Block<'a> {
    /// The system.
    pub(crate) system: &'a System,
    /// Positions of the equations.
    pub(crate) equations: Vec<usize>,
    /// The unknowns; those that are asked for first.
    pub(crate) unknowns: Vec<Symbol>,
}

impl Block<'_> {
    /// The only equation and unknown of a block of one; position, left side, right side, unknown.
    pub(super) fn single(&self) -> Option<(usize, &Expr, &Expr, Symbol)> {
        let ([equation], [unknown]) = (self.equations.as_slice(), self.unknowns.as_slice()) else { return None };
        let (left, right) = self.sides(*equation)?;
        Some((*equation, left, right, *unknown))
    }

    /// The two sides of an equation that has two sides.
    pub(super) fn sides(&self, equation: usize) -> Option<(&Expr, &Expr)> {
        match &self.system.equations.get(equation)?.statement {
            Statement::Equal { left, right } => Some((left, right)),
            Statement::FirstInteger { .. } => None,
        }
    }

    /// Left sides minus right sides, in the order of the equations; `None` where one is a count.
    pub(super) fn residuals(&self) -> Option<Vec<Expr>> {
        let residual = |equation: &usize| self.sides(*equation).map(|(left, right)| tidy::difference(left, right));
        self.equations.iter().map(residual).collect()
    }

    /// Whether a term is zero for the values that are known beforehand.
    pub(super) fn vanishes(&self, term: &Expr) -> bool {
        let value = |symbol| self.system.values.get(&symbol).cloned();
        term.symbols().into_iter().any(|symbol| self.system.values.contains_key(&symbol))
            && is_nothing(&term.substitute(&value).simplify())
    }

    /// Whether a term has no value as it divides by what is zero for the values that are known beforehand.
    pub(super) fn divides_by_nothing(&self, term: &Expr) -> bool {
        let here = match term {
            Expr::Power(pair) => {
                pair.1.as_number().is_some_and(|power| *power < Rational::ZERO) && self.vanishes(&pair.0)
            }
            _ => false,
        };
        here || term.children().any(|part| self.divides_by_nothing(part))
    }

    /// Whether a symbol stands for positive values only.
    pub(super) fn positive(&self, symbol: Symbol) -> bool {
        self.system.positive.contains(&symbol)
    }
}

/// The part of its terms below which a sum of numbers is taken to be zero.
const ROUNDING: f64 = 1e-12;

/// Whether a term is zero, by algebra or, where it consists of numbers, by its value.
fn is_nothing(term: &Expr) -> bool {
    match term {
        Expr::Sum(terms) if term.symbols().is_empty() => {
            let value = |term: &Expr| term.evaluate(&|_| 0.0).abs();
            value(term) <= ROUNDING * terms.iter().map(value).sum::<f64>()
        }
        Expr::Product(factors) => factors.iter().any(is_nothing),
        other => other.is_zero(),
    }
}
