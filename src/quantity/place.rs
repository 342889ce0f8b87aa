//! Places of decimal figures: where the first figure of a value stands, and what half a unit of its last figure is.

use super::decimal::POWERS_OF_TEN;

/// The power of ten of the first figure of a size: 2 for 310, -1 for 0.31. Of zero, and of what is not finite, 0.
///
/// ```
/// use momentous_quantity::first_place;
/// assert_eq!([310.0, 0.31, 1000.0, 999.9].map(first_place), [2, -1, 3, 2]);
/// ```
#[must_use]
pub fn first_place(size: f64) -> i32 {
    let size = size.abs();
    if size == 0.0 || !size.is_finite() {
        return 0;
    }
    // The binary exponent tells the place to within one: log10(2) is 0.30103 to five places.
    let exponent = i64::try_from(size.to_bits() >> 52).unwrap_or(0) - 1023;
    let estimate = i32::try_from((exponent * 30_103).div_euclid(100_000)).unwrap_or(0);
    if estimate.unsigned_abs() as usize + 1 >= POWERS_OF_TEN.len() {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "a double has at most 324 figures before or behind its point"
        )]
        return libm::floor(libm::log10(size)) as i32;
    }
    if size >= unit_of_place(estimate + 1) { estimate + 1 } else { estimate }
}

/// The double nearest to a power of ten.
#[must_use]
pub fn unit_of_place(place: i32) -> f64 {
    match (POWERS_OF_TEN.get(place.unsigned_abs() as usize), place >= 0) {
        (Some(power), true) => *power,
        (Some(power), false) => 1.0 / power,
        (None, _) => libm::pow(10.0, f64::from(place)),
    }
}

/// Half a unit of a value's last figure, when it is written with so many figures; nothing for zero, which has no first figure.
///
/// ```
/// use momentous_quantity::half_unit;
/// assert_eq!([half_unit(3.456, 3), half_unit(-1234.0, 3), half_unit(0.0, 3)], [0.005, 5.0, 0.0]);
/// ```
#[must_use]
pub fn half_unit(value: f64, figures: usize) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return 0.0;
    }
    0.5 * unit_of_place(first_place(value) + 1 - i32::try_from(figures).unwrap_or(i32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_place_is_that_of_the_printed_figures() {
        for place in -300..300_i32 {
            let power: f64 = format!("1e{place}").parse().unwrap();
            let below = f64::from_bits(power.to_bits() - 1);
            if place.unsigned_abs() < 21 {
                assert_eq!((first_place(power), first_place(below)), (place, place - 1), "{power}");
                assert_eq!(unit_of_place(place).to_bits(), power.to_bits(), "{power}");
            }
            assert_eq!([first_place(3.0 * power), first_place(-9.9 * power)], [place, place], "{power}");
        }
        assert_eq!([first_place(0.0), first_place(f64::INFINITY), first_place(f64::NAN)], [0, 0, 0]);
    }
}
