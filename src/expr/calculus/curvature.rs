//! Judgements by values, without algebra: that a term is not linear, and that two terms are not equal.

use super::super::{Expr, Symbol};

/// A second difference below this share of the values may be rounding.
const NEGLIGIBLE: f64 = 1e-4;

/// Whether a term is certainly not linear in `symbols` jointly: along a line in them its value bends. `false` decides nothing.
///
/// Algebra on a term that is not linear is dear and ends in nothing; three values are cheap.
#[must_use]
pub fn is_curved(term: &Expr, symbols: &[Symbol]) -> bool {
    let [start, middle, end] = [0.0, 1.0, 2.0].map(|steps| {
        term.evaluate(&|symbol| {
            let moved = if symbols.contains(&symbol) { steps * sample(symbol, 1) / 4.0 } else { 0.0 };
            sample(symbol, 0) + moved
        })
    });
    let size = start.abs() + middle.abs() + end.abs();
    size.is_finite() && (start - 2.0 * middle + end).abs() > NEGLIGIBLE * (1.0 + size)
}

/// Whether two terms certainly have different values somewhere. `false` decides nothing.
pub(crate) fn differ(left: &Expr, right: &Expr) -> bool {
    let [left, right] = [left, right].map(|side| side.evaluate(&|symbol| sample(symbol, 0)));
    let size = left.abs() + right.abs();
    size.is_finite() && (left - right).abs() > NEGLIGIBLE * (1.0 + size)
}

/// A fixed value for each symbol, between 1/2 and 3/2, in no relation to that of any other.
fn sample(symbol: Symbol, salt: u32) -> f64 {
    let index = u32::try_from(symbol.index()).unwrap_or(u32::MAX);
    let mixed = index.wrapping_add(salt.wrapping_mul(977)).wrapping_add(1).wrapping_mul(2_654_435_761);
    0.5 + f64::from(mixed ^ (mixed >> 15)) / f64::from(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;
    use super::*;

    #[test]
    fn what_bends_is_not_linear() {
        for (text, curved) in [
            ("a*x + b*y - c^2", false),
            ("(x^2 - 1)/(x - 1) + a*y", false),
            ("m*x^2/2 + y", true),
            ("x*y", true),
            ("sqrt(x) - a", true),
            ("ln(a - 9) * x^2", false),
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            let unknowns = [names.named("x"), names.named("y")];
            assert_eq!(is_curved(&term, &unknowns), curved, "{text}");
        }
    }
}
