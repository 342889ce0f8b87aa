//! How far a body has come at each time of a push.

use momentous_expr::Expr;

/// How far a body has come at each time of a push along the only axis.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    pub stage: usize,
    pub body: String,
    /// When the push begins and ends, on its own clock.
    pub during: [Expr; 2],
    /// The way up to the running time.
    pub way: Expr,
}
