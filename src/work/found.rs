//! Findings on one line.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::support::Support;
use super::verdict::Verdict;
use super::wrong::Follows;

/// A line that is true, as what it says of the unknowns.
#[derive(Clone, Debug)]
pub(crate) struct Accepted {
    /// The differences of its sides, with its numbers in them.
    pub(crate) residuals: Vec<Expr>,
    /// The laws that it is made of: positions of the ground's equations.
    pub(crate) support: Support,
    /// The quantities of which it gives the value.
    pub(crate) answers: Vec<Symbol>,
    /// Whether it shows laws: it is more than a value that was found elsewhere.
    pub(crate) shows_laws: bool,
}

/// The finding on one reading of a line.
pub(crate) struct LineFinding {
    pub(crate) verdict: Verdict,
    pub(crate) support: Support,
    pub(crate) mistakes: Vec<Follows>,
    pub(crate) detail: String,
    /// Whether it is true of arrows, where the sheet has sizes under these names.
    pub(crate) is_of_arrows: bool,
    pub(crate) accepted: Option<Accepted>,
}

impl LineFinding {
    pub(crate) fn of(verdict: Verdict) -> Self {
        let (support, mistakes, detail) = (Support::default(), Vec::new(), String::new());
        Self { verdict, support, mistakes, detail, is_of_arrows: false, accepted: None }
    }

    pub(crate) fn because(self, detail: String) -> Self {
        Self { detail, ..self }
    }
}
