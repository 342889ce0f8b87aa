//! What is told of the bounces of one body, from which those of a single one follow.

use momentous_expr::Expr;

/// The bounces of one body on one floor.
#[derive(Clone, Debug)]
pub(super) struct BounceTerms {
    pub stage: usize,
    pub body: String,
    /// The coefficient of restitution.
    pub e: Expr,
    /// The square of the speed towards the floor with which the body first arrives.
    pub squared: Expr,
    /// The number of the bounce that is counted.
    pub count: Option<Expr>,
}
