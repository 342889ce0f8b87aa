//! Slips of the decimal point: an answer that is right but for a power of ten.

use momentous_quantity::Dimension;

use super::super::number::Number;
use super::super::verdict::Verdict;
use super::closeness::Target;

/// The largest slip that is looked for.
const LARGEST: isize = 9;
/// The share of the right value within which an answer must lie for the nearest power of ten alone to be right.
const NARROW: f64 = 0.5;
/// The powers of ten up to there.
const POWERS: [f64; 10] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

/// The power of ten by which the number must be divided to be right, where there is one.
pub(super) fn power_of_ten(target: &Target, number: &Number) -> Option<isize> {
    if target.expected.cyclic || target.expected.whole || number.is_zero() || target.value() == 0.0 {
        return None;
    }
    let (given, value) = (number.to_f64(), target.value());
    let is_right = |power: &isize| {
        let size = POWERS[power.unsigned_abs().min(POWERS.len() - 1)];
        target.has_digits(if *power > 0 { given / size } else { given * size })
    };
    if 2.0 * target.reach_of_digits() > NARROW * value.abs() {
        return (1..=LARGEST).flat_map(|power| [power, -power]).find(is_right);
    }
    #[allow(clippy::cast_possible_truncation, reason = "the decades between two doubles are a few hundred")]
    let nearest = libm::round(libm::log10((given / value).abs())) as isize;
    Some(nearest).filter(|power| *power != 0 && power.abs() <= LARGEST && is_right(power))
}

/// Whether a slip by this power of ten is one between usual units of a dimension: thousands, and with lengths centimetres.
pub(super) fn is_prefix(power: isize, dimension: Dimension) -> bool {
    let centimetres = isize::from(dimension.length) * 2;
    dimension != Dimension::NONE && (power % 3 == 0 || centimetres != 0 && power.abs() == centimetres.abs())
}

/// Every slip of the decimal point that may be found, each with its verdict; those between usual units come first.
pub(super) fn shifted(target: &Target) -> impl Iterator<Item = (i32, Verdict)> {
    let dimension = target.expected.unit.dimension();
    let is_found = target.value() != 0.0;
    let powers = (1..=LARGEST).flat_map(|power| [power, -power]).filter(move |_| is_found);
    powers.map(move |power| {
        let verdict = if is_prefix(power, dimension) { Verdict::UnitPrefix } else { Verdict::OrderOfMagnitude };
        // There are no more than nine.
        (i32::try_from(power).unwrap_or(0), verdict)
    })
}
