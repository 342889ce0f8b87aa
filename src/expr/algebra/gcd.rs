//! The greatest common divisor of polynomials in many atoms, by primitive remainder sequences, one atom at a time.
//!
//! Source: D. E. Knuth, *The Art of Computer Programming*, vol. 2, section 4.6.1, algorithm E, applied recursively.

use momentous_quantity::Rational;

use super::coprime::are_coprime;
use super::monomial::{Atom, Monomial};
use super::polynomial::Polynomial;

/// Pairs of terms that may be multiplied in one search; a fraction then stays as it is.
const MAX_WORK: usize = 6_000;
/// Polynomials with more terms than this are not searched.
const MAX_TERMS: usize = 80;

/// The budget of a search, in pairs of terms multiplied.
pub(super) struct Work(usize);

impl Default for Work {
    fn default() -> Self {
        Self(MAX_WORK)
    }
}

impl Work {
    /// `None` where the work is used up.
    fn spend(&mut self, pairs: usize) -> Option<()> {
        self.0 = self.0.checked_sub(pairs)?;
        Some(())
    }

    fn product(&mut self, left: &Polynomial, right: &Polynomial) -> Option<Polynomial> {
        self.spend(left.len() * right.len())?;
        left.times(right)
    }

    fn quotient(&mut self, dividend: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
        let quotient = dividend.divided(divisor);
        self.spend(dividend.len() * divisor.len())?;
        quotient
    }
}

/// The greatest common divisor with whole coprime coefficients, positive in its leading term; 1 where none was found
/// within the bounds.
pub(super) fn gcd(left: &Polynomial, right: &Polynomial, work: &mut Work) -> Polynomial {
    search(left, right, work).unwrap_or_else(Polynomial::one)
}

/// The greatest divisor in which `atom` does not occur; 1 where none was found within the bounds.
pub(super) fn content_in(polynomial: &Polynomial, atom: &Atom, work: &mut Work) -> Polynomial {
    content(polynomial, atom, work).unwrap_or_else(Polynomial::one)
}

fn normal(polynomial: &Polynomial) -> Polynomial {
    let (number, _) = polynomial.content();
    let whole = polynomial.over(&number, &Monomial::default());
    if whole.is_negative() { whole.negated() } else { whole }
}

fn content(polynomial: &Polynomial, atom: &Atom, work: &mut Work) -> Option<Polynomial> {
    let parts = polynomial.coefficients(atom);
    let mut others = parts.values();
    let Some(first) = others.next() else { return Some(Polynomial::default()) };
    if parts.len() == 1 {
        return Some(normal(first));
    }
    let mut divisor = first.clone();
    for part in others {
        divisor = search(&divisor, part, work)?;
        if divisor.is_one() {
            break;
        }
    }
    Some(divisor)
}

/// `None` where the bounds were reached.
fn search(left: &Polynomial, right: &Polynomial, work: &mut Work) -> Option<Polynomial> {
    work.spend(left.len() + right.len())?;
    if left.is_zero() || right.is_zero() {
        return Some(normal(if left.is_zero() { right } else { left }));
    }
    let (_, left_monomial, left) = left.primitive();
    let (_, right_monomial, right) = right.primitive();
    let common = left_monomial.common(&right_monomial);
    Some(search_primitive(&left, &right, work)?.scaled(&Rational::ONE, &common))
}

/// The same for two polynomials that no monomial divides.
fn search_primitive(left: &Polynomial, right: &Polynomial, work: &mut Work) -> Option<Polynomial> {
    if left.len() == 1 || right.len() == 1 || are_coprime(left, right) {
        return Some(Polynomial::one());
    }
    if left.len() > MAX_TERMS || right.len() > MAX_TERMS {
        return None;
    }
    let (left_atoms, right_atoms) = (left.atoms(), right.atoms());
    if let Some(atom) = left_atoms.difference(&right_atoms).next() {
        return search(&content(left, atom, work)?, right, work);
    }
    if let Some(atom) = right_atoms.difference(&left_atoms).next() {
        return search(left, &content(right, atom, work)?, work);
    }
    let Some(atom) = left_atoms.iter().min_by_key(|atom| degree(left, atom).max(degree(right, atom))) else {
        return Some(Polynomial::one());
    };
    let (left_content, right_content) = (content(left, atom, work)?, content(right, atom, work)?);
    let shared = search(&left_content, &right_content, work)?;
    let (left, right) = (work.quotient(left, &left_content)?, work.quotient(right, &right_content)?);
    let ordered = degree(&left, atom) >= degree(&right, atom);
    let (mut dividend, mut divisor) = if ordered { (left, right) } else { (right, left) };
    loop {
        let rest = pseudo_remainder(dividend, &divisor, atom, work)?;
        if rest.is_zero() {
            return Some(normal(&work.product(&divisor, &shared)?));
        }
        if degree(&rest, atom) == 0 {
            return Some(shared);
        }
        dividend = divisor;
        let common = content(&rest, atom, work)?;
        divisor = work.quotient(&rest, &common)?;
    }
}

fn degree(polynomial: &Polynomial, atom: &Atom) -> i32 {
    polynomial.terms().map(|(monomial, _)| monomial.exponent(atom)).max().unwrap_or(0)
}

/// The remainder of a division in which the dividend may be multiplied by the divisor's leading coefficient.
fn pseudo_remainder(dividend: Polynomial, divisor: &Polynomial, atom: &Atom, work: &mut Work) -> Option<Polynomial> {
    let top = degree(divisor, atom);
    let lead = divisor.coefficients(atom).remove(&top)?;
    let mut rest = dividend;
    while !rest.is_zero() && degree(&rest, atom) >= top {
        let height = degree(&rest, atom);
        let factor = rest.coefficients(atom).remove(&height)?;
        let shift = Monomial::atom(atom.clone(), height - top);
        let taken = work.product(divisor, &factor)?.scaled(&Rational::ONE, &shift);
        rest = work.product(&rest, &lead)?.plus(&taken.negated());
        if rest.len() > 4 * MAX_TERMS {
            return None;
        }
    }
    Some(rest)
}
