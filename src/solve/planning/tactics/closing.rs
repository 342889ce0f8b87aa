//! The outcome of a tactic on a block: its roots with the moves that lead to them, or why it does not serve.

use crate::{Closed, Move, Root};
use momentous_expr::{Expr, Symbol};

/// The roots of a block, with the moves that lead to them.
#[derive(Clone, Debug)]
pub(super) struct Closing {
    /// The unknowns in the order in which they are found.
    pub(super) unknowns: Vec<Symbol>,
    /// The moves on paper.
    pub(super) moves: Vec<Move>,
    /// The roots.
    pub(super) roots: Vec<Root>,
}

/// Every value of one unknown, and the moves that give them.
pub(super) struct ValuesOfUnknown {
    pub(super) moves: Vec<Move>,
    pub(super) values: Vec<Expr>,
}

impl ValuesOfUnknown {
    /// Closes a block of this unknown alone.
    pub(super) fn closing(self, unknown: Symbol) -> Closing {
        let root = |value| Root { values: vec![(unknown, Closed::Formula(value))] };
        Closing { unknowns: vec![unknown], moves: self.moves, roots: self.values.into_iter().map(root).collect() }
    }
}

/// Why a tactic does not close a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::planning) enum Refusal {
    /// It is not for blocks of this kind.
    NotApplicable,
    /// The equations say the same twice, so that they do not determine the unknowns.
    Dependent,
    /// The unknowns drop out, and what is left is false.
    Contradiction,
}
