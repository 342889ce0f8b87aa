//! The drawing of a stage in its diagram of momenta and impulses, as far as no number changes it.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_figure::Form;

use super::participants::Participant;

/// The diagram of a stage, as far as no number changes it.
pub(super) struct Plan {
    pub(super) rows: Vec<Planned>,
    /// The quantities that the arrows of a body that takes part alone need besides.
    pub(super) besides: Option<Besides>,
}

/// The row of a body.
pub(super) struct Planned {
    pub(super) participant: Participant,
    pub(super) name: Math,
    pub(super) form: Form,
    /// The notation of its momentum before and after, and each impulse on it.
    pub(super) before: Math,
    pub(super) after: Math,
    pub(super) impulses: Vec<Math>,
}

/// Values to be added to those of a solution.
pub(super) struct Besides {
    /// A mass that no value is needed of.
    pub(super) mass: Option<Symbol>,
    /// Further quantities, each by a formula in what is there before it.
    pub(super) formulas: Vec<(Symbol, Expr)>,
}
