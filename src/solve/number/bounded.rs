//! A floating-point value with a bound on its error.

/// A value and a bound on its error: the true value lies within `error` of `value`.
///
/// `error` is infinite where nothing bounds the value, and both are not a number where there is no real value.
/// Bounds follow Higham, Accuracy and Stability of Numerical Algorithms, 3.3 (running error analysis); elementary
/// functions are allowed two units in the last place.
///
/// ```
/// use momentous_solve::{Bounded, Real};
/// let tenth = Bounded { value: 0.1, error: 1e-17 };
/// let product = tenth.mul(&tenth);
/// assert!((product.value - 0.01).abs() < product.error && product.error < 1e-17);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The value.
    pub value: f64,
    /// The bound on its error, in the same unit.
    pub error: f64,
}

/// The unit roundoff, 2^-53.
pub(super) const UNIT: f64 = f64::EPSILON / 2.0;

/// Covers the rounding of the error's own arithmetic, fewer than 16 operations.
pub(super) const GROWTH: f64 = 1.0 + 32.0 * UNIT;

impl Bounded {
    /// A value without error.
    #[must_use]
    pub const fn exactly(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The value nearest to one within `error` of the true value.
    pub(crate) fn rounded(value: f64, error: f64) -> Self {
        let rounding = if value.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { value.abs() * f64::EPSILON };
        let error = (error + rounding) * (1.0 + f64::EPSILON);
        if value.is_finite() { Self { value, error } } else { Self::UNBOUNDED }
    }

    /// The value to be rounded for print: as far from zero as the bound allows, so that an exact tie, which floating point
    /// may have missed by a hair, is rounded away from zero as it should be; zero where the bound does not tell it from zero.
    ///
    /// ```
    /// use momentous_solve::Bounded;
    /// let printed = |value, error| Bounded { value, error }.for_print();
    /// assert_eq!((printed(2e-16, 3e-16), printed(0.125, 1e-17)), (0.0, 0.125 + 1e-17));
    /// ```
    #[must_use]
    pub fn for_print(self) -> f64 {
        if self.is_zero() {
            0.0
        } else if self.error.is_finite() {
            self.value + self.error.copysign(self.value)
        } else {
            self.value
        }
    }

    /// Whether nothing tells the value from zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.error.is_finite() && self.value.abs() <= self.error
    }

    /// The value, a plain zero where nothing tells it from that.
    #[must_use]
    pub fn or_zero(self) -> f64 {
        if self.is_zero() { 0.0 } else { self.value }
    }

    /// Nothing is known.
    pub(super) const UNBOUNDED: Self = Self { value: 0.0, error: f64::INFINITY };
    /// There is no real value.
    pub(super) const NOT_REAL: Self = Self { value: f64::NAN, error: f64::NAN };

    /// The largest size that the true value may have.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        (self.value.abs() + self.error) * GROWTH
    }
}
