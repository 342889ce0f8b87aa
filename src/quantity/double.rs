//! Doubles from exact numbers.

use super::Rational;

/// Whole numbers up to here are doubles.
const WHOLE: u64 = 1 << 53;

/// The double nearest to a rational number; quickly where its terms have few digits, as most have.
///
/// ```
/// use momentous_quantity::{Rational, nearest_double};
/// assert_eq!(nearest_double(&(Rational::from(1) / Rational::from(3))), 1.0 / 3.0);
/// ```
#[must_use]
pub fn nearest_double(value: &Rational) -> f64 {
    let few = |size: u64| size <= WHOLE;
    let above = i64::try_from(value.numerator()).ok().filter(|above| few(above.unsigned_abs()));
    let below = u64::try_from(value.denominator()).ok().filter(|below| few(*below));
    match (above, below) {
        // Both are exact, so the division rounds once.
        #[allow(clippy::cast_precision_loss, reason = "no more than 2^53")]
        (Some(above), Some(below)) => above as f64 / below as f64,
        _ => value.to_f64().value(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Integer;

    #[test]
    fn the_quick_way_and_the_long_way_agree() {
        let terms = [0, 1, -1, 3, -10, 99, 4503, (1 << 53) - 1, 1 << 53, (1 << 53) + 1, i64::MAX, i64::MIN];
        for above in terms {
            for below in terms.into_iter().filter(|below| *below > 0) {
                let value = Rational::from(Integer::from(above)) / Rational::from(below);
                assert_eq!(nearest_double(&value).to_bits(), value.to_f64().value().to_bits(), "{above}/{below}");
            }
        }
    }
}
