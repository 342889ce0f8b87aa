//! Another way in which a scene could go with the same numbers.

use momentous_expr::Symbol;
use momentous_solve::Bounded;

/// Another way in which the scene could go, in which something that is asked has another value.
#[derive(Clone, Debug)]
pub(super) struct Rival {
    /// What happens in the way that was taken, and in the other.
    pub words: [String; 2],
    /// What is asked, with its values in the other way.
    pub values: Vec<(Symbol, Bounded)>,
}
