//! Slips of the decimal point: an answer that is right but for a power of ten.

use crate::quantity::Dimension;
use crate::quantity::Rational;

use super::super::number::Number;
use super::closeness::Target;

/// The largest slip that is looked for.
const LARGEST: isize = 9;

/// The power of ten by which the number must be divided to be right, where there is one.
pub(super) fn power_of_ten(target: &Target, number: &Number) -> Option<isize> {
    if target.expected.cyclic || target.expected.whole || number.is_zero() || target.value() == 0.0 {
        return None;
    }
    let is_right = |power: &isize| {
        let scale = Number::exact(Rational::from(10).pow(-power));
        number.times(&scale).is_some_and(|scaled| target.within_tolerance(&scaled))
    };
    (1..=LARGEST).flat_map(|power| [power, -power]).find(is_right)
}

/// Whether a slip by this power of ten is one between usual units of a dimension: thousands, and with lengths centimetres.
pub(super) fn is_prefix(power: isize, dimension: Dimension) -> bool {
    let centimetres = isize::from(dimension.length) * 2;
    dimension != Dimension::NONE && (power % 3 == 0 || centimetres != 0 && power.abs() == centimetres.abs())
}
