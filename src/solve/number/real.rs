//! The numbers of a tape: they know how far from the truth they may be.

use momentous_expr::Function;

use super::super::Exact;
use super::bounded::Bounded;

/// The sign of a true value, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Less than zero.
    Negative,
    /// Zero, exactly.
    Zero,
    /// Greater than zero.
    Positive,
    /// Zero is among the possible values.
    Unsure,
    /// There is no real value.
    NotReal,
}

/// A number with a bound on its error. Every operation returns a bound that holds if those of its operands do.
///
/// Two states besides ordinary values: *unbounded* (a value exists as far as is known, but nothing bounds it) and
/// *not real* (there is no value: the root of a negative number, a division by exactly zero); the latter spreads.
pub trait Real: Clone {
    /// The relative spacing of the numbers that are computed with.
    const SPACING: f64;

    /// A given.
    fn from_exact(exact: &Exact) -> Self;
    /// An integer.
    fn integer(value: i64) -> Self;
    /// A number that is taken as it stands.
    fn point(value: f64) -> Self;
    /// No real value.
    fn not_real() -> Self;

    /// The sum.
    #[must_use]
    fn add(&self, other: &Self) -> Self;
    /// The difference.
    #[must_use]
    fn sub(&self, other: &Self) -> Self;
    /// The product.
    #[must_use]
    fn mul(&self, other: &Self) -> Self;
    /// The quotient.
    #[must_use]
    fn div(&self, other: &Self) -> Self;
    /// The negative.
    #[must_use]
    fn neg(&self) -> Self;
    /// The square root.
    #[must_use]
    fn sqrt(&self) -> Self;
    /// A function of one argument; `Atan2` takes (y, x) and has [`Real::atan2`].
    #[must_use]
    fn apply(&self, function: Function) -> Self;
    /// The angle of the point (`x`, `self`), from -pi (excluded) to pi.
    #[must_use]
    fn atan2(&self, x: &Self) -> Self;
    /// A value that covers everything that either may be.
    #[must_use]
    fn hull(&self, other: &Self) -> Self;
    /// The middle, without its error: a number that is taken as it stands.
    #[must_use]
    fn centre(&self) -> Self;

    /// The sign, as far as it is known.
    fn sign(&self) -> Sign;
    /// Rounded to floating point, with a bound that covers the rounding.
    fn to_bounded(&self) -> Bounded;
    /// About how large the value is.
    fn rough(&self) -> f64 {
        self.to_bounded().value
    }
    /// Whether nothing bounds the value.
    fn is_unbounded(&self) -> bool;
    /// Whether there is a real value, as far as is known.
    fn is_real(&self) -> bool {
        self.sign() != Sign::NotReal
    }

    /// An integer power, by repeated squaring.
    #[must_use]
    fn powi(&self, exponent: i32) -> Self {
        let mut rest = exponent.unsigned_abs();
        let mut square = self.clone();
        let mut power: Option<Self> = None;
        while rest > 0 {
            if rest & 1 == 1 {
                power = Some(power.map_or_else(|| square.clone(), |power| power.mul(&square)));
            }
            rest >>= 1;
            if rest > 0 {
                square = square.mul(&square);
            }
        }
        let power = power.unwrap_or_else(|| Self::integer(1));
        if exponent < 0 { Self::integer(1).div(&power) } else { power }
    }

    /// The real root of that degree; of a negative number where the degree is odd.
    #[must_use]
    fn root(&self, degree: u32) -> Self {
        if degree == 2 {
            return self.sqrt();
        }
        let size = |value: &Self| value.apply(Function::Ln).div(&Self::integer(i64::from(degree))).apply(Function::Exp);
        match self.sign() {
            Sign::Zero => self.clone(),
            Sign::Negative if degree % 2 == 1 => size(&self.neg()).neg(),
            Sign::Negative | Sign::NotReal => Self::not_real(),
            Sign::Positive | Sign::Unsure => size(self),
        }
    }

    /// A power with any exponent, of a base that is not negative.
    #[must_use]
    fn raise(&self, exponent: &Self) -> Self {
        match (self.sign(), exponent.sign()) {
            (_, Sign::Zero) => Self::integer(1),
            (Sign::Zero, Sign::Positive) => self.clone(),
            _ => self.apply(Function::Ln).mul(exponent).apply(Function::Exp),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::{Bounded, Precise};
    use super::*;

    /// Nothing, times a quotient by what may be nothing.
    fn nothing_times_a_quotient<R: Real>() -> Sign {
        let euler = R::integer(1).apply(Function::Exp);
        R::integer(0).mul(&R::integer(1).div(&euler.sub(&euler))).sign()
    }

    #[test]
    fn nothing_times_what_may_have_no_value_is_not_known_to_be_nothing() {
        assert_eq!(nothing_times_a_quotient::<Bounded>(), Sign::Unsure);
        assert_eq!(nothing_times_a_quotient::<Precise>(), Sign::Unsure);
    }
}
