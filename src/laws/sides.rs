//! The two sides of an equation.

use momentous_expr::Expr;

/// The two sides of an equation, as they are taught.
pub type Sides = (Expr, Expr);
