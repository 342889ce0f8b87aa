//! Labels: the mathematics beside arrows and bodies.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;

/// The name of the point from which places are told, where it has no name.
pub(super) const ORIGIN: &str = "O";

/// Factors side by side: `m v`.
pub(super) fn product(factors: impl IntoIterator<Item = Math>) -> Math {
    let mut parts = Vec::new();
    for factor in factors {
        if !parts.is_empty() {
            parts.push(Math::Operator(Operator::Juxtapose));
        }
        parts.push(factor);
    }
    Math::Row(parts)
}

/// A body's short name, as it stands inside its outline.
pub(super) fn body_math(body: &str) -> Math {
    if body.chars().count() == 1 { Math::Identifier(body.to_owned()) } else { Math::Text(body.to_owned()) }
}

/// In brackets where it is a sum.
pub(super) fn factor(expr: &Expr, math: Math) -> Math {
    if matches!(expr, Expr::Sum(_)) { Math::Bracketed(Arc::new(math)) } else { math }
}
