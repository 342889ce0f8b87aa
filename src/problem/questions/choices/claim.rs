//! Claims about the numbers of a variant.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_solve::Relation;

/// A claim about the numbers of a variant.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The left side.
    pub left: Expr,
    /// How the sides are said to compare.
    pub relation: Relation,
    /// The right side.
    pub right: Expr,
    /// The sides in words.
    pub words: [String; 2],
    /// Whether two directions are said to be equal or not: a whole turn more is the same direction.
    pub is_of_directions: bool,
    /// The quantities that are compared, to be solved; numbers with units are none.
    pub quantities: Vec<Symbol>,
}

/// The share of its terms below which a difference is zero.
const EQUAL: f64 = 1e-12;

/// How two numbers compare; `None` where one of them is none.
fn compared(left: f64, right: f64) -> Option<Ordering> {
    let is_near = (left - right).abs() <= EQUAL * left.abs().max(right.abs());
    if is_near { Some(Ordering::Equal) } else { left.partial_cmp(&right) }
}

impl Claim {
    /// Everything that its sides contain.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.left.symbols().union(&self.right.symbols()).copied().collect()
    }

    /// The whole turns in a difference of its sides, which are none of it where these are directions.
    #[must_use]
    pub fn whole_turns(&self, difference: f64) -> f64 {
        if self.is_of_directions { TAU * (difference / TAU).round() } else { 0.0 }
    }

    /// Whether it holds where its sides have these values; `None` where one of them is no number.
    pub(crate) fn holds_between(&self, left: f64, right: f64) -> Option<bool> {
        compared(left, right).map(|order| self.allows(order))
    }

    /// Whether it holds where its sides compare so.
    pub(crate) fn allows(&self, order: Ordering) -> bool {
        match self.relation {
            Relation::Less => order.is_lt(),
            Relation::AtMost => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::AtLeast => order.is_ge(),
            Relation::Differs => order.is_ne(),
            Relation::Equals => order.is_eq(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearly_equal_is_equal() {
        assert_eq!(compared(1.0, 1.0 + 1e-15), Some(Ordering::Equal));
        assert_eq!(compared(1.0, 1.0 + 1e-9), Some(Ordering::Less));
        assert_eq!(compared(0.0, 0.0), Some(Ordering::Equal));
        assert_eq!(compared(f64::NAN, 0.0), None);
    }
}
