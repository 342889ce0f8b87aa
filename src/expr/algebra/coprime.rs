//! A test without the algebra of remainders, that two polynomials have no factor in common. Modulo a prime, and with
//! numbers for all atoms but one, a common factor stays a common factor, so where the images have none, the polynomials
//! have none.
//!
//! Source: W. S. Brown, On Euclid's Algorithm and the Computation of Polynomial Greatest Common Divisors, J. ACM 18 (1971).

use dashu::Integer;

use super::monomial::Atom;
use super::polynomial::Polynomial;

/// A prime that leaves room for sums and products in 128 bits.
const PRIME: u64 = (1 << 61) - 1;

/// Images are not made of powers above this.
const HIGHEST: usize = 64;

/// Whether two polynomials with whole coefficients and without a common monomial certainly have no factor in common but numbers.
/// `false` decides nothing.
pub(super) fn are_coprime(left: &Polynomial, right: &Polynomial) -> bool {
    let mut atoms: Vec<&Atom> = Vec::new();
    for (atom, _) in left.terms().chain(right.terms()).flat_map(|(monomial, _)| monomial.powers()) {
        if !atoms.contains(&atom) {
            atoms.push(atom);
        }
    }
    let (Some(left), Some(right)) = (Residues::of(left, &atoms), Residues::of(right, &atoms)) else { return false };
    let mut shared = (0..atoms.len()).filter(|place| left.degree(*place) > 0 && right.degree(*place) > 0);
    shared.all(|place| match (left.image(place), right.image(place)) {
        // The degree of a common factor shows in its image unless the leading coefficients of both vanish there.
        (Some(left), Some(right)) if left.last() != Some(&0) || right.last() != Some(&0) => {
            is_coprime_image(left, right)
        }
        _ => false,
    })
}

/// A polynomial modulo the prime.
struct Residues {
    /// The coefficient of each term.
    values: Vec<u64>,
    /// The exponent of each atom, term by term.
    exponents: Vec<usize>,
    /// The number of atoms.
    atoms: usize,
}

impl Residues {
    fn of(polynomial: &Polynomial, atoms: &[&Atom]) -> Option<Self> {
        let mut values = Vec::with_capacity(polynomial.len());
        let mut exponents = vec![0; polynomial.len() * atoms.len()];
        for ((monomial, value), row) in polynomial.terms().zip(exponents.chunks_exact_mut(atoms.len().max(1))) {
            for (atom, power) in monomial.powers() {
                let place = atoms.iter().position(|other| *other == atom)?;
                *row.get_mut(place)? = usize::try_from(power).ok().filter(|power| *power <= HIGHEST)?;
            }
            values.push(residue(value.numerator()).filter(|_| value.is_int())?);
        }
        Some(Self { values, exponents, atoms: atoms.len() })
    }

    /// The exponents of the atoms in each term.
    fn terms(&self) -> impl Iterator<Item = &[usize]> {
        self.exponents.chunks_exact(self.atoms.max(1))
    }

    /// The highest exponent of the atom at a place.
    fn degree(&self, place: usize) -> usize {
        self.terms().filter_map(|exponents| exponents.get(place)).copied().max().unwrap_or(0)
    }

    /// The coefficients in the atom at a place, with numbers in no relation to each other for all others.
    fn image(&self, place: usize) -> Option<Vec<u64>> {
        let mut image = vec![0; self.degree(place) + 1];
        let points: Vec<u64> = (1_u64..).take(self.atoms).map(point).collect();
        for (exponents, value) in self.terms().zip(&self.values) {
            let others = exponents.iter().zip(&points).enumerate().filter(|(other, _)| *other != place);
            let value = others.fold(*value, |value, (_, (power, point))| {
                (0..*power).fold(value, |product, _| times(product, *point))
            });
            let term = image.get_mut(*exponents.get(place)?)?;
            *term = (*term + value) % PRIME;
        }
        Some(image)
    }
}

/// Euclid's algorithm on coefficients, the lowest power first: whether nothing but a number divides both.
fn is_coprime_image(mut left: Vec<u64>, mut right: Vec<u64>) -> bool {
    trim(&mut left);
    trim(&mut right);
    while let Some(lead) = right.last().copied() {
        while let Some(leading) = left.last().copied().filter(|_| left.len() >= right.len()) {
            let shift = left.len() - right.len();
            for value in &mut left {
                *value = times(*value, lead);
            }
            for (value, other) in left.iter_mut().skip(shift).zip(&right) {
                *value = (*value + PRIME - times(leading, *other)) % PRIME;
            }
            trim(&mut left);
        }
        std::mem::swap(&mut left, &mut right);
    }
    left.len() == 1
}

/// Drops the powers that do not occur.
fn trim(image: &mut Vec<u64>) {
    image.truncate(image.iter().rposition(|value| *value != 0).map_or(0, |last| last + 1));
}

fn residue(value: &Integer) -> Option<u64> {
    let rest = match i64::try_from(value) {
        Ok(small) => i128::from(small),
        Err(_) => i128::try_from(value % Integer::from(PRIME)).ok()?,
    };
    u64::try_from(rest.rem_euclid(i128::from(PRIME))).ok()
}

fn times(left: u64, right: u64) -> u64 {
    let (low, high) = left.carrying_mul(right, 0);
    // The prime is a power of two less one: what lies above its bits counts once more below.
    ((low & PRIME) + (high << 3 | low >> 61)) % PRIME
}

/// A fixed number for the atom that is counted so.
fn point(count: u64) -> u64 {
    times(count, 0x9e37_79b9_7f4a_7c15 % PRIME)
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;
    use super::super::canonical::{Rules, none_positive};
    use super::*;

    #[test]
    fn a_common_factor_is_never_denied_and_none_is_mostly_seen() {
        for (left, right, coprime) in [
            ("x + 1", "x - 1", true),
            ("x^2 - 1", "x + 1", false),
            ("(a + b)*(x + y)", "(a - b)*(x + y)", false),
            ("(a + b)*(x + y)", "(a - b)*(x - y)", true),
            ("a*x + b", "a*y + b", true),
            ("(x - 1)*(x - 2)*(x - 3)", "(x - 4)*(x - 5)*(x - 6)", true),
            ("x^2 + 2*x*y + y^2", "2*x + 2*y", false),
            ("m + n", "a + b", true),
        ] {
            let mut names = AnyName::default();
            let rules = Rules { pythagoras: false, expand: false, positive: &none_positive };
            let [left, right] =
                [left, right].map(|text| rules.quotient(&names.term(text)).map(|form| form.numerator.primitive().2));
            let found = left.zip(right).map(|(left, right)| are_coprime(&left, &right));
            assert_eq!(found, Some(coprime));
        }
    }
}
