//! How precise what is given is: half a unit of the last place in which it is printed.

use momentous_quantity::Decimal;
use momentous_quantity::Unit;
use momentous_quantity::half_unit;

/// The acceleration of free fall: a constant, and so exact.
const GRAVITY: &str = "g";

/// Whether a value is exact as it stands: zero, a count, a coefficient of 0 or 1.
pub(super) fn is_exact(value: &Decimal, unit: &Unit) -> bool {
    value.is_zero() || unit.is_none() && value.to_rational().is_int()
}

/// By how much a told value may differ from the true one, in SI units: half a unit of its last printed place, with at least so many
/// significant figures; nothing where it is exact.
pub(crate) fn half_of_last_place(value: &Decimal, unit: &Unit, name: &str, figures: usize) -> f64 {
    if is_exact(value, unit) || name == GRAVITY {
        return 0.0;
    }
    let figures = figures.max(value.figures());
    half_unit(value.to_f64(), figures) * unit.factor().to_f64()
}
