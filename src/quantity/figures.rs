//! Printing numbers to so many significant figures.

use std::cmp::Ordering;
use std::ops::Add;
use std::ops::Div;
use std::ops::Mul;

use dashu::base::{Abs, BitTest, Sign};

use super::decimal::power_of_ten;
use super::unit_print::superscript;
use super::{Decimal, Integer, Rational};

/// The most figures that are printed.
const MAX_FIGURES: usize = 40;

/// A written number of more characters is printed with a power of ten where that is shorter.
const LONG: usize = 9;

/// A number rounded for display: its digits, and a power of ten where it is very large or very small.
///
/// It is rounded from the exact value, half away from zero. Between 0.001 and 1 000 000 it is printed without a power of ten.
///
/// ```
/// use momentous_quantity::Printed;
/// assert_eq!(Printed::new(-2.2987, 3).unwrap().plain(), "-2.30");
/// assert_eq!(Printed::new(1.2e7, 3).unwrap().latex(), r"1.20 \times 10^{7}");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Printed {
    mantissa: Decimal,
    power_of_ten: Option<i32>,
}

/// A text with true minus signs in place of hyphens, as numbers and axes stand in sentences.
#[must_use]
pub fn with_minus_signs(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

impl Printed {
    /// Rounds a double to `figures` figures (1 to 40); `None` where it is not finite.
    #[must_use]
    pub fn new(value: f64, figures: usize) -> Option<Self> {
        round_to_figures(value, figures).map(Self::of_rounded)
    }

    /// Rounds an exact number to `figures` figures (1 to 40).
    #[must_use]
    pub fn exact(value: &Rational, figures: usize) -> Self {
        Self::of_rounded(round_rational(value, figures))
    }

    /// A number that somebody wrote, exactly and with its figures: `12.0` stays `12.0`; zero is a bare `0`.
    ///
    /// ```
    /// use momentous_quantity::{Decimal, Printed};
    /// let printed = |text: &str| Printed::written(&Decimal::parse(text).unwrap()).plain();
    /// assert_eq!(["12.0", "0.00", "1.5e10"].map(printed), ["12.0", "0", "1.5 × 10^10"]);
    /// ```
    #[must_use]
    pub fn written(value: &Decimal) -> Self {
        if value.is_zero() {
            return Self { mantissa: Decimal::from(0), power_of_ten: None };
        }
        if value.to_string().len() > LONG {
            return Self::exact(&value.to_rational(), value.least_figures());
        }
        Self { mantissa: value.clone(), power_of_ten: None }
    }

    fn of_rounded(rounded: Decimal) -> Self {
        // The place of the first figure: 0 for 3.1, 2 for 310, -1 for 0.31.
        let figures = i32::try_from(rounded.figures()).unwrap_or(i32::MAX);
        let leading = figures - 1 - rounded.scale();
        if rounded.is_zero() || (-3..6).contains(&leading) {
            return Self { mantissa: rounded, power_of_ten: None };
        }
        let mantissa = Decimal::new(rounded.unscaled().clone(), figures - 1);
        Self { mantissa, power_of_ten: Some(leading) }
    }

    /// The number before the power of ten: `-2.30`, with an ASCII hyphen for its sign.
    #[must_use]
    pub fn mantissa(&self) -> String {
        self.mantissa.to_string()
    }

    /// The power of ten, where there is one.
    #[must_use]
    pub fn power_of_ten(&self) -> Option<i32> {
        self.power_of_ten
    }

    /// Plain text: `-2.30`, `1.20 × 10^7`.
    #[must_use]
    pub fn plain(&self) -> String {
        match self.power_of_ten {
            None => self.mantissa(),
            Some(power) => format!("{} × 10^{power}", self.mantissa),
        }
    }

    /// In a sentence, with true minus signs and a raised power: `−2.30`, `1.20 × 10⁷`.
    ///
    /// ```
    /// # use momentous_quantity::Printed;
    /// assert_eq!(Printed::new(-1.327e20, 4).unwrap().in_a_sentence(), "\u{2212}1.327 × 10²⁰");
    /// ```
    #[must_use]
    pub fn in_a_sentence(&self) -> String {
        let mantissa = with_minus_signs(&self.mantissa());
        match self.power_of_ten {
            None => mantissa,
            Some(power) => {
                let sign = if power < 0 { "\u{207b}" } else { "" };
                format!("{mantissa} × 10{sign}{}", superscript(power.unsigned_abs()))
            }
        }
    }

    /// For LaTeX's mathematics: `-2.30`, `1.20 \times 10^{7}`.
    #[must_use]
    pub fn latex(&self) -> String {
        match self.power_of_ten {
            None => self.mantissa(),
            Some(power) => format!("{} \\times 10^{{{power}}}", self.mantissa),
        }
    }

    /// The rounded value, exactly: what a reader of the print takes it for.
    #[must_use]
    pub fn to_decimal(&self) -> Decimal {
        let scale = self.mantissa.scale() - self.power_of_ten.unwrap_or(0);
        Decimal::new(self.mantissa.unscaled().clone(), scale)
    }
}

/// The double rounded to `figures` figures (1 to 40), half away from zero, from its exact decimal expansion; `None` where it is not finite.
///
/// ```
/// use momentous_quantity::round_to_figures;
/// assert_eq!(round_to_figures(2.5, 1).unwrap().to_string(), "3");
/// assert_eq!(round_to_figures(1.005, 3).unwrap().to_string(), "1.00"); // the double is a little below 1.005
/// ```
#[must_use]
pub fn round_to_figures(value: f64, figures: usize) -> Option<Decimal> {
    if let Some((digits, scale)) = short(value, figures) {
        let digits = Integer::from(digits);
        return Some(Decimal::new(if value < 0.0 { -digits } else { digits }, scale));
    }
    Rational::try_from(value).ok().map(|exact| round_rational(&exact, figures))
}

/// The same for a double that is a quotient of machine words: its digits, and how many stand behind the point.
fn short(value: f64, figures: usize) -> Option<(u128, i32)> {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    const BIAS: i64 = 1023;
    let biased = value.to_bits() >> FRACTION & 0x7ff;
    if biased == 0 || biased == 0x7ff {
        return None; // zero and what is nearly so, or not finite
    }
    let whole = value.to_bits() & ((1 << FRACTION) - 1) | 1 << FRACTION;
    let even = whole.trailing_zeros();
    let power = i64::try_from(biased).ok()? - BIAS - i64::from(FRACTION) + i64::from(even);
    let above = u128::from(whole >> even);
    let (above, below) = match u32::try_from(power) {
        Ok(power) if power <= above.leading_zeros() - 64 => (above << power, 1),
        Ok(_) => return None,
        Err(_) => (above, 1_u128 << u32::try_from(-power).ok().filter(|power| *power < 64)?),
    };
    let figures = i32::try_from(figures.clamp(1, MAX_FIGURES)).ok()?;
    rounded(&above, &below, figures, bits, short_power)
}

/// An exact number rounded to `figures` figures (1 to 40), half away from zero. Zero is a bare `0`.
#[must_use]
pub fn round_rational(value: &Rational, figures: usize) -> Decimal {
    if value.is_zero() {
        return Decimal::from(0);
    }
    let figures = i32::try_from(figures.clamp(1, MAX_FIGURES)).unwrap_or(1);
    let signed = |digits: Integer, scale: i32| {
        Decimal::new(if value.sign() == Sign::Negative { -digits } else { digits }, scale)
    };
    let numerator = value.numerator().clone().abs();
    let few = || Some((u64::try_from(&numerator).ok()?, u64::try_from(value.denominator()).ok()?));
    if let Some((above, below)) = few()
        && let Some((digits, scale)) = rounded(&u128::from(above), &u128::from(below), figures, bits, short_power)
    {
        return signed(Integer::from(digits), scale);
    }
    let bit_len = |value: &Integer| i64::try_from(value.bit_len()).unwrap_or(i64::MAX);
    let power = |places: i32| Some(power_of_ten(usize::try_from(places.unsigned_abs()).unwrap_or(0)));
    // Every power of ten is there, so there is a result.
    let digits_and_scale = rounded(&numerator, &Integer::from(value.denominator().clone()), figures, bit_len, power);
    digits_and_scale.map_or_else(|| Decimal::from(0), |(digits, scale)| signed(digits, scale))
}

/// A quotient of positive integers rounded to so many figures, half up: its digits, and how many of them stand behind the
/// point. `power` gives the power of ten for the size of a place; none where it is too large for this kind of integer.
fn rounded<I>(
    numerator: &I,
    denominator: &I,
    figures: i32,
    bits: impl Fn(&I) -> i64,
    power: impl Fn(i32) -> Option<I>,
) -> Option<(I, i32)>
where
    I: Clone + PartialOrd + From<u8> + Add<Output = I> + Mul<Output = I> + Div<Output = I>,
{
    let (least, most) = (power(figures - 1)?, power(figures)?);
    // The place of the first figure, to within a few: log10(2) is 0.30103 to five places.
    let binary_places = bits(numerator) - bits(denominator);
    let place = i32::try_from(binary_places.saturating_mul(30_103) / 100_000).unwrap_or(0);
    let mut scale = figures - 1 - place;
    loop {
        let (above, below) = match scale.cmp(&0) {
            Ordering::Less => (numerator.clone(), denominator.clone() * power(scale)?),
            _ => (numerator.clone() * power(scale)?, denominator.clone()),
        };
        let cut = above.clone() / below.clone();
        // The estimate is at most a few places off; each turn mends one.
        if cut >= most {
            scale -= 1;
        } else if cut < least {
            scale += 1;
        } else {
            let digits = (above * I::from(2) + below.clone()) / (below * I::from(2));
            // 9.99 rounded to two figures is 10, not 10.0.
            return Some(if digits == most { (digits / I::from(10), scale - 1) } else { (digits, scale) });
        }
    }
}

fn bits(value: &u128) -> i64 {
    i64::from(u128::BITS - value.leading_zeros())
}

/// A power of ten that leaves room for the product with any 64 bits, and its double.
fn short_power(places: i32) -> Option<u128> {
    (places.unsigned_abs() <= 18).then(|| 10_u128.pow(places.unsigned_abs()))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn prints_to_figures() {
        let cases = [
            (0.0, 3, "0"),
            (-0.0, 3, "0"),
            (-2.3, 3, "-2.30"),
            (3.0999, 3, "3.10"),
            (9.996, 3, "10.0"),
            (0.5, 1, "0.5"),
            (0.25, 1, "0.3"),
            (-0.25, 1, "-0.3"),
            (2.5, 1, "3"),
            (1.005, 3, "1.00"),
            (123_456.0, 3, "123000"),
            (999_999.0, 3, "1.00 × 10^6"),
            (1e6, 3, "1.00 × 10^6"),
            (1.2e7, 3, "1.20 × 10^7"),
            (-1.2e7, 1, "-1 × 10^7"),
            (0.001, 3, "0.00100"),
            (0.000_999_96, 3, "0.00100"),
            (0.000_999, 3, "9.99 × 10^-4"),
            (5e-324, 3, "4.94 × 10^-324"),
            (f64::MAX, 4, "1.798 × 10^308"),
            (0.1, 40, "0.1000000000000000055511151231257827021182"),
        ];
        for (value, figures, expected) in cases {
            assert_eq!(Printed::new(value, figures).unwrap().plain(), expected, "{value} to {figures}");
        }
        assert_eq!(Printed::new(f64::NAN, 3), None);
        assert_eq!(Printed::new(f64::INFINITY, 3), None);
    }

    #[test]
    fn rounds_exact_numbers() {
        let ratio = |above: i64, below: i64| Rational::from(above) / Rational::from(below);
        let cases =
            [(1, 3, 4, "0.3333"), (-2, 3, 2, "-0.67"), (1_005, 1_000, 3, "1.01"), (7, 10, 3, "0.700"), (5, 1, 1, "5")];
        for (above, below, figures, expected) in cases {
            assert_eq!(Printed::exact(&ratio(above, below), figures).plain(), expected);
        }
    }

    proptest! {
        #[test]
        fn is_the_nearest_with_so_many_figures(value in prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL, figures in 1..20_usize) {
            let rounded = round_to_figures(value, figures).unwrap();
            prop_assert_eq!(rounded.figures(), figures);
            let off = (rounded.to_rational() - Rational::try_from(value).unwrap()).abs() * Rational::from(2);
            let unit = Decimal::new(Integer::from(1), rounded.scale()).to_rational();
            prop_assert!(off <= unit);
            let printed = Printed::new(value, figures).unwrap();
            prop_assert_eq!(printed.to_decimal(), rounded);
        }

        #[test]
        fn seventeen_figures_say_it_all(value in prop::num::f64::NORMAL) {
            prop_assert_eq!(round_to_figures(value, 17).unwrap().to_f64().to_bits(), value.to_bits());
        }
    }
}
