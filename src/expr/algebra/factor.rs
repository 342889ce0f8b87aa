//! Splitting a polynomial into factors that are cheap to find: those free of one of its atoms, and repeated ones.
//! It makes results readable and is no complete factorisation.

use super::gcd::{Work, content_in, gcd};
use super::polynomial::Polynomial;

/// Polynomials with more terms than this stay whole.
const MAX_TERMS: usize = 40;

/// Factors with their multiplicities; their product is `polynomial`, which no monomial may divide.
pub(super) fn factors(polynomial: &Polynomial) -> Vec<(Polynomial, u32)> {
    let mut factors = Vec::new();
    split(polynomial, &mut factors, &mut Work::default());
    factors
}

fn split(polynomial: &Polynomial, factors: &mut Vec<(Polynomial, u32)>, work: &mut Work) {
    if polynomial.as_constant().is_some_and(|value| value.is_one()) {
        return;
    }
    if (2..=MAX_TERMS).contains(&polynomial.len())
        && let Some((first, second)) = proper_divisor(polynomial, work)
    {
        split(&first, factors, work);
        split(&second, factors, work);
        return;
    }
    match factors.iter_mut().find(|(known, _)| known == polynomial) {
        Some((_, multiplicity)) => *multiplicity += 1,
        None => factors.push((polynomial.clone(), 1)),
    }
}

fn proper_divisor(polynomial: &Polynomial, work: &mut Work) -> Option<(Polynomial, Polynomial)> {
    if is_no_product(polynomial) {
        return None;
    }
    let atoms: Vec<_> = polynomial.atoms().into_iter().map(|atom| (atom, polynomial.spread(atom))).collect();
    let proper = |part: &Polynomial| part.len() > 1 && part != polynomial;
    // Where one power of an atom stands in a single term, only a monomial can divide what stands with every power.
    let shareable = atoms.iter().filter(|(_, spread)| spread.values().all(|terms| *terms > 1));
    let free = shareable.map(|(atom, _)| content_in(polynomial, atom, work)).find(proper);
    let divisor = free.or_else(|| {
        // A repeated factor makes every one of its atoms occur twice.
        let repeatable = atoms.iter().filter(|(_, spread)| spread.keys().any(|power| *power > 1));
        repeatable.map(|(atom, _)| gcd(polynomial, &polynomial.derivative(atom), work)).find(proper)
    })?;
    let rest = polynomial.divided(&divisor)?;
    rest.as_constant().is_none().then_some((divisor, rest))
}

/// Whether it is seen at once that a sum is no product: it is `a x + b`, where `a` or `b` is a single term. As no monomial divides
/// the sum, `a` and `b` then have nothing in common.
fn is_no_product(polynomial: &Polynomial) -> bool {
    let holding =
        |atom| polynomial.terms().map(move |(monomial, _)| monomial.exponent(atom)).filter(|power| *power != 0);
    let stands_alone = |atom| {
        let terms = holding(atom).count();
        (terms == 1 || terms + 1 == polynomial.len()) && holding(atom).all(|power| power == 1)
    };
    polynomial.terms().flat_map(|(monomial, _)| monomial.powers()).any(|(atom, power)| power == 1 && stands_alone(atom))
}
