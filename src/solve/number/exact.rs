//! A given as it was written: a decimal, or an angle in degrees, without any rounding.

use momentous_quantity::Rational;

/// The number `rational * pi^pi_power`. 30 degrees is `1/6 pi`, 0.7 is `7/10`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Exact {
    /// The rational factor.
    pub rational: Rational,
    /// The exponent of pi.
    pub pi_power: i8,
}

impl From<Rational> for Exact {
    fn from(rational: Rational) -> Self {
        Self { rational, pi_power: 0 }
    }
}
