//! A block of equations that must be solved together.

use crate::{Statement, System};
use momentous_expr::{Expr, Symbol};

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
            && term.substitute(&value).simplify().is_zero()
    }

    /// Whether a symbol stands for positive values only.
    pub(super) fn positive(&self, symbol: Symbol) -> bool {
        self.system.positive.contains(&symbol)
    }
}
