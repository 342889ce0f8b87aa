//! The dimension of a quantity: exponents of mass, length and time.

use std::ops::{Div, Mul};

/// Exponents of mass, length and time. A plane angle is a pure number, as in the SI.
///
/// ```
/// use momentous_quantity::Dimension;
/// assert_eq!(Dimension::MASS * Dimension::VELOCITY, Dimension::MOMENTUM);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Dimension {
    /// Exponent of mass.
    pub mass: i8,
    /// Exponent of length.
    pub length: i8,
    /// Exponent of time.
    pub time: i8,
}

impl Dimension {
    /// A pure number: a coefficient of restitution, an angle, a count.
    pub const NONE: Self = Self::new(0, 0, 0);
    /// Mass.
    pub const MASS: Self = Self::new(1, 0, 0);
    /// Length.
    pub const LENGTH: Self = Self::new(0, 1, 0);
    /// Time.
    pub const TIME: Self = Self::new(0, 0, 1);
    /// Velocity and speed.
    pub const VELOCITY: Self = Self::new(0, 1, -1);
    /// Acceleration.
    pub const ACCELERATION: Self = Self::new(0, 1, -2);
    /// Force.
    pub const FORCE: Self = Self::new(1, 1, -2);
    /// Momentum, and impulse.
    pub const MOMENTUM: Self = Self::new(1, 1, -1);
    /// Energy, work, and the moment of a force.
    pub const ENERGY: Self = Self::new(1, 2, -2);
    /// Angular momentum, and angular impulse.
    pub const ANGULAR_MOMENTUM: Self = Self::new(1, 2, -1);

    /// The dimension with these exponents of mass, length and time.
    #[must_use]
    pub const fn new(mass: i8, length: i8, time: i8) -> Self {
        Self { mass, length, time }
    }

    /// The dimension of a quantity raised to an integer power; `None` where an exponent overflows.
    #[must_use]
    pub fn power(self, exponent: i8) -> Option<Self> {
        Some(Self::new(
            self.mass.checked_mul(exponent)?,
            self.length.checked_mul(exponent)?,
            self.time.checked_mul(exponent)?,
        ))
    }

    /// The dimension of an n-th root; `None` where an exponent is not divisible by `degree`.
    #[must_use]
    pub fn root(self, degree: i8) -> Option<Self> {
        let divide = |exponent: i8| (degree != 0 && exponent % degree == 0).then(|| exponent / degree);
        Some(Self::new(divide(self.mass)?, divide(self.length)?, divide(self.time)?))
    }
}

impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.mass.saturating_add(other.mass),
            self.length.saturating_add(other.length),
            self.time.saturating_add(other.time),
        )
    }
}

impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::new(
            self.mass.saturating_sub(other.mass),
            self.length.saturating_sub(other.length),
            self.time.saturating_sub(other.time),
        )
    }
}
