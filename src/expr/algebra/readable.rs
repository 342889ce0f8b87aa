//! A canonical form written the way a person would: factors taken out, positive terms first, one fraction bar.

use momentous_quantity::Rational;

use super::super::{Expr, Function};
use super::canonical::root_degree;
use super::factor::factors;
use super::monomial::{Atom, Monomial};
use super::polynomial::Polynomial;
use super::quotient::{Quotient, is_unit};

/// Sums with more terms than this are not searched for common factors of some of them.
const MAX_GROUPED: usize = 12;

impl Quotient {
    /// The term, written readably. Equal forms give equal terms.
    pub(super) fn to_expr(&self) -> Expr {
        if self.numerator.is_zero() {
            return Expr::zero();
        }
        let (mut number, monomial, above) = self.numerator.primitive();
        let (below_number, below_monomial, below) = self.denominator.primitive();
        if !below_number.is_one() {
            number /= below_number;
        }
        let mut above = factors(&above);
        let mut below = factors(&below);
        let monomial = place_exponentials(&monomial, &mut above, &mut below);
        for (factor, multiplicity) in above.iter_mut().chain(&mut below) {
            if reading_order(factor).first().is_some_and(|(_, value)| **value < Rational::ZERO) {
                *factor = factor.negated();
                if *multiplicity % 2 == 1 {
                    number = -number;
                }
            }
        }
        above.retain(|(factor, _)| factor.as_constant().is_none());
        below.retain(|(factor, _)| factor.as_constant().is_none());
        if number < Rational::ZERO
            && let Some((factor, _)) = above.iter_mut().rev().find(|(factor, times)| times % 2 == 1 && is_mixed(factor))
        {
            *factor = factor.negated();
            number = -number;
        }
        if let [(factor, 1)] = above.as_mut_slice()
            && self.denominator.len() == 1
            && below_monomial.is_one()
            && !number.is_int()
            && factor.terms().any(|(_, value)| (value * &number).is_int())
        {
            *factor = factor.scaled(&number, &Monomial::default());
            number = Rational::ONE;
        }
        let powers = |factors: &[(Polynomial, u32)], sign: i64| -> Vec<Expr> {
            factors.iter().map(|(factor, times)| sum(factor).powi(sign * i64::from(*times))).collect()
        };
        let mut product = vec![term(&number, &monomial)];
        product.extend(powers(&above, 1));
        product.extend(below_monomial.powers().map(|(atom, power)| atom.clone().powi(-i64::from(power))));
        product.extend(powers(&below, -1));
        Expr::product(product)
    }
}

/// Exponentials common to a whole numerator go back into a sum that contains them: `1 - exp(-x)`, not `exp(-x) (exp(x) - 1)`.
fn place_exponentials(
    monomial: &Monomial,
    above: &mut [(Polynomial, u32)],
    below: &mut [(Polynomial, u32)],
) -> Monomial {
    let (units, mut kept) = monomial.partition(is_unit);
    for (atom, power) in units.powers() {
        let single = |factors: &[(Polynomial, u32)]| {
            factors.iter().position(|(factor, times)| *times == 1 && factor.atoms().contains(atom))
        };
        if let Some((factor, _)) = single(above).and_then(|place| above.get_mut(place)) {
            *factor = factor.scaled(&Rational::ONE, &Monomial::atom(atom.clone(), power));
        } else if let Some((factor, _)) = single(below).and_then(|place| below.get_mut(place)) {
            *factor = factor.scaled(&Rational::ONE, &Monomial::atom(atom.clone(), -power));
        } else {
            kept = kept.times(&Monomial::atom(atom.clone(), power));
        }
    }
    kept
}

fn is_mixed(polynomial: &Polynomial) -> bool {
    let negative = polynomial.terms().filter(|(_, value)| **value < Rational::ZERO).count();
    negative > 0 && negative < polynomial.len()
}

/// Terms of lower degree first, then lexicographic from the greatest: `1 - e^2`, `h + v t`.
fn reading_order(polynomial: &Polynomial) -> Vec<(&Monomial, &Rational)> {
    let mut terms: Vec<_> = polynomial.terms().rev().collect();
    terms.sort_by_key(|(monomial, _)| monomial.degree());
    terms
}

/// A polynomial as a sum, with what some terms have in common taken out, and a positive term first.
fn sum(polynomial: &Polynomial) -> Expr {
    let group = common_group(polynomial);
    let mut terms: Vec<(bool, Expr)> = Vec::new();
    let mut grouped = false;
    for (monomial, value) in reading_order(polynomial) {
        let member = group.as_ref().filter(|common| common.divides(monomial));
        match member {
            None => terms.push((*value < Rational::ZERO, term(value, monomial))),
            Some(_) if grouped => {}
            Some(common) => {
                grouped = true;
                let negative = *value < Rational::ZERO;
                let inner = polynomial.terms().filter(|(monomial, _)| common.divides(monomial)).fold(
                    Polynomial::default(),
                    |sum, (monomial, value)| {
                        let value = if negative { -value.clone() } else { value.clone() };
                        sum.plus(&Polynomial::term(value, monomial.over(common)))
                    },
                );
                let (number, _) = inner.content();
                let inner = sum(&inner.over(&number, &Monomial::default()));
                let number = if negative { -number } else { number };
                terms.push((negative, term(&number, common) * inner));
            }
        }
    }
    if let Some(first) = terms.iter().position(|(negative, _)| !negative) {
        let positive = terms.remove(first);
        terms.insert(0, positive);
    }
    Expr::sum(terms.into_iter().map(|(_, term)| term))
}

/// The monomial in symbols that saves most factors when it is taken out of the terms that it divides, two at least.
/// Among equals the one of the highest terms: `m v + M u - M e (v - u)`, not `m v + M u (1 + e) - M e v`.
fn common_group(polynomial: &Polynomial) -> Option<Monomial> {
    if polynomial.len() > MAX_GROUPED {
        return None;
    }
    let mut symbols: Vec<&Atom> = Vec::new();
    for (atom, _) in polynomial.terms().flat_map(|(monomial, _)| monomial.powers()) {
        if matches!(atom, Expr::Symbol(_)) && !symbols.contains(&atom) {
            symbols.push(atom);
        }
    }
    let exponents = |monomial: &Monomial| symbols.iter().map(|symbol| monomial.exponent(symbol)).collect();
    let terms: Vec<(Vec<i32>, i32)> =
        polynomial.terms().map(|(monomial, _)| (exponents(monomial), monomial.degree())).collect();
    let degree = |exponents: &[i32]| exponents.iter().copied().fold(0, i32::saturating_add);
    let mut best: Option<([i32; 3], Vec<i32>)> = None;
    for (index, (first, _)) in terms.iter().enumerate() {
        for (second, _) in terms.iter().skip(index + 1) {
            let common: Vec<i32> = first.iter().zip(second).map(|(a, b)| *a.min(b)).collect();
            let common_degree = degree(&common);
            // At most all others share it, too.
            let most = common_degree.saturating_mul(i32::try_from(terms.len() - 1).unwrap_or(i32::MAX));
            if most < best.as_ref().map_or(2, |(worth, _)| worth[0]) {
                continue;
            }
            let shares = |exponents: &[i32]| exponents.iter().zip(&common).all(|(power, common)| power >= common);
            let members = || terms.iter().filter(|(exponents, _)| shares(exponents));
            let others = i32::try_from(members().count()).unwrap_or(i32::MAX) - 1;
            let degrees = members().map(|(_, degree)| *degree).fold(0, i32::saturating_add);
            let worth = [common_degree.saturating_mul(others), common_degree, degrees];
            if worth[0] >= 2 && best.as_ref().is_none_or(|(most, _)| worth > *most) {
                best = Some((worth, common));
            }
        }
    }
    let powers = |common: Vec<i32>| Monomial::product(symbols.into_iter().cloned().zip(common).collect());
    best.map(|(_, common)| powers(common))
}

/// One term: the number, the atoms, roots and exponentials joined.
fn term(number: &Rational, monomial: &Monomial) -> Expr {
    let mut number = number.clone();
    let mut parts: Vec<(&Atom, i32)> = monomial.powers().collect();
    // `g t^2`, `m v^2`: plain symbols stand before powers, whatever their order in the table
    parts.sort_by_key(|(atom, power)| (!matches!(atom, Expr::Symbol(_) | Expr::Pi), *power > 1));
    let root = join_roots(&mut number, &mut parts);
    let exponents: Vec<_> = parts
        .iter()
        .filter_map(|(atom, power)| match atom {
            Expr::Apply(Function::Exp, inner) => Some(inner.first()?.clone() * Expr::integer(i64::from(*power))),
            _ => None,
        })
        .collect();
    let plain = parts.iter().filter(|(atom, _)| !is_unit(atom)).map(|(atom, power)| power_of_atom(atom, *power));
    let mut product = vec![Expr::Number(number)];
    product.extend(plain);
    product.extend(root);
    if !exponents.is_empty() {
        product.push(Expr::apply(Function::Exp, Expr::sum(exponents)));
    }
    Expr::product(product)
}

/// `(e^n)^2` is written `e^(2 n)`.
fn power_of_atom(atom: &Atom, power: i32) -> Expr {
    match atom {
        Expr::Power(pair) if power != 1 && pair.1.as_number().is_none() => {
            pair.0.clone().power(pair.1.clone() * Expr::integer(i64::from(power)))
        }
        atom => atom.clone().powi(i64::from(power)),
    }
}

/// Takes square roots of numbers, and one square root of a term, out of `parts` and joins them: `sqrt(2 g h)`.
fn join_roots(number: &mut Rational, parts: &mut Vec<(&Atom, i32)>) -> Option<Expr> {
    let radicand = |atom: &Atom| match atom {
        Expr::Power(pair) if root_degree(&pair.1) == Some(2) => Some(pair.0.clone()),
        _ => None,
    };
    let (roots, others): (Vec<_>, Vec<_>) =
        parts.drain(..).partition(|(atom, power)| *power == 1 && radicand(atom).is_some());
    *parts = others;
    let bases: Vec<Expr> = roots.iter().filter_map(|(atom, _)| radicand(atom)).collect();
    let (numbers, terms): (Vec<_>, Vec<_>) =
        bases.into_iter().partition(|base| base.as_number().is_some_and(|n| *n > Rational::ZERO));
    let mut inside = numbers.iter().filter_map(Expr::as_number).fold(Rational::ONE, |product, n| product * n);
    let mut roots = terms.into_iter();
    let Some(first) = roots.next() else {
        return (!inside.is_one()).then(|| Expr::Number(inside).sqrt());
    };
    let share = Rational::from(number.denominator().clone()) / &inside;
    if !inside.is_one() && share.is_int() {
        *number *= &inside;
        inside = Rational::ONE / inside;
    }
    let joined = (Expr::Number(inside) * first).sqrt();
    Some(Expr::product(std::iter::once(joined).chain(roots.map(Expr::sqrt))))
}
