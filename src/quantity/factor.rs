//! Exact factors between units: a rational number times a power of pi.

use std::ops::Mul;
use std::sync::OnceLock;

use super::decimal::power_of_ten;
use super::{Integer, Rational, nearest_double};

/// An exact positive factor, `rational * pi^pi`: a degree is `1/180 * pi^1` radians.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factor {
    /// The rational part.
    pub rational: Rational,
    /// The exponent of pi.
    pub pi: i8,
}

/// The first digits of pi, as an integer, and how many of them stand behind the point.
const PI_DIGITS: (&[u128], usize) =
    (&[3_141_592_653_589_793_238_462_643_383_279, 502_884_197_169_399_375_105_820_974_944], 60);

impl Factor {
    /// One.
    pub const ONE: Self = Self { rational: Rational::ONE, pi: 0 };

    /// Whether it is one.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.pi == 0 && self.rational.is_one()
    }

    /// The factor to an integer power.
    #[must_use]
    pub fn power(&self, exponent: i8) -> Self {
        Self { rational: self.rational.pow(isize::from(exponent)), pi: self.pi.saturating_mul(exponent) }
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        match self.pi {
            0 => nearest_double(&self.rational),
            power => (&self.rational * pi_to_60_places().pow(isize::from(power))).to_f64().value(),
        }
    }
}

impl Default for Factor {
    fn default() -> Self {
        Self::ONE
    }
}

impl Mul for Factor {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { rational: self.rational * other.rational, pi: self.pi.saturating_add(other.pi) }
    }
}

/// Pi cut off after 60 decimals: enough for every double, whatever power a unit raises it to.
fn pi_to_60_places() -> &'static Rational {
    static PI: OnceLock<Rational> = OnceLock::new();
    PI.get_or_init(made_pi)
}

fn made_pi() -> Rational {
    let (groups, places) = PI_DIGITS;
    let join = |sum: Integer, group: &u128| sum * power_of_ten(places / 2) + Integer::from(*group);
    Rational::from(groups.iter().fold(Integer::ZERO, join)) / Rational::from(power_of_ten(places))
}

/// A factor that a table can hold; made by constant arithmetic, so that a row shows where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct StaticFactor {
    numerator: u128,
    denominator: u128,
    pi: i8,
}

impl StaticFactor {
    /// The integer `value`.
    pub(super) const fn integer(value: u128) -> Self {
        Self { numerator: value, denominator: 1, pi: 0 }
    }

    /// The decimal `unscaled / 10^scale`.
    pub(super) const fn decimal(unscaled: u128, scale: u32) -> Self {
        Self { numerator: unscaled, denominator: 10_u128.pow(scale), pi: 0 }
    }

    /// Pi.
    pub(super) const PI: Self = Self { numerator: 1, denominator: 1, pi: 1 };

    /// The exponent of pi.
    pub(super) const fn pi(self) -> i8 {
        self.pi
    }

    /// Whether the product is one.
    pub(super) fn cancels(self, other: Self) -> bool {
        let above = self.numerator.checked_mul(other.numerator);
        self.pi == -other.pi && above.is_some() && above == self.denominator.checked_mul(other.denominator)
    }

    /// The product.
    pub(super) const fn times(self, other: Self) -> Self {
        Self {
            numerator: self.numerator * other.numerator,
            denominator: self.denominator * other.denominator,
            pi: self.pi + other.pi,
        }
    }

    /// The quotient.
    pub(super) const fn over(self, other: Self) -> Self {
        Self {
            numerator: self.numerator * other.denominator,
            denominator: self.denominator * other.numerator,
            pi: self.pi - other.pi,
        }
    }
}

impl From<StaticFactor> for Factor {
    fn from(factor: StaticFactor) -> Self {
        let rational = Rational::from(factor.numerator) / Rational::from(factor.denominator);
        Self { rational, pi: factor.pi }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn multiplies_exactly() {
        let degree = Factor::from(StaticFactor::PI.over(StaticFactor::integer(180)));
        assert_eq!(degree.to_f64().to_bits(), (PI / 180.0).to_bits());
        assert_eq!(degree.clone() * degree.power(-1), Factor::ONE);
        assert_eq!(Factor { rational: Rational::ONE, pi: 1 }.to_f64().to_bits(), PI.to_bits());
        assert_eq!(degree.power(2).pi, 2);
    }
}
