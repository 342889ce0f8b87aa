//! Pairs of doubles: twice the digits of floating point, for what it leaves open only since digits cancel.

use crate::expr::Function;

use super::Exact;
use super::bounded::{Bounded, GROWTH, UNIT};
use super::real::{Real, Sign};

/// The unevaluated sum of two doubles, the second at most half a unit in the last place of the first, and a bound on its error.
///
/// Sums, products, quotients and square roots follow Joldes, Muller and Popescu, Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic, ACM Transactions on Mathematical Software 44 (2017), algorithms 6, 12 and 17, and
/// Lefevre, Louvet, Muller, Picot and Rideau, Accurate calculation of Euclidean norms using double-word arithmetic, 49 (2023);
/// their bounds hold where nothing underflows. Other functions are left to exact arithmetic: nothing is known of them here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Doubled {
    high: f64,
    low: f64,
    error: f64,
}

/// The square of the unit roundoff.
const SQUARE: f64 = UNIT * UNIT;
/// Relative errors of the operations, in units of [`SQUARE`], each rounded up from the proven one.
const SUM: f64 = 4.0 * SQUARE;
const PRODUCT: f64 = 6.0 * SQUARE;
const QUOTIENT: f64 = 16.0 * SQUARE;
const ROOT: f64 = 4.0 * SQUARE;

/// Beyond these sizes a pair is unbounded, so that nothing within them underflows or overflows.
const LEAST: f64 = 1e-140;
const MOST: f64 = 1e140;

/// a + b as a pair, without error.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let high = a + b;
    let part = high - b;
    (high, (a - part) + (b - (high - part)))
}

/// The same where a is at least as large as b.
fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let high = a + b;
    (high, b - (high - a))
}

/// a b as a pair, without error.
fn product(a: f64, b: f64) -> (f64, f64) {
    let high = a * b;
    (high, a.mul_add(b, -high))
}

impl Doubled {
    const ZERO: Self = Self { high: 0.0, low: 0.0, error: 0.0 };
    const UNBOUNDED: Self = Self { high: 0.0, low: 0.0, error: f64::INFINITY };
    const NOT_REAL: Self = Self { high: f64::NAN, low: 0.0, error: f64::NAN };
    /// The third part of pi is -3e-33.
    const PI: Self = Self { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16, error: 3e-33 };

    /// A pair with the error that it has of its operands, and a relative one of its own.
    fn settle((high, low): (f64, f64), spread: f64, own: f64) -> Self {
        let error = (spread + high.abs() * own) * GROWTH;
        let size = high.abs();
        if high.is_nan() {
            Self::NOT_REAL
        } else if error.is_finite() && (high == 0.0 || (LEAST..MOST).contains(&size)) {
            Self { high, low, error }
        } else {
            Self::UNBOUNDED
        }
    }

    fn is_nothing(&self) -> bool {
        self.high == 0.0 && self.error == 0.0
    }

    /// Whether nothing is known of the one or the other, or one has no value; and what then becomes of them together.
    fn lost(&self, other: &Self) -> Option<Self> {
        if !self.is_real() || !other.is_real() {
            return Some(Self::NOT_REAL);
        }
        (self.is_unbounded() || other.is_unbounded()).then_some(Self::UNBOUNDED)
    }
}

impl Real for Doubled {
    const SPACING: f64 = SQUARE;

    fn from_exact(exact: &Exact) -> Self {
        let whole = |part: Result<i64, _>| part.map_or(Self::UNBOUNDED, |part: i64| Self::integer(part));
        let (above, below) = (exact.rational.numerator(), exact.rational.denominator());
        let (above, below) = (whole(i64::try_from(above)), whole(i64::try_from(below)));
        let rational = if below == Self::integer(1) { above } else { above.div(&below) };
        if exact.pi_power == 0 { rational } else { rational.mul(&Self::PI.powi(i32::from(exact.pi_power))) }
    }

    fn integer(value: i64) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "the loss is the second of the pair")]
        let high = value as f64;
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "both are small integers")]
        let low = (i128::from(value) - high as i128) as f64;
        Self { high, low, error: 0.0 }
    }

    fn point(value: f64) -> Self {
        Self::settle((value, 0.0), 0.0, 0.0)
    }

    fn not_real() -> Self {
        Self::NOT_REAL
    }

    fn add(&self, other: &Self) -> Self {
        if let Some(lost) = self.lost(other) {
            return lost;
        }
        let (high, low) = sum(self.high, other.high);
        let (tail, rest) = sum(self.low, other.low);
        let (high, low) = ordered_sum(high, low + tail);
        Self::settle(ordered_sum(high, rest + low), self.error + other.error, SUM)
    }

    fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    fn mul(&self, other: &Self) -> Self {
        // Nothing times what is unbounded stays so: the other may be a quotient that has no value.
        if let Some(lost) = self.lost(other) {
            return lost;
        }
        let (high, low) = product(self.high, other.high);
        let cross = self.low.mul_add(other.high, self.high.mul_add(other.low, self.low * other.low));
        let spread = self.high.abs() * other.error + other.high.abs() * self.error + self.error * other.error;
        Self::settle(ordered_sum(high, low + cross), spread, PRODUCT)
    }

    fn div(&self, other: &Self) -> Self {
        if other.is_nothing() {
            return Self::NOT_REAL;
        }
        if let Some(lost) = self.lost(other) {
            return lost;
        }
        let least = (other.high.abs() - other.error) * (1.0 - 4.0 * UNIT);
        if least <= 0.0 {
            return Self::UNBOUNDED;
        }
        if self.is_nothing() {
            return Self::ZERO;
        }
        let first = self.high / other.high;
        let (high, low) = product(other.high, first);
        let (high, low) = ordered_sum(high, other.low.mul_add(first, low));
        let second = ((self.high - high) + (self.low - low)) / other.high;
        let spread = (self.error + first.abs() * GROWTH * other.error) / least;
        Self::settle(ordered_sum(first, second), spread, QUOTIENT)
    }

    fn neg(&self) -> Self {
        Self { high: -self.high, low: -self.low, error: self.error }
    }

    fn sqrt(&self) -> Self {
        match self.sign() {
            Sign::Zero => return Self::ZERO,
            Sign::Negative | Sign::NotReal => return Self::NOT_REAL,
            Sign::Unsure => return Self::UNBOUNDED,
            Sign::Positive => {}
        }
        let high = self.high.sqrt();
        let low = (self.low + high.mul_add(-high, self.high)) / (2.0 * high);
        // The slope of the root is steepest where the true value is least.
        let least = ((self.high - self.error) * (1.0 - 4.0 * UNIT)).max(0.0).sqrt();
        Self::settle(ordered_sum(high, low), self.error / (high + least), ROOT)
    }

    fn apply(&self, function: Function) -> Self {
        match function {
            _ if !self.is_real() => Self::NOT_REAL,
            Function::Abs if self.high < 0.0 => self.neg(),
            Function::Abs => *self,
            _ => Self::UNBOUNDED,
        }
    }

    fn atan2(&self, x: &Self) -> Self {
        self.lost(x).unwrap_or(Self::UNBOUNDED)
    }

    fn hull(&self, other: &Self) -> Self {
        let half = |own: &Self| Self { high: 0.5 * own.high, low: 0.5 * own.low, error: 0.5 * own.error };
        let (middle, apart) = (half(self).add(&half(other)), half(self).sub(&half(other)));
        let reach = (apart.high.abs() * GROWTH + apart.error) + self.error.max(other.error);
        if middle.is_real() { Self { error: (middle.error + reach) * GROWTH, ..middle } } else { middle }
    }

    fn centre(&self) -> Self {
        Self { error: if self.is_unbounded() { f64::INFINITY } else { 0.0 }, ..*self }
    }

    fn sign(&self) -> Sign {
        Bounded { value: self.high, error: self.error * GROWTH }.sign()
    }

    fn to_bounded(&self) -> Bounded {
        if self.low == 0.0 && self.error == 0.0 {
            return Bounded::exactly(self.high);
        }
        // The first of the pair is the double nearest to both.
        Bounded::rounded(self.high, self.error)
    }

    fn is_unbounded(&self) -> bool {
        self.error == f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::super::Precise;
    use super::*;
    use crate::quantity::Rational;

    /// How far the pair is from the truth: not certainly further than its bound.
    fn covers(pair: &Doubled, truth: &Precise) -> bool {
        let value = Precise::point(pair.high).add(&Precise::point(pair.low));
        let distance = value.sub(truth).apply(Function::Abs);
        pair.is_unbounded() || distance.sub(&Precise::point(pair.error)).sign() != Sign::Positive
    }

    fn applied<R: Real>(operation: usize, one: &R, other: &R) -> R {
        match operation {
            0 => one.add(other),
            1 => one.sub(other),
            2 => one.mul(other),
            3 => one.div(other),
            _ => one.sqrt(),
        }
    }

    const OPERATIONS: usize = 5;

    proptest! {
        #[test]
        fn every_bound_is_true_and_every_sign(
            starts in vec((-99_999_i64..=99_999, -8_i8..=8, 0..4_i8), 2..5),
            steps in vec((0..OPERATIONS, 0..20_usize, 0..20_usize), 1..14),
        ) {
            let exact = |(digits, power, pi): &(i64, i8, i8)| {
                let power = Rational::from(10).pow(isize::from(*power));
                Exact { rational: Rational::from(*digits) * power, pi_power: i8::from(*pi == 0) }
            };
            let exact: Vec<Exact> = starts.iter().map(exact).collect();
            let mut pairs: Vec<Doubled> = exact.iter().map(Doubled::from_exact).collect();
            let mut truths: Vec<Precise> = exact.iter().map(Precise::from_exact).collect();
            for (operation, one, other) in steps {
                let (one, other) = (one % pairs.len(), other % pairs.len());
                pairs.push(applied(operation, &pairs[one], &pairs[other]));
                truths.push(applied(operation, &truths[one], &truths[other]));
            }
            for (pair, truth) in pairs.iter().zip(&truths).filter(|(_, truth)| !truth.is_unbounded()) {
                prop_assert!(covers(pair, truth), "{:?} is not {:?}", pair, truth.decimal(50));
                prop_assert!([truth.sign(), Sign::Unsure].contains(&pair.sign()) || truth.sign() == Sign::Unsure);
            }
        }

        #[test]
        fn one_operation_keeps_thirty_digits(one in 1..i64::MAX, other in 1..i64::MAX, operation in 0..OPERATIONS) {
            let pair = applied(operation, &Doubled::integer(one), &Doubled::integer(other));
            prop_assert!(pair.error <= 1e-30 * pair.high.abs(), "{:?}", pair);
        }

        #[test]
        fn a_hull_covers_both(one in any::<i32>(), other in 1..i32::MAX) {
            let third = |value: i32| Exact::from(Rational::from(value) / Rational::from(3));
            let (one, other) = (third(one), third(other));
            let hull = Doubled::from_exact(&one).hull(&Doubled::from_exact(&other));
            prop_assert!(covers(&hull, &Precise::from_exact(&one)) && covers(&hull, &Precise::from_exact(&other)));
        }
    }
}
