//! The angles whose sine is a rational number: by Niven's theorem, among the rational multiples of pi, those at which it is
//! 0, 1/2, 1 or the opposite of these.

use momentous_quantity::Rational;

/// The sine of that multiple of pi, where it is rational.
pub(super) fn rational_sine(multiple: &Rational) -> Option<Rational> {
    let twelfths = multiple * Rational::from(6);
    if !twelfths.is_int() {
        return None;
    }
    let full = dashu::Integer::from(12);
    let place = i64::try_from(((twelfths.numerator() % &full) + &full) % &full).ok()?;
    let half = || Rational::ONE / Rational::from(2);
    match place {
        0 | 6 => Some(Rational::ZERO),
        1 | 5 => Some(half()),
        3 => Some(Rational::ONE),
        7 | 11 => Some(-half()),
        9 => Some(-Rational::ONE),
        _ => None,
    }
}

/// The cosine of that multiple of pi, where it is rational.
pub(super) fn rational_cosine(multiple: &Rational) -> Option<Rational> {
    rational_sine(&(multiple + Rational::ONE / Rational::from(2)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_and_cosines_of_degrees() {
        let degrees = |size: i64| Rational::from(size) / Rational::from(180);
        let number = |value: Option<Rational>| value.map(|value| value.to_f64().value());
        let cases = [
            (0, Some(0.0), Some(1.0)),
            (30, Some(0.5), None),
            (60, None, Some(0.5)),
            (90, Some(1.0), Some(0.0)),
            (180, Some(0.0), Some(-1.0)),
            (-90, Some(-1.0), Some(0.0)),
            (-150, Some(-0.5), None),
            (600, None, Some(-0.5)),
            (45, None, None),
            (1, None, None),
        ];
        for (angle, sine, cosine) in cases {
            let found = (number(rational_sine(&degrees(angle))), number(rational_cosine(&degrees(angle))));
            assert_eq!(found, (sine, cosine), "{angle} degrees");
        }
    }
}
