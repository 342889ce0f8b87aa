//! The displacement of a body at each time of a push.

use momentous_expr::Expr;

/// The displacement of a body at each time of a push, along the only axis.
#[derive(Clone, Debug)]
pub(crate) struct Displacement {
    pub stage: usize,
    pub body: String,
    /// When the push begins and ends, on its own clock.
    pub during: [Expr; 2],
    /// The displacement up to the running time.
    pub gone: Expr,
}
