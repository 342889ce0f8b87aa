//! Polynomials with rational coefficients in any number of atoms, bounded in size.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use dashu::base::{Gcd, Sign};

use momentous_quantity::Rational;

use super::monomial::{Atom, Monomial};

/// Products with more pairs of terms than this are not formed.
const MAX_PAIRS: usize = 20_000;
/// Polynomials with more terms than this are not kept.
const MAX_TERMS: usize = 2_000;

/// A sum of distinct monomials in increasing lexicographic order, with their coefficients, none of them zero. The order stays when
/// all are multiplied by one monomial.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub(super) struct Polynomial(Vec<(Monomial, Rational)>);

impl Polynomial {
    /// A number.
    pub(crate) fn constant(value: Rational) -> Self {
        Self::term(value, Monomial::default())
    }

    /// One.
    pub(crate) fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// One atom.
    pub(super) fn atom(atom: Atom) -> Self {
        Self::term(Rational::ONE, Monomial::atom(atom, 1))
    }

    /// One monomial with its coefficient.
    pub(crate) fn term(coefficient: Rational, monomial: Monomial) -> Self {
        Self(if coefficient.is_zero() { Vec::new() } else { vec![(monomial, coefficient)] })
    }

    /// The sum of terms in any order.
    fn sum(mut terms: Vec<(Monomial, Rational)>) -> Self {
        terms.sort_by(|a, b| a.0.cmp(&b.0));
        terms.dedup_by(|later, earlier| {
            let alike = later.0 == earlier.0;
            if alike {
                earlier.1 += std::mem::take(&mut later.1);
            }
            alike
        });
        terms.retain(|(_, value)| !value.is_zero());
        Self(terms)
    }

    /// The terms, in increasing lexicographic order.
    pub(crate) fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.0.iter().map(|(monomial, value)| (monomial, value))
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether it is zero.
    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it is one.
    pub(crate) fn is_one(&self) -> bool {
        matches!(&self.0[..], [(monomial, value)] if monomial.is_one() && value.is_one())
    }

    /// Its value, where it is a number.
    pub(super) fn as_constant(&self) -> Option<Rational> {
        match &self.0[..] {
            [] => Some(Rational::ZERO),
            [(monomial, value)] if monomial.is_one() => Some(value.clone()),
            _ => None,
        }
    }

    /// The greatest term in lexicographic order.
    pub(super) fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.0.last().map(|(monomial, value)| (monomial, value))
    }

    /// Every atom that occurs.
    pub(crate) fn atoms(&self) -> BTreeSet<&Atom> {
        self.0.iter().flat_map(|(monomial, _)| monomial.powers()).map(|(atom, _)| atom).collect()
    }

    /// The sum.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add(other.clone());
        sum
    }

    /// Adds another.
    pub(crate) fn add(&mut self, other: Self) {
        let mut sum = Vec::with_capacity(self.len() + other.len());
        let mut terms = std::mem::take(&mut self.0).into_iter().peekable();
        let mut more = other.0.into_iter().peekable();
        loop {
            let order = match (terms.peek(), more.peek()) {
                (None, None) => break,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some((monomial, _)), Some((more, _))) => monomial.cmp(more),
            };
            match order {
                Ordering::Less => sum.extend(terms.next()),
                Ordering::Greater => sum.extend(more.next()),
                Ordering::Equal => {
                    let both =
                        terms.next().zip(more.next()).map(|((monomial, value), (_, other))| (monomial, value + other));
                    sum.extend(both.filter(|(_, value)| !value.is_zero()));
                }
            }
        }
        self.0 = sum;
    }

    /// The product with a term.
    pub(crate) fn scaled(&self, factor: &Rational, by: &Monomial) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        if by.is_one() {
            return Self(self.terms().map(|(monomial, value)| (monomial.clone(), product(value, factor))).collect());
        }
        Self(self.terms().map(|(monomial, value)| (monomial.times(by), product(value, factor))).collect())
    }

    /// The negative.
    pub(super) fn negated(&self) -> Self {
        Self(self.terms().map(|(monomial, value)| (monomial.clone(), -value.clone())).collect())
    }

    /// The product; `None` where it would be too large.
    pub(crate) fn times(&self, other: &Self) -> Option<Self> {
        if self.len() * other.len() > MAX_PAIRS {
            return None;
        }
        let product = match (&self.0[..], &other.0[..]) {
            ([(monomial, coefficient)], _) => other.scaled(coefficient, monomial),
            (_, [(monomial, coefficient)]) => self.scaled(coefficient, monomial),
            (terms, others) => {
                let pairs = terms.iter().flat_map(|term| others.iter().map(move |other| (term, other)));
                Self::sum(pairs.map(|(term, other)| (term.0.times(&other.0), product(&term.1, &other.1))).collect())
            }
        };
        (product.len() <= MAX_TERMS).then_some(product)
    }

    /// A power; `None` where it would be too large.
    pub(crate) fn power(&self, exponent: u32) -> Option<Self> {
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
    pub(crate) fn coefficients(&self, atom: &Atom) -> BTreeMap<i32, Self> {
        let mut coefficients: BTreeMap<i32, Self> = BTreeMap::new();
        for (monomial, coefficient) in self.terms() {
            let (_, rest) = monomial.partition(|base| base == atom);
            coefficients.entry(monomial.exponent(atom)).or_default().0.push((rest, coefficient.clone()));
        }
        coefficients
    }

    /// In how many terms each power of one atom stands.
    pub(crate) fn spread(&self, atom: &Atom) -> BTreeMap<i32, usize> {
        let mut counts = BTreeMap::new();
        for (monomial, _) in self.terms() {
            *counts.entry(monomial.exponent(atom)).or_default() += 1;
        }
        counts
    }

    /// The derivative with respect to one atom, all others held.
    pub(crate) fn derivative(&self, atom: &Atom) -> Self {
        let by = Monomial::atom(atom.clone(), 1);
        let lowered = self.terms().filter_map(|(monomial, coefficient)| {
            let exponent = monomial.exponent(atom);
            (exponent != 0).then(|| (monomial.over(&by), coefficient * Rational::from(exponent)))
        });
        Self(lowered.collect())
    }

    /// The positive number and the monomial that all terms have in common, so that whole coprime coefficients remain.
    pub(crate) fn content(&self) -> (Rational, Monomial) {
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
    pub(crate) fn over(&self, number: &Rational, by: &Monomial) -> Self {
        if number.is_zero() {
            return Self::default();
        }
        if number.is_one() && by.is_one() {
            return self.clone();
        }
        let value = |value: &Rational| if number.is_one() { value.clone() } else { value / number };
        Self(self.terms().map(|(monomial, coefficient)| (monomial.over(by), value(coefficient))).collect())
    }

    /// Content and primitive part; the sign stays with the latter.
    pub(super) fn primitive(&self) -> (Rational, Monomial, Self) {
        let (number, monomial) = self.content();
        let rest = self.over(&number, &monomial);
        (number, monomial, rest)
    }

    /// Whether the leading coefficient is negative.
    pub(crate) fn is_negative(&self) -> bool {
        self.leading().is_some_and(|(_, value)| value.sign() == Sign::Negative)
    }

    /// The exact quotient; `None` where a remainder would be left. Both must be free of negative exponents.
    pub(super) fn divided(&self, by: &Self) -> Option<Self> {
        let (lead, divisor) = by.leading()?;
        let mut rest = self.clone();
        let mut quotient = Vec::new();
        while let Some((monomial, value)) = rest.leading() {
            let by_monomial = monomial.over(lead);
            if !by_monomial.is_whole() || (quotient.len() + 1) * by.len() > MAX_PAIRS {
                return None;
            }
            let factor = value / divisor;
            rest.add(by.scaled(&-factor.clone(), &by_monomial));
            quotient.push((by_monomial, factor));
        }
        quotient.reverse();
        Some(Self(quotient))
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
