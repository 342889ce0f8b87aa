//! Ways that a body has to go through to the end, where a force on it depends on the place.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::Reason;

/// A way along which a body must not come to rest before its end.
#[derive(Clone, Debug)]
pub struct Passage {
    /// The position as a variable.
    pub place: Symbol,
    /// The ends of the way.
    pub ends: [Expr; 2],
    /// The kinetic energy at the position, or what else must not become negative.
    pub kinetic: Expr,
    /// The reason to give where the body does not get through.
    pub reason: Reason,
    /// The only way of going to which it belongs, where a stage can go in several: the position of the choice, and what happens.
    pub way: Option<(usize, String)>,
}
