//! Polynomials with rational coefficients in any number of atoms, bounded in size.

use std::collections::{BTreeMap, BTreeSet};

use dashu::base::{Gcd, Sign};

use crate::quantity::Rational;

use super::monomial::{Atom, Monomial};

/// Products with more pairs of terms than this are not formed.
const MAX_PAIRS: usize = 20_000;
/// Polynomials with more terms than this are not kept.
const MAX_TERMS: usize = 2_000;

/// A sum of monomials with their coefficients, none of them zero.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub(super) struct Polynomial(BTreeMap<Monomial, Rational>);

impl Polynomial {
    /// A number.
    pub(super) fn constant(value: Rational) -> Self {
        Self::term(value, Monomial::default())
    }

    /// One.
    pub(super) fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// One atom.
    pub(super) fn atom(atom: Atom) -> Self {
        Self::term(Rational::ONE, Monomial::atom(atom, 1))
    }

    /// One monomial with its coefficient.
    pub(super) fn term(coefficient: Rational, monomial: Monomial) -> Self {
        let mut single = Self::default();
        single.add_term(monomial, coefficient);
        single
    }

    fn add_term(&mut self, monomial: Monomial, coefficient: Rational) {
        if coefficient.is_zero() {
            return;
        }
        match self.0.entry(monomial) {
            std::collections::btree_map::Entry::Vacant(free) => {
                free.insert(coefficient);
            }
            std::collections::btree_map::Entry::Occupied(mut taken) => {
                *taken.get_mut() += coefficient;
                if taken.get().is_zero() {
                    taken.remove();
                }
            }
        }
    }

    /// The terms, in increasing lexicographic order.
    pub(super) fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// How many terms there are.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is zero.
    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it is one.
    pub(super) fn is_one(&self) -> bool {
        let only = self.0.first_key_value().filter(|_| self.len() == 1);
        only.is_some_and(|(monomial, value)| monomial.is_one() && value.is_one())
    }

    /// Its value, where it is a number.
    pub(super) fn as_constant(&self) -> Option<Rational> {
        match self.0.first_key_value() {
            None => Some(Rational::ZERO),
            Some((monomial, value)) => (self.len() == 1 && monomial.is_one()).then(|| value.clone()),
        }
    }

    /// The greatest term in lexicographic order.
    pub(super) fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.0.last_key_value()
    }

    /// Every atom that occurs.
    pub(super) fn atoms(&self) -> BTreeSet<&Atom> {
        self.0.keys().flat_map(Monomial::powers).map(|(atom, _)| atom).collect()
    }

    /// The sum.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in other.terms() {
            sum.add_term(monomial.clone(), coefficient.clone());
        }
        sum
    }

    /// Adds another.
    pub(super) fn add(&mut self, other: Self) {
        for (monomial, coefficient) in other.0 {
            self.add_term(monomial, coefficient);
        }
    }

    /// The product with a term.
    pub(super) fn scaled(&self, factor: &Rational, by: &Monomial) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        if by.is_one() {
            return Self(self.terms().map(|(own, value)| (own.clone(), product(value, factor))).collect());
        }
        Self(self.terms().map(|(own, value)| (own.times(by), product(value, factor))).collect())
    }

    /// The negative.
    pub(super) fn negated(&self) -> Self {
        Self(self.terms().map(|(own, value)| (own.clone(), -value.clone())).collect())
    }

    /// The product; `None` where it would be too large.
    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        if self.len() * other.len() > MAX_PAIRS {
            return None;
        }
        let mut product = Self::default();
        for (monomial, coefficient) in self.terms() {
            for (by, factor) in other.terms() {
                product.add_term(monomial.times(by), self::product(coefficient, factor));
            }
        }
        (product.len() <= MAX_TERMS).then_some(product)
    }

    /// A power; `None` where it would be too large.
    pub(super) fn power(&self, exponent: u32) -> Option<Self> {
        if let (1, Some((monomial, coefficient))) = (self.len(), self.leading())
            && exponent > 64
            && !coefficient.is_one()
            && monomial.is_one()
        {
            return None;
        }
        let mut power = Self::one();
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            power = power.times(&power)?;
            if exponent >> bit & 1 == 1 {
                power = power.times(self)?;
            }
        }
        Some(power)
    }

    /// The coefficients of the powers of one atom; an empty map for zero.
    pub(super) fn coefficients(&self, atom: &Atom) -> BTreeMap<i32, Self> {
        let mut found: BTreeMap<i32, Self> = BTreeMap::new();
        for (monomial, coefficient) in self.terms() {
            let (_, rest) = monomial.partition(|own| own == atom);
            found.entry(monomial.exponent(atom)).or_default().add_term(rest, coefficient.clone());
        }
        found
    }

    /// In how many terms each power of one atom stands.
    pub(super) fn spread(&self, atom: &Atom) -> BTreeMap<i32, usize> {
        let mut found = BTreeMap::new();
        for (monomial, _) in self.terms() {
            *found.entry(monomial.exponent(atom)).or_default() += 1;
        }
        found
    }

    /// The derivative with respect to one atom, all others held.
    pub(super) fn derivative(&self, atom: &Atom) -> Self {
        let mut derivative = Self::default();
        for (monomial, coefficient) in self.terms() {
            let exponent = monomial.exponent(atom);
            let lowered = monomial.over(&Monomial::atom(atom.clone(), 1));
            derivative.add_term(lowered, coefficient * Rational::from(exponent));
        }
        derivative
    }

    /// The positive number and the monomial that all terms have in common, so that whole coprime coefficients remain.
    pub(super) fn content(&self) -> (Rational, Monomial) {
        let mut terms = self.terms();
        let Some((first, value)) = terms.next() else { return (Rational::ONE, Monomial::default()) };
        let mut numerator = value.numerator().unsigned_abs_value();
        let mut denominator = value.denominator().clone();
        let mut common = first.clone();
        for (monomial, value) in terms {
            if !numerator.is_one() {
                numerator = numerator.gcd(value.numerator().unsigned_abs_value());
            }
            if !value.denominator().is_one() {
                let shared = (&denominator).gcd(value.denominator());
                denominator = denominator / shared * value.denominator();
            }
            if !common.is_one() {
                common = common.common(monomial);
            }
        }
        (Rational::from_parts(numerator.into(), denominator), common)
    }

    /// The quotient by a term.
    pub(super) fn over(&self, number: &Rational, by: &Monomial) -> Self {
        if number.is_zero() {
            return Self::default();
        }
        if number.is_one() && by.is_one() {
            return self.clone();
        }
        let value = |value: &Rational| if number.is_one() { value.clone() } else { value / number };
        Self(self.terms().map(|(own, own_value)| (own.over(by), value(own_value))).collect())
    }

    /// Content and primitive part; the sign stays with the latter.
    pub(super) fn primitive(&self) -> (Rational, Monomial, Self) {
        let (number, monomial) = self.content();
        let rest = self.over(&number, &monomial);
        (number, monomial, rest)
    }

    /// Whether the leading coefficient is negative.
    pub(super) fn is_negative(&self) -> bool {
        self.leading().is_some_and(|(_, value)| value.sign() == Sign::Negative)
    }

    /// The exact quotient; `None` where a remainder would be left. Both must be free of negative exponents.
    pub(super) fn divided(&self, by: &Self) -> Option<Self> {
        let (lead, divisor) = by.leading()?;
        let mut rest = self.clone();
        let mut quotient = Self::default();
        while let Some((monomial, value)) = rest.leading() {
            let by_monomial = monomial.over(lead);
            if !by_monomial.is_whole() || (quotient.len() + 1) * by.len() > MAX_PAIRS {
                return None;
            }
            let factor = value / divisor;
            for (own, value) in by.terms() {
                rest.add_term(own.times(&by_monomial), -(value * &factor));
            }
            quotient.add_term(by_monomial, factor);
        }
        Some(quotient)
    }
}

/// The product of two numbers; most are one.
fn product(left: &Rational, right: &Rational) -> Rational {
    if left.is_one() {
        right.clone()
    } else if right.is_one() {
        left.clone()
    } else {
        left * right
    }
}

/// The absolute value as a natural number.
trait UnsignedAbs {
    fn unsigned_abs_value(&self) -> dashu::Natural;
}

impl UnsignedAbs for dashu::Integer {
    fn unsigned_abs_value(&self) -> dashu::Natural {
        self.clone().into_parts().1
    }
}
