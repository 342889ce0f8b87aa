//! The canonical form: a quotient of polynomials over the rational numbers, in which roots, sines, exponentials and the like
//! are atoms with canonical arguments. Two terms are equal where the difference of their forms is zero.

use std::sync::Arc;

use momentous_quantity::Rational;

use super::super::calculus::curvature::differ;
use super::super::{Expr, Function, Piecewise, Symbol};
use super::factor::factors;
use super::monomial::{Atom, Monomial};
use super::polynomial::Polynomial;
use super::quotient::Quotient;

/// The identities that bring a term into its form.
#[derive(Clone, Copy)]
pub(super) struct Rules<'a> {
    /// Whether squares of sines become squares of cosines.
    pub(super) pythagoras: bool,
    /// Whether functions of sums, and roots and logarithms of products, are taken apart: decides more, reads worse.
    pub(super) expand: bool,
    /// The symbols whose values are positive.
    pub(crate) positive: &'a dyn Fn(Symbol) -> bool,
}

/// Nothing is known to be positive.
pub(super) fn none_positive(_: Symbol) -> bool {
    false
}

/// Whether two terms are proven equal, wherever both have a value. `false` means that no proof was found.
///
/// ```
/// use momentous_expr::{Expr, equal};
/// let x = Expr::Pi;
/// let square = (x.clone() + Expr::one()).powi(2);
/// assert!(equal(&square, &(x.clone() * x.clone() + Expr::integer(2) * x + Expr::one())));
/// ```
#[must_use]
pub fn equal(left: &Expr, right: &Expr) -> bool {
    equal_where(left, right, &none_positive)
}

/// The same, with the symbols for which `positive` holds known to be positive: then `sqrt(b^2)` is `b`.
#[must_use]
pub fn equal_where(left: &Expr, right: &Expr, positive: &dyn Fn(Symbol) -> bool) -> bool {
    let proves = |rules: Rules| {
        let sides = (rules.quotient(left), rules.quotient(right));
        let (Some(left), Some(right)) = sides else { return false };
        left == right || rules.sum(&left, &right.negated()).is_some_and(|rest| rest.numerator.is_zero())
    };
    let plain = Rules { pythagoras: true, expand: false, positive };
    left == right || !differ(left, right) && (proves(plain) || proves(Rules { expand: true, ..plain }))
}

/// Whether two terms without roots and functions are equal wherever both have a value; `None` where they are too large.
#[must_use]
pub fn equal_rational(left: &Expr, right: &Expr) -> Option<bool> {
    let rules = Rules { pythagoras: false, expand: false, positive: &none_positive };
    let difference = rules.sum(&rules.quotient(left)?, &rules.quotient(right)?.negated())?;
    Some(difference.numerator.is_zero())
}

/// Whether a term has no other form: pi, a symbol, and the sine and the cosine of one.
pub(super) fn is_plain(expr: &Expr) -> bool {
    match expr {
        Expr::Pi | Expr::Symbol(_) => true,
        Expr::Apply(Function::Sin | Function::Cos, angle) => matches!(angle.as_ref(), [Expr::Symbol(_)]),
        _ => false,
    }
}

impl Rules<'_> {
    /// The canonical form; `None` where it would be too large, or where the term divides by zero.
    pub(crate) fn quotient(&self, expr: &Expr) -> Option<Quotient> {
        match expr {
            Expr::Number(value) => Some(Quotient::constant(value.clone())),
            Expr::Sum(terms) => Quotient::sum(terms.iter().map(|term| self.quotient(term))),
            Expr::Product(factors) => self.product_of(factors),
            Expr::Power(pair) => self.power(&self.quotient(&pair.0)?, &self.quotient(&pair.1)?),
            Expr::Apply(function, arguments) if !is_plain(expr) => self.apply(*function, arguments),
            Expr::Piecewise(piecewise) => self.piecewise(piecewise),
            Expr::Pi | Expr::Symbol(_) | Expr::Apply(..) => Some(Quotient::atom(expr.clone())),
        }
    }

    /// The product of factors: those that no rule looks into are counted, all others multiplied one by one.
    fn product_of(&self, factors: &[Expr]) -> Option<Quotient> {
        let (mut number, mut powers, mut others) = (Rational::ONE, Vec::new(), Vec::new());
        for factor in factors {
            match (factor, self.plain_power(factor)) {
                (Expr::Number(value), _) => number *= value,
                (_, Some((atom, power))) => powers.push((atom.clone(), power)),
                _ => others.push(factor),
            }
        }
        let single = Quotient::term(number, &Monomial::product(powers));
        others.into_iter().try_fold(single, |product, factor| self.product(&product, &self.quotient(factor)?))
    }

    /// The atom and the power, where the factor is a whole power of an atom that has no simpler form.
    fn plain_power<'e>(&self, factor: &'e Expr) -> Option<(&'e Atom, i32)> {
        match factor {
            Expr::Pi | Expr::Symbol(_) => Some((factor, 1)),
            Expr::Apply(function, angle) if matches!(angle.as_ref(), [Expr::Symbol(_)]) => {
                let plain = *function == Function::Cos || *function == Function::Sin && !self.pythagoras;
                plain.then_some((factor, 1))
            }
            Expr::Power(pair) => {
                let exponent = pair.1.as_number().filter(|exponent| exponent.is_int())?;
                let (atom, _) = self.plain_power(&pair.0).filter(|(_, inner)| *inner == 1)?;
                Some((atom, i32::try_from(exponent.numerator().clone()).ok()?))
            }
            _ => None,
        }
    }

    fn piecewise(&self, piecewise: &Piecewise) -> Option<Quotient> {
        let read = |expr: &Expr| self.quotient(expr).map(|form| form.to_expr());
        let mut pieces = Vec::new();
        for (until, value) in &piecewise.pieces {
            let until = match until {
                Some(until) => Some(read(until)?),
                None => None,
            };
            pieces.push((until, read(value)?));
        }
        let variable = read(&piecewise.variable)?;
        Some(Quotient::atom(Expr::Piecewise(Arc::new(Piecewise { variable, pieces }))))
    }

    /// The sum, with powers of atoms that have a simpler form replaced.
    pub(crate) fn sum(&self, left: &Quotient, right: &Quotient) -> Option<Quotient> {
        self.settled(left.plus(right)?)
    }

    /// The product, with powers of atoms that have a simpler form replaced.
    pub(crate) fn product(&self, left: &Quotient, right: &Quotient) -> Option<Quotient> {
        self.settled(left.times(right)?)
    }

    fn whole_power(&self, base: &Quotient, exponent: i32) -> Option<Quotient> {
        self.settled(base.power(exponent)?)
    }

    /// The same, with powers of atoms that have a simpler form replaced.
    fn settled(&self, form: Quotient) -> Option<Quotient> {
        self.lowered_form(&form)?.or(Some(form))
    }

    /// The form with `sqrt(x)^2 = x` and the like applied; the inner `None` where nothing applies.
    #[allow(clippy::option_option, reason = "the outer says that a bound was reached, the inner that nothing changed")]
    pub(super) fn lowered_form(&self, form: &Quotient) -> Option<Option<Quotient>> {
        let (above, below) = (self.lowered(&form.numerator)?, self.lowered(&form.denominator)?);
        if above.is_none() && below.is_none() {
            return Some(None);
        }
        let above = above.unwrap_or_else(|| form.numerator.clone().into());
        let below = below.unwrap_or_else(|| form.denominator.clone().into());
        self.product(&above, &below.inverse()?).map(Some)
    }

    /// The polynomial with `sqrt(x)^2 = x` and the like applied; the inner `None` where nothing applies.
    #[allow(clippy::option_option, reason = "the outer says that a bound was reached, the inner that nothing changed")]
    fn lowered(&self, polynomial: &Polynomial) -> Option<Option<Quotient>> {
        let applies = |(atom, power): (&Atom, i32)| self.lower(atom, power).is_some();
        if !polynomial.terms().any(|(monomial, _)| monomial.powers().any(applies)) {
            return Some(None);
        }
        let sum = Quotient::sum(polynomial.terms().map(|(monomial, coefficient)| {
            let (mut left, mut replaced) = (Vec::new(), Vec::new());
            for (atom, power) in monomial.powers() {
                let (stays, lower) = match self.lower(atom, power) {
                    Some((base, times, stays)) => (stays, Some((base, times))),
                    None => (power, None),
                };
                left.push((atom.clone(), stays));
                replaced.extend(lower);
            }
            let rest = Quotient::term(coefficient.clone(), &Monomial::product(left));
            let times =
                |product: Quotient, (base, times): (Expr, i32)| product.times(&self.quotient(&base)?.power(times)?);
            replaced.into_iter().try_fold(rest, times)
        }));
        self.settled(sum?).map(Some)
    }

    /// A power of an atom in simpler terms: (base, its exponent, exponent of the atom that is left).
    fn lower(&self, atom: &Atom, power: i32) -> Option<(Expr, i32, i32)> {
        match atom {
            Expr::Power(pair) => {
                let degree = root_degree(&pair.1)?;
                (power >= degree).then(|| (pair.0.clone(), power / degree, power % degree))
            }
            Expr::Apply(Function::Abs, argument) if power >= 2 => {
                Some((argument.first()?.clone(), power - power % 2, power % 2))
            }
            Expr::Apply(Function::Sin, argument) if power >= 2 && self.pythagoras => {
                let cosine = Expr::Apply(Function::Cos, argument.clone());
                Some((Expr::one() - cosine.powi(2), power / 2, power % 2))
            }
            _ => None,
        }
    }

    /// A base to an exponent.
    pub(crate) fn power(&self, base: &Quotient, exponent: &Quotient) -> Option<Quotient> {
        if let Some(number) = exponent.as_constant() {
            return self.numeric_power(base, &number);
        }
        if let Some((atom, outer)) = base.as_atom_power()
            && outer != 1
        {
            return self.power(&Quotient::atom(atom.clone()), &exponent.scaled(&Rational::from(outer)));
        }
        let base_expr = base.to_expr();
        let Some(terms) = exponent.as_polynomial() else {
            return Some(Quotient::atom(base_expr.power(exponent.to_expr())));
        };
        let mut product = Quotient::one();
        for (monomial, coefficient) in terms.terms() {
            let factor = if monomial.is_one() {
                self.numeric_power(base, coefficient)?
            } else {
                let (times, part) = whole_and_part(coefficient, monomial)?;
                self.whole_power(&Quotient::atom(Expr::Power(Arc::new((base_expr.clone(), part)))), times)?
            };
            product = self.product(&product, &factor)?;
        }
        Some(product)
    }

    fn numeric_power(&self, base: &Quotient, exponent: &Rational) -> Option<Quotient> {
        let times = i32::try_from(exponent.numerator().clone()).ok()?;
        let degree = i32::try_from(exponent.denominator().clone()).ok()?;
        let root = if degree == 1 { base.clone() } else { self.root(base, degree)? };
        self.whole_power(&root, times)
    }

    /// The root of that degree: numbers, and factors that occur often enough, are taken out of it.
    fn root(&self, base: &Quotient, degree: i32) -> Option<Quotient> {
        if base.numerator.is_zero() {
            return Some(Quotient::zero());
        }
        let (number, above_monomial, above) = base.numerator.primitive();
        let (_, below_monomial, below) = base.denominator.primitive();
        let mut outside = number_root(&number, degree)?;
        let mut inside = Quotient::one();
        let parts = |monomial: &Monomial, rest: &Polynomial, sign: i32| {
            let atoms = monomial.powers().map(|(atom, power)| (Polynomial::atom(atom.clone()), power * sign));
            let factors = factors(rest).into_iter().map(|(factor, power)| (factor, power.cast_signed() * sign));
            atoms.chain(factors).collect::<Vec<_>>()
        };
        let above = parts(&above_monomial, &above, 1);
        let below = parts(&below_monomial, &below, -1);
        for (factor, power) in above.into_iter().chain(below) {
            let factor: Quotient = factor.into();
            let size = if degree % 2 == 0 { self.absolute(&factor)? } else { factor.clone() };
            outside = self.product(&outside, &self.whole_power(&size, power / degree)?)?;
            let rest = factor.power(power % degree)?;
            if self.expand && self.is_positive(&factor.numerator) {
                let root = Quotient::atom(factor.to_expr().power(fraction(degree)));
                outside = self.product(&outside, &self.whole_power(&root, power % degree)?)?;
            } else {
                inside = inside.times(&rest)?;
            }
        }
        if inside.as_constant().is_some_and(|value| value.is_one()) {
            return Some(outside);
        }
        let atom = Expr::Power(Arc::new((inside.to_expr(), fraction(degree))));
        self.product(&outside, &Quotient::atom(atom))
    }

    /// The absolute value.
    pub(crate) fn absolute(&self, form: &Quotient) -> Option<Quotient> {
        let above = self.absolute_part(&form.numerator)?;
        self.product(&above, &self.absolute_part(&form.denominator)?.inverse()?)
    }

    fn absolute_part(&self, polynomial: &Polynomial) -> Option<Quotient> {
        let (number, monomial, rest) = polynomial.primitive();
        let rest = if rest.is_negative() { rest.negated() } else { rest };
        let mut product = Quotient::constant(number);
        let atoms = monomial.powers().map(|(atom, power)| (Polynomial::atom(atom.clone()), power));
        for (factor, power) in atoms.chain([(rest, 1)]) {
            let size = if self.is_positive(&factor) {
                factor.into()
            } else {
                Quotient::atom(Expr::apply(Function::Abs, Quotient::from(factor).to_expr()))
            };
            product = self.product(&product, &self.whole_power(&size, power)?)?;
        }
        Some(product)
    }

    /// Whether a polynomial is seen to be positive, or zero: all its coefficients and atoms are.
    pub(super) fn is_positive(&self, polynomial: &Polynomial) -> bool {
        polynomial.terms().all(|(_, value)| *value > Rational::ZERO)
            && polynomial.atoms().into_iter().all(|atom| match atom {
                Expr::Pi | Expr::Apply(Function::Exp | Function::Abs, _) => true,
                Expr::Symbol(symbol) => (self.positive)(*symbol),
                Expr::Power(pair) => root_degree(&pair.1).is_some_and(|degree| degree % 2 == 0),
                _ => false,
            })
    }
}

/// Coefficient p/q and monomial m as the whole number p and the term m/q.
pub(super) fn whole_and_part(coefficient: &Rational, monomial: &Monomial) -> Option<(i32, Expr)> {
    let times = i32::try_from(coefficient.numerator().clone()).ok()?;
    let share = Rational::ONE / Rational::from(coefficient.denominator().clone());
    Some((times, Quotient::from(Polynomial::term(share, monomial.clone())).to_expr()))
}

/// n, where the exponent is 1/n with n above 1.
pub(super) fn root_degree(exponent: &Expr) -> Option<i32> {
    let exponent = exponent.as_number()?;
    let degree = i32::try_from(exponent.denominator().clone()).ok()?;
    (degree > 1 && exponent.numerator().is_one()).then_some(degree)
}

fn fraction(degree: i32) -> Expr {
    Expr::ratio(1, degree.unsigned_abs())
}

/// The root of a positive number: a rational number times roots of primes (and of one large number, perhaps).
fn number_root(number: &Rational, degree: i32) -> Option<Quotient> {
    let size = usize::try_from(degree).ok().filter(|degree| *degree <= 16)?;
    let below = number.denominator();
    let mut rest = number.numerator().clone().into_parts().1 * below.pow(size - 1);
    let mut outside = Rational::ONE / Rational::from(below.clone());
    let mut roots = Monomial::default();
    let mut take = |prime: dashu::Natural, power: usize| {
        outside *= Rational::from(prime.pow(power / size));
        let power = i32::try_from(power % size).ok()?;
        let atom = Expr::Power(Arc::new((Expr::Number(Rational::from(prime)), fraction(degree))));
        roots = roots.times(&Monomial::atom(atom, power));
        Some(())
    };
    for candidate in 2_u32..1000 {
        let prime = dashu::Natural::from(candidate);
        let mut power = 0;
        while (&rest % &prime).is_zero() {
            rest /= &prime;
            power += 1;
        }
        if power > 0 {
            take(prime, power)?;
        }
        if rest.is_one() {
            break;
        }
    }
    let root = rest.nth_root(size);
    let (rest, power) = if root.pow(size) == rest { (root, size) } else { (rest, 1) };
    if !rest.is_one() {
        take(rest, power)?;
    }
    Some(Polynomial::term(outside, roots).into())
}
