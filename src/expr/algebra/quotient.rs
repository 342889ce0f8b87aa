//! Quotients of polynomials, kept in lowest terms as far as the bounds allow.

use momentous_quantity::Rational;

use super::gcd::{Work, gcd};
use super::monomial::{Atom, Monomial};
use super::polynomial::Polynomial;

/// A quotient of two polynomials; the denominator is never zero, and has whole coprime coefficients and a positive leading term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Quotient {
    /// The dividend.
    pub(crate) numerator: Polynomial,
    /// The divisor.
    pub(crate) denominator: Polynomial,
}

impl From<Polynomial> for Quotient {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

impl Quotient {
    /// A number.
    pub(crate) fn constant(value: Rational) -> Self {
        Polynomial::constant(value).into()
    }

    /// Zero.
    pub(crate) fn zero() -> Self {
        Self::constant(Rational::ZERO)
    }

    /// One.
    pub(crate) fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// An atom.
    pub(super) fn atom(atom: Atom) -> Self {
        Polynomial::atom(atom).into()
    }

    /// A number times powers of atoms.
    pub(crate) fn term(number: Rational, monomial: &Monomial) -> Self {
        if number.is_zero() {
            return Self::zero();
        }
        let (above, below) = above_and_below(monomial);
        Self { numerator: Polynomial::term(number, above), denominator: Polynomial::term(Rational::ONE, below) }
    }

    /// The quotient in lowest terms; `None` where the denominator is zero.
    pub(super) fn reduced(numerator: &Polynomial, denominator: &Polynomial) -> Option<Self> {
        if denominator.is_zero() {
            return None;
        }
        if numerator.is_zero() {
            return Some(Self::zero());
        }
        if denominator.is_one() {
            return Some(numerator.clone().into());
        }
        let (mut above, mut below) = (numerator.primitive(), denominator.primitive());
        // Of a single term no sum is a factor.
        if numerator.len() > 1 && denominator.len() > 1 {
            let divisor = gcd(&above.2, &below.2, &mut Work::default());
            if divisor.len() > 1
                && let (Some(numerator), Some(denominator)) = (above.2.divided(&divisor), below.2.divided(&divisor))
            {
                (above.2, below.2) = (numerator, denominator);
            }
        }
        Some(Self::written(above, below))
    }

    /// The quotient of two polynomials, each as content and primitive part, that share no sum as a factor.
    fn written(above: (Rational, Monomial, Polynomial), below: (Rational, Monomial, Polynomial)) -> Self {
        let (above_part, below_part) = above_and_below(&above.1.over(&below.1));
        let number = if below.0.is_one() { above.0 } else { above.0 / below.0 };
        let (number, sign) = if below.2.is_negative() { (-number, Rational::NEG_ONE) } else { (number, Rational::ONE) };
        Self { numerator: above.2.scaled(&number, &above_part), denominator: below.2.scaled(&sign, &below_part) }
    }

    /// Its value, where it is a number.
    pub(super) fn as_constant(&self) -> Option<Rational> {
        if self.denominator.as_constant()?.is_one() { self.numerator.as_constant() } else { None }
    }

    /// The polynomial, where the denominator is one.
    pub(super) fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.as_constant()?.is_one().then_some(&self.numerator)
    }

    /// The atom and its exponent, where it is a power of one.
    pub(super) fn as_atom_power(&self) -> Option<(&Atom, i32)> {
        let (monomial, coefficient) = self.as_polynomial()?.leading()?;
        let mut powers = monomial.powers();
        let first = powers.next()?;
        (self.numerator.len() == 1 && coefficient.is_one() && powers.next().is_none()).then_some(first)
    }

    /// Whether neither has a denominator, so that there is nothing to reduce.
    fn are_whole(&self, other: &Self) -> bool {
        self.denominator.is_one() && other.denominator.is_one()
    }

    /// The sum of some; `None` where one is missing, or it would be too large.
    pub(crate) fn sum(terms: impl Iterator<Item = Option<Self>>) -> Option<Self> {
        let mut parts: Vec<(Self, bool)> = Vec::new();
        for term in terms {
            let term = term?;
            match parts.iter_mut().find(|(part, _)| part.denominator == term.denominator) {
                Some((part, joined)) => {
                    part.numerator.add(term.numerator);
                    *joined = true;
                }
                None => parts.push((term, false)),
            }
        }
        let lowest = parts.into_iter().map(|(part, joined)| {
            if joined && !part.denominator.is_one() {
                Self::reduced(&part.numerator, &part.denominator)
            } else {
                Some(part)
            }
        });
        lowest.reduce(|sum, part| sum?.plus(&part?)).unwrap_or_else(|| Some(Self::zero()))
    }

    /// The sum; `None` where it would be too large.
    pub(crate) fn plus(&self, other: &Self) -> Option<Self> {
        if self.are_whole(other) {
            return Some(self.numerator.plus(&other.numerator).into());
        }
        if self.denominator == other.denominator {
            return Self::reduced(&self.numerator.plus(&other.numerator), &self.denominator);
        }
        let left = self.numerator.times(&other.denominator)?;
        let right = other.numerator.times(&self.denominator)?;
        Self::reduced(&left.plus(&right), &self.denominator.times(&other.denominator)?)
    }

    /// The negative.
    pub(super) fn negated(&self) -> Self {
        Self { numerator: self.numerator.negated(), denominator: self.denominator.clone() }
    }

    /// The product; `None` where it would be too large.
    pub(crate) fn times(&self, other: &Self) -> Option<Self> {
        if self.are_whole(other) {
            return self.numerator.times(&other.numerator).map(Self::from);
        }
        // Each is in lowest terms, so that only one's numerator and the other's denominator share factors.
        let left = Self::reduced(&self.numerator, &other.denominator)?;
        let right = Self::reduced(&other.numerator, &self.denominator)?;
        let (numerator, denominator) =
            (left.numerator.times(&right.numerator)?, left.denominator.times(&right.denominator)?);
        Some(if numerator.is_zero() { Self::zero() } else { Self { numerator, denominator } })
    }

    /// The product with a number.
    pub(crate) fn scaled(&self, factor: &Rational) -> Self {
        let numerator = self.numerator.scaled(factor, &Monomial::default());
        Self { denominator: if numerator.is_zero() { Polynomial::one() } else { self.denominator.clone() }, numerator }
    }

    /// The inverse; `None` for zero.
    pub(crate) fn inverse(&self) -> Option<Self> {
        (!self.numerator.is_zero()).then(|| Self::written(self.denominator.primitive(), self.numerator.primitive()))
    }

    /// An integer power; `None` where it would be too large, or divide by zero.
    pub(crate) fn power(&self, exponent: i32) -> Option<Self> {
        let size = exponent.unsigned_abs();
        let power = Self { numerator: self.numerator.power(size)?, denominator: self.denominator.power(size)? };
        if exponent < 0 { power.inverse() } else { Some(power) }
    }
}

/// The factors above and below the bar, both without negative powers but those of atoms that are never zero.
fn above_and_below(monomial: &Monomial) -> (Monomial, Monomial) {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for (atom, power) in monomial.powers() {
        if power < 0 && !is_unit(atom) {
            below.push((atom.clone(), power.saturating_neg()));
        } else {
            above.push((atom.clone(), power));
        }
    }
    (Monomial::product(above), Monomial::product(below))
}

/// Whether an atom is never zero, so that its negative powers may stay in a numerator.
pub(super) fn is_unit(atom: &Atom) -> bool {
    matches!(atom, Atom::Apply(super::super::Function::Exp, _))
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;

    #[test]
    fn the_greatest_powers_keep_their_value() {
        for text in ["x^(-2147483648)", "x^(-2147483648)/x", "x^2147483647*x", "1/x^2147483647/x^2"] {
            let simple = AnyName::default().term(text).simplify();
            assert!((simple.evaluate(&|_| 1.0) - 1.0).abs() < f64::EPSILON, "{text}: {simple:?}");
        }
    }
}
