//! Quotients of polynomials, kept in lowest terms as far as the bounds allow.

use crate::quantity::Rational;

use super::gcd::{Work, gcd};
use super::monomial::{Atom, Monomial};
use super::polynomial::Polynomial;

/// A quotient of two polynomials; the denominator is never zero, and has whole coprime coefficients and a positive leading term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Quotient {
    /// What is divided.
    pub(super) numerator: Polynomial,
    /// What it is divided by.
    pub(super) denominator: Polynomial,
}

impl From<Polynomial> for Quotient {
    fn from(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

impl Quotient {
    /// A number.
    pub(super) fn constant(value: Rational) -> Self {
        Polynomial::constant(value).into()
    }

    /// Zero.
    pub(super) fn zero() -> Self {
        Self::constant(Rational::ZERO)
    }

    /// One.
    pub(super) fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// An atom.
    pub(super) fn atom(atom: Atom) -> Self {
        Polynomial::atom(atom).into()
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
        let (above, above_monomial, mut numerator) = numerator.primitive();
        let (below, below_monomial, mut denominator) = denominator.primitive();
        let divisor = gcd(&numerator, &denominator, &mut Work::default());
        if divisor.len() > 1
            && let (Some(above), Some(below)) = (numerator.divided(&divisor), denominator.divided(&divisor))
        {
            (numerator, denominator) = (above, below);
        }
        let sign = if denominator.is_negative() { Rational::NEG_ONE } else { Rational::ONE };
        let monomial = above_monomial.over(&below_monomial);
        let below_part: Vec<_> = monomial.powers().filter(|(atom, power)| *power < 0 && !is_unit(atom)).collect();
        let below_part = below_part
            .into_iter()
            .fold(Monomial::default(), |part, (atom, power)| part.times(&Monomial::atom(atom.clone(), -power)));
        let above_part = monomial.times(&below_part);
        Some(Self {
            numerator: numerator.scaled(&(above / below * &sign), &above_part),
            denominator: denominator.scaled(&sign, &below_part),
        })
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

    /// The sum; `None` where it would be too large.
    pub(super) fn plus(&self, other: &Self) -> Option<Self> {
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
    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        if self.are_whole(other) {
            return self.numerator.times(&other.numerator).map(Self::from);
        }
        let denominator = self.denominator.times(&other.denominator)?;
        Self::reduced(&self.numerator.times(&other.numerator)?, &denominator)
    }

    /// The product with a number.
    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        let numerator = self.numerator.scaled(factor, &Monomial::default());
        Self { denominator: if numerator.is_zero() { Polynomial::one() } else { self.denominator.clone() }, numerator }
    }

    /// The inverse; `None` for zero.
    pub(super) fn inverse(&self) -> Option<Self> {
        Self::reduced(&self.denominator, &self.numerator)
    }

    /// An integer power; `None` where it would be too large, or divide by zero.
    pub(super) fn power(&self, exponent: i32) -> Option<Self> {
        let size = exponent.unsigned_abs();
        let power = Self { numerator: self.numerator.power(size)?, denominator: self.denominator.power(size)? };
        if exponent < 0 { power.inverse() } else { Some(power) }
    }
}

/// Whether an atom is never zero, so that its negative powers may stay in a numerator.
pub(super) fn is_unit(atom: &Atom) -> bool {
    matches!(atom, Atom::Apply(super::Function::Exp, _))
}
