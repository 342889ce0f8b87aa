//! Arithmetic in floating point with a running error bound.

use std::f64::consts::{PI, TAU};

use momentous_expr::Function;

use super::super::Exact;
use super::bounded::{Bounded, GROWTH, UNIT};
use super::real::{Real, Sign};

/// The relative error that is allowed for the library's elementary functions: 2 units in the last place. The library's
/// own tests hold it below 1.
const LIBRARY: f64 = 4.0 * UNIT;

/// Below this size, an absolute allowance of [`SPECK`] covers underflow.
const SMALL: f64 = 1e-280;
const SPECK: f64 = 1e-300;

impl Bounded {
    /// The quotient of two integers that floating point holds exactly: the short way for givens of few digits.
    fn quotient(exact: &Exact) -> Option<Self> {
        let above = i64::try_from(exact.rational.numerator()).ok().filter(|above| above.unsigned_abs() < 1 << 53)?;
        let below = i64::try_from(exact.rational.denominator()).ok().filter(|below| *below < 1 << 53)?;
        let above = Self::integer(above);
        Some(if below == 1 { above } else { above.div(&Self::integer(below)) })
    }

    /// A result whose error has a share of the value in it, and is so finite only where the value is.
    #[inline]
    fn with_share(value: f64, error: f64) -> Self {
        if error < f64::INFINITY { Self { value, error: error * GROWTH } } else { Self::settle(value, error) }
    }

    /// Brings a result into one of the three states: operands are finite, or not a number where they are not real.
    fn settle(value: f64, error: f64) -> Self {
        if value.is_finite() && error.is_finite() {
            Self { value, error: error * GROWTH }
        } else if value.is_nan() {
            Self::NOT_REAL
        } else if value.is_finite() {
            Self { value, error: f64::INFINITY }
        } else {
            Self::UNBOUNDED
        }
    }

    /// A function that only rises or only falls, between bounds on its argument.
    fn monotone(self, lowest: f64, highest: f64, function: impl Fn(f64) -> f64) -> Self {
        let value = function(self.value.clamp(lowest, highest));
        if self.error == 0.0 {
            return Self::settle(value, allowance(value));
        }
        let margin = self.error + self.value.abs() * (4.0 * UNIT);
        let (low, high) = (function((self.value - margin).max(lowest)), function((self.value + margin).min(highest)));
        let error = (low - value).abs().max((high - value).abs());
        Self::settle(value, error + 2.0 * (allowance(low) + allowance(high) + allowance(value)))
    }
}

/// The error allowed for a value of the library.
fn allowance(value: f64) -> f64 {
    value.abs() * LIBRARY + if value != 0.0 && value.abs() < SMALL { SPECK } else { 0.0 }
}

impl Real for Bounded {
    const SPACING: f64 = f64::EPSILON;

    fn from_exact(exact: &Exact) -> Self {
        let rational = Self::quotient(exact).unwrap_or_else(|| {
            let rational = exact.rational.to_f64();
            let is_exact = matches!(rational, dashu::base::Approximation::Exact(_));
            let value = rational.value();
            Self::settle(value, if is_exact { 0.0 } else { value.abs() * UNIT + f64::MIN_POSITIVE })
        });
        if exact.pi_power == 0 {
            return rational;
        }
        rational.mul(&Self { value: PI, error: 1.3e-16 }.powi(i32::from(exact.pi_power)))
    }

    fn integer(value: i64) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "the loss is the error")]
        let rounded = value as f64;
        Self { value: rounded, error: if value.unsigned_abs() < 1 << 53 { 0.0 } else { rounded.abs() * UNIT } }
    }

    fn point(value: f64) -> Self {
        Self::exactly(value)
    }

    fn not_real() -> Self {
        Self::NOT_REAL
    }

    #[inline]
    fn add(&self, other: &Self) -> Self {
        let value = self.value + other.value;
        Self::with_share(value, self.error + other.error + value.abs() * UNIT)
    }

    #[inline]
    fn sub(&self, other: &Self) -> Self {
        let value = self.value - other.value;
        Self::with_share(value, self.error + other.error + value.abs() * UNIT)
    }

    #[inline]
    fn mul(&self, other: &Self) -> Self {
        let value = self.value * other.value;
        let spread = self.value.abs() * other.error + other.value.abs() * self.error + self.error * other.error;
        if value.abs() >= SMALL {
            return Self::with_share(value, spread + value.abs() * UNIT);
        }
        let underflow = self.magnitude() > 0.0 && other.magnitude() > 0.0;
        Self::with_share(value, spread + value.abs() * UNIT + if underflow { SPECK } else { 0.0 })
    }

    #[inline]
    fn div(&self, other: &Self) -> Self {
        let least = (other.value.abs() - other.error) * (1.0 - 4.0 * UNIT);
        if least > 0.0 {
            let value = self.value / other.value;
            let spread = (self.error + value.abs() * other.error) / least;
            let underflow = value.abs() < SMALL && self.magnitude() > 0.0;
            return Self::with_share(value, spread + value.abs() * UNIT + if underflow { SPECK } else { 0.0 });
        }
        if other.error == 0.0 || !self.is_real() || !other.is_real() { Self::NOT_REAL } else { Self::UNBOUNDED }
    }

    #[inline]
    fn neg(&self) -> Self {
        Self { value: -self.value, error: self.error }
    }

    #[inline]
    fn sqrt(&self) -> Self {
        let (value, error) = (self.value, self.error);
        if value > error * GROWTH {
            let root = value.sqrt();
            return Self::with_share(root, error / (root + (value - error * GROWTH).max(0.0).sqrt()) + root * UNIT);
        }
        if value + error < 0.0 || !self.is_real() {
            return Self::NOT_REAL;
        }
        Self::settle(value.max(0.0).sqrt(), self.magnitude().sqrt() * GROWTH)
    }

    fn apply(&self, function: Function) -> Self {
        if !self.is_real() {
            return Self::NOT_REAL;
        }
        let (value, error) = (self.value, self.error);
        let wave =
            |wave: f64| Self::settle(wave, if error == 0.0 { allowance(wave) } else { error.min(2.0) + LIBRARY });
        match function {
            Function::Sin => wave(libm::sin(value)),
            Function::Cos => wave(libm::cos(value)),
            Function::Tan => self.apply(Function::Sin).div(&self.apply(Function::Cos)),
            Function::Asin | Function::Acos if value.abs() - error > 1.0 => Self::NOT_REAL,
            Function::Asin => self.monotone(-1.0, 1.0, libm::asin),
            Function::Acos => self.monotone(-1.0, 1.0, libm::acos),
            Function::Exp => self.monotone(f64::MIN, f64::MAX, libm::exp),
            Function::Ln if value + error <= 0.0 => Self::NOT_REAL,
            Function::Ln if value - error * GROWTH - value.abs() * (8.0 * UNIT) <= 0.0 => Self::UNBOUNDED,
            Function::Ln => self.monotone(0.0, f64::MAX, libm::log),
            Function::Abs => Self { value: value.abs(), error },
            Function::Atan2 => self.atan2(&Self::exactly(1.0)),
        }
    }

    fn atan2(&self, x: &Self) -> Self {
        let (y, distance) = (self.value + 0.0, libm::hypot(self.value, x.value));
        let spread = (self.error + x.error) * GROWTH;
        let value = libm::atan2(y, x.value);
        let near = distance * (1.0 - 2.0 * LIBRARY) <= spread;
        let cut = x.value < 0.0 && self.error > 0.0 && y.abs() <= self.error;
        if !self.is_real() || !x.is_real() || (near && spread == 0.0) {
            Self::NOT_REAL
        } else if near || cut {
            Self::settle(value, TAU)
        } else {
            // The gradient of the angle is 1 / distance, at most 1 / (distance - spread) along the way.
            Self::settle(value, spread / (distance * (1.0 - 2.0 * LIBRARY) - spread) + allowance(value))
        }
    }

    fn hull(&self, other: &Self) -> Self {
        let value = 0.5 * self.value + 0.5 * other.value;
        let reach = |part: &Self| (part.value - value).abs() + part.error;
        Self::settle(value, reach(self).max(reach(other)) + value.abs() * UNIT)
    }

    fn centre(&self) -> Self {
        Self::settle(self.value, 0.0)
    }

    #[inline]
    fn sign(&self) -> Sign {
        if self.value > self.error {
            Sign::Positive
        } else if -self.value > self.error {
            Sign::Negative
        } else if self.value.is_nan() {
            Sign::NotReal
        } else if self.error == 0.0 {
            Sign::Zero
        } else {
            Sign::Unsure
        }
    }

    fn to_bounded(&self) -> Self {
        *self
    }

    fn is_unbounded(&self) -> bool {
        self.error == f64::INFINITY
    }

    #[inline]
    fn is_real(&self) -> bool {
        !self.value.is_nan()
    }
}
