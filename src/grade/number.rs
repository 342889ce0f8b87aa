//! A number as marking knows it: exact as long as it can be.

use std::borrow::Cow;

use dashu::base::{Abs, BitTest, Sign};

use momentous_quantity::Decimal;
use momentous_quantity::Factor;
use momentous_quantity::Integer;
use momentous_quantity::Rational;
use momentous_quantity::nearest_double;

/// The most binary digits above or below the fraction bar: enough for every number of 40 digits times 10^400, and a few products of them.
const MAX_BITS: usize = 8192;
/// One in so many is how far double precision may have moved a number that passed through a few irrational functions.
const DOUBLE_SLACK: u64 = 1_000_000_000_000;

/// A number, and whether it is exact or went through double precision (a root, a sine, pi).
///
/// Every operation is bounded in time and memory and answers `None` where its result would be too large, or is not a number.
#[derive(Clone, Debug)]
pub struct Number {
    value: Value,
    /// The double nearest to it: most comparisons need no more.
    near: f64,
    exact: bool,
}

/// An exact value. Most are decimals of few digits, as they were written, and are never calculated with.
#[derive(Clone, Debug)]
enum Value {
    /// Digits that a double holds, and how many of them stand behind the point.
    Decimal(i64, u32),
    Rational(Rational),
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.exact == other.exact && self.value() == other.value()
    }
}

impl Eq for Number {}

impl From<&Decimal> for Number {
    fn from(decimal: &Decimal) -> Self {
        match decimal.few_digits() {
            Some((digits, scale)) => Self { value: Value::Decimal(digits, scale), near: decimal.to_f64(), exact: true },
            None => Self::exact(decimal.to_rational()),
        }
    }
}

impl Number {
    /// An exact number.
    #[must_use]
    pub fn exact(value: Rational) -> Self {
        Self::new(value, true)
    }

    fn new(value: Rational, exact: bool) -> Self {
        Self { near: nearest_double(&value), value: Value::Rational(value), exact }
    }

    /// A number known to double precision; `None` where it is not finite.
    #[must_use]
    pub fn rounded(value: f64) -> Option<Self> {
        let exact = Rational::try_from(value).ok()?;
        Some(Self { value: Value::Rational(exact), near: value, exact: false })
    }

    /// Its value: the exact one, or the double that stands for it.
    #[must_use]
    pub fn value(&self) -> Cow<'_, Rational> {
        match &self.value {
            Value::Rational(value) => Cow::Borrowed(value),
            Value::Decimal(digits, scale) => {
                Cow::Owned(Decimal::from_scaled(i128::from(*digits), *scale).to_rational())
            }
        }
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.near
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match &self.value {
            Value::Rational(value) => value.is_zero(),
            Value::Decimal(digits, _) => *digits == 0,
        }
    }

    /// Whether it is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        match &self.value {
            Value::Rational(value) => !value.is_zero() && value.sign() == Sign::Negative,
            Value::Decimal(digits, _) => *digits < 0,
        }
    }

    /// How far the number that was meant may lie from [`Number::value`].
    #[must_use]
    pub fn slack(&self) -> Rational {
        if self.exact {
            return Rational::ZERO;
        }
        self.value().into_owned().abs() / Rational::from(DOUBLE_SLACK)
    }

    /// The opposite number.
    #[must_use]
    pub fn negated(self) -> Self {
        let value = match self.value {
            Value::Rational(value) => Value::Rational(-value),
            Value::Decimal(digits, scale) => Value::Decimal(-digits, scale),
        };
        Self { value, near: -self.near, ..self }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Option<Self> {
        self.with(other, |left, right| left + right)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Option<Self> {
        self.with(other, |left, right| left - right)
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Option<Self> {
        self.with(other, |left, right| left * right)
    }

    /// The quotient; `None` also where the divisor is zero.
    #[must_use]
    pub fn over(&self, other: &Self) -> Option<Self> {
        if other.is_zero() { None } else { self.with(other, |left, right| left / right) }
    }

    /// The product with the size of a unit: exact but for pi.
    #[must_use]
    pub fn scaled(&self, factor: &Factor) -> Option<Self> {
        match factor.pi {
            0 if factor.rational.is_one() => Some(self.clone()),
            0 => self.times(&Self::exact(factor.rational.clone())),
            _ => self.times(&Self::rounded(factor.to_f64())?),
        }
    }

    /// The power. Exact where the exponent is whole; otherwise only of what is not negative.
    #[must_use]
    pub fn power(&self, exponent: &Self) -> Option<Self> {
        let whole = exponent.value();
        if whole.is_int() {
            let whole = isize::try_from(whole.numerator()).ok()?;
            if self.is_zero() {
                return if whole < 0 {
                    None
                } else {
                    Some(Self::exact(if whole == 0 { Rational::ONE } else { Rational::ZERO }))
                };
            }
            if self.bits().checked_mul(whole.unsigned_abs())? > MAX_BITS {
                return None;
            }
            return Self::new(self.value().pow(whole), self.exact && exponent.exact).bounded();
        }
        if self.is_negative() {
            return None;
        }
        Self::rounded(libm::pow(self.to_f64(), exponent.to_f64()))
    }

    /// The square root; exact where it is rational with not too many figures. `None` of what is negative.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        if self.is_negative() {
            return None;
        }
        let exact = || {
            let value = self.value();
            let above = integer_root(value.numerator())?;
            let below = integer_root(&Integer::from(value.denominator().clone()))?;
            Some(Self::new(Rational::from(above) / Rational::from(below), self.exact))
        };
        exact().or_else(|| Self::rounded(self.to_f64().sqrt()))
    }

    /// Through a function of doubles; `None` where the function has no finite value there.
    #[must_use]
    pub fn through(&self, function: fn(f64) -> f64) -> Option<Self> {
        Self::rounded(function(self.to_f64()))
    }

    fn with(&self, other: &Self, operation: fn(Rational, Rational) -> Rational) -> Option<Self> {
        let value = operation(self.value().into_owned(), other.value().into_owned());
        Self::new(value, self.exact && other.exact).bounded()
    }

    fn bits(&self) -> usize {
        let value = self.value();
        value.numerator().bit_len().max(value.denominator().bit_len())
    }

    fn bounded(self) -> Option<Self> {
        (self.bits() <= MAX_BITS).then_some(self)
    }
}

/// The square root of a perfect square, up to where doubles are whole.
fn integer_root(square: &Integer) -> Option<Integer> {
    let root = Integer::from(u64::try_from(i128::try_from(square).ok()?).ok()?.isqrt());
    (&root * &root == *square).then_some(root)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // a test may panic
mod tests {
    use super::*;

    fn ratio(above: i64, below: i64) -> Number {
        Number::exact(Rational::from(above) / Rational::from(below))
    }

    #[test]
    fn stays_exact_while_it_can() {
        assert_eq!(ratio(9, 4).square_root(), Some(ratio(3, 2)));
        assert_eq!(ratio(2, 3).power(&ratio(-2, 1)), Some(ratio(9, 4)));
        assert!(ratio(1, 1).slack().is_zero());
        let root = ratio(2, 1).square_root().unwrap();
        assert!(!root.slack().is_zero() && root.to_f64().to_bits() == 2_f64.sqrt().to_bits());
    }

    #[test]
    fn a_decimal_is_its_rational() {
        for text in ["0", "-0.0", "2.50", "-13", "0.000001", "9007199254740991", "9007199254740993", "1e3", "1e-30"] {
            let decimal = Decimal::parse(text).unwrap();
            let (number, rational) = (Number::from(&decimal), Number::exact(decimal.to_rational()));
            assert_eq!(number, rational, "{text}");
            assert_eq!(number.to_f64().to_bits(), rational.to_f64().to_bits(), "{text}");
            assert_eq!(
                (number.is_zero(), number.is_negative()),
                (rational.is_zero(), rational.is_negative()),
                "{text}"
            );
            assert_eq!(number.negated(), rational.negated(), "{text}");
        }
    }

    #[test]
    fn refuses_what_is_no_number_or_too_large() {
        assert_eq!(ratio(1, 1).over(&ratio(0, 1)), None);
        assert_eq!(ratio(0, 1).power(&ratio(-1, 1)), None);
        assert_eq!(ratio(-1, 1).square_root(), None);
        assert_eq!(ratio(-1, 1).power(&ratio(1, 2)), None);
        assert_eq!(ratio(9, 1).power(&ratio(i64::MAX, 1)), None);
        assert_eq!(ratio(9, 1).power(&ratio(387_420_489, 1)), None);
        assert_eq!(ratio(10, 1).power(&ratio(1001, 2)), None);
    }
}
