//! Products of powers of atoms, in lexicographic order.

use std::cmp::Ordering;

use super::super::Expr;

/// A term that the algebra of polynomials does not look into: a symbol, pi, a root, a sine, an exponential.
pub(super) type Atom = Expr;

/// A product of integer powers of distinct atoms; empty for 1. Only exponentials, which are never zero, have negative powers.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub(super) struct Monomial(Vec<(Atom, i32)>);

impl Monomial {
    /// An atom to a power.
    pub(super) fn atom(atom: Atom, exponent: i32) -> Self {
        Self(if exponent == 0 { Vec::new() } else { vec![(atom, exponent)] })
    }

    /// The product of powers of atoms, each of which may come again.
    pub(crate) fn product(mut powers: Vec<(Atom, i32)>) -> Self {
        powers.sort_by(|a, b| a.0.cmp(&b.0));
        powers.dedup_by(|later, earlier| {
            let again = later.0 == earlier.0;
            earlier.1 = if again { earlier.1.saturating_add(later.1) } else { earlier.1 };
            again
        });
        powers.retain(|(_, exponent)| *exponent != 0);
        Self(powers)
    }

    /// Whether it is 1.
    pub(crate) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    /// The atoms with their exponents, in order.
    pub(crate) fn powers(&self) -> impl Iterator<Item = (&Atom, i32)> {
        self.0.iter().map(|(atom, exponent)| (atom, *exponent))
    }

    /// The exponent of an atom, 0 where it does not occur.
    pub(crate) fn exponent(&self, atom: &Atom) -> i32 {
        self.powers().find(|(base, _)| *base == atom).map_or(0, |(_, exponent)| exponent)
    }

    /// The sum of all exponents.
    pub(crate) fn degree(&self) -> i32 {
        self.0.iter().fold(0, |sum, (_, exponent)| sum.saturating_add(*exponent))
    }

    /// Each atom of either with what `exponent` makes of its two exponents, 0 where it does not occur.
    fn merge(&self, other: &Self, exponent: impl Fn(i32, i32) -> i32) -> Self {
        let mut merged = Vec::with_capacity(self.0.len() + other.0.len());
        let mut left = self.0.iter().peekable();
        let mut right = other.0.iter().peekable();
        loop {
            let order = match (left.peek(), right.peek()) {
                (None, None) => return Self(merged),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(a), Some(b)) => a.0.cmp(&b.0),
            };
            let from_left = if order.is_le() { left.next() } else { None };
            let from_right = if order.is_ge() { right.next() } else { None };
            let power = |side: Option<&(Atom, i32)>| side.map_or(0, |power| power.1);
            let exponent = exponent(power(from_left), power(from_right));
            if let Some((atom, _)) = from_left.or(from_right)
                && exponent != 0
            {
                merged.push((atom.clone(), exponent));
            }
        }
    }

    /// The product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        self.merge(other, i32::saturating_add)
    }

    /// The quotient, with negative exponents where `other` does not divide it.
    pub(crate) fn over(&self, other: &Self) -> Self {
        self.merge(other, i32::saturating_sub)
    }

    /// Whether `other` over it has no negative exponents.
    pub(crate) fn divides(&self, other: &Self) -> bool {
        self.powers().all(|(atom, power)| other.exponent(atom) >= power)
            && other.powers().all(|(atom, power)| power >= self.exponent(atom))
    }

    /// Whether no exponent is negative.
    pub(super) fn is_whole(&self) -> bool {
        self.powers().all(|(_, exponent)| exponent > 0)
    }

    /// The greatest monomial that divides both.
    pub(crate) fn common(&self, other: &Self) -> Self {
        self.merge(other, i32::min)
    }

    /// The part whose atoms pass `test`, and the part whose atoms do not.
    pub(crate) fn partition(&self, test: impl Fn(&Atom) -> bool) -> (Self, Self) {
        let (pass, fail) = self.0.iter().cloned().partition(|(atom, _)| test(atom));
        (Self(pass), Self(fail))
    }
}

impl Ord for Monomial {
    /// Lexicographic: the exponent of the first atom decides, then that of the second.
    fn cmp(&self, other: &Self) -> Ordering {
        let leading = |rest: &[(Atom, i32)]| rest.first().map_or(0, |power| power.1).cmp(&0);
        let same = self.0.iter().zip(&other.0).take_while(|(a, b)| a == b).count();
        match (self.0.get(same), other.0.get(same)) {
            (Some(a), Some(b)) => match a.0.cmp(&b.0) {
                Ordering::Equal => a.1.cmp(&b.1),
                Ordering::Less => a.1.cmp(&0),
                Ordering::Greater => 0.cmp(&b.1),
            },
            _ => leading(&self.0[same..]).then(leading(&other.0[same..]).reverse()),
        }
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
