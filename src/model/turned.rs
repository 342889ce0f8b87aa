//! Angular impulses that get a name once somebody asks for them.

use momentous_expr::Expr;
use momentous_laws::Law;

/// An angular impulse that no equation needs, with the equation that gives it where somebody asks for it.
#[derive(Clone, Debug)]
pub(super) struct Turned {
    pub stage: usize,
    /// Whose it is and about which point, as in a sentence.
    pub of: String,
    pub letter: Option<String>,
    pub law: &'static Law,
    pub because: String,
    /// The term to which it is added, and the result.
    pub ends: [Expr; 2],
}
