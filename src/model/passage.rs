//! Ways that a body has to go through to the end, where a force on it depends on the place.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::Reason;

/// A way along which a body must not come to rest before its end.
#[derive(Clone, Debug)]
pub struct Passage {
    /// The position as a variable.
    pub place: Symbol,
    /// Where the way begins and ends.
    pub ends: [Expr; 2],
    /// The kinetic energy at the position.
    pub kinetic: Expr,
    /// What to say where the body does not get through.
    pub reason: Reason,
}
