//! The canonical form of functions: parities, exact values, shifts by quarter turns, inverse functions.

use std::sync::Arc;

use momentous_quantity::Rational;

use super::super::{Expr, Function};
use super::canonical::{Rules, whole_and_part};
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::quotient::Quotient;

/// Multiples of an angle above this are not taken apart.
const MAX_MULTIPLE: u32 = 8;

impl Rules<'_> {
    /// A function of its arguments.
    pub(crate) fn apply(&self, function: Function, arguments: &[Expr]) -> Option<Quotient> {
        let forms: Vec<_> = arguments.iter().map(|argument| self.quotient(argument)).collect::<Option<_>>()?;
        if self.expand
            && let [y, x] = forms.as_slice()
            && self.is_positive(&x.numerator)
            && self.is_positive(&x.denominator)
        {
            return Some(arctangent(&self.product(y, &x.inverse()?)?));
        }
        let [form] = forms.as_slice() else {
            let arguments = forms.iter().map(Quotient::to_expr).collect();
            return Some(Quotient::atom(Expr::Apply(function, arguments)));
        };
        match function {
            Function::Sin => self.turns(form).map(|[sine, _]| sine),
            Function::Cos => self.turns(form).map(|[_, cosine]| cosine),
            Function::Tan => {
                let [sine, cosine] = self.turns(form)?;
                self.product(&sine, &cosine.inverse()?)
            }
            Function::Exp => self.exponential(form),
            Function::Ln => self.logarithm(form),
            Function::Abs => self.absolute(form),
            Function::Asin if form.numerator.is_zero() => Some(Quotient::zero()),
            Function::Asin if form.numerator.is_negative() => Some(atom(function, &form.negated()).negated()),
            Function::Acos if self.expand => {
                let quarter = Quotient::atom(Expr::Pi).scaled(&(Rational::ONE / Rational::from(2)));
                self.sum(&quarter, &self.apply(Function::Asin, arguments)?.negated())
            }
            Function::Asin | Function::Acos | Function::Atan2 => Some(atom(function, form)),
        }
    }

    /// Sine and cosine of an angle.
    fn turns(&self, angle: &Quotient) -> Option<[Quotient; 2]> {
        let (quarters, rest) = split_quarters(angle)?;
        let negative = rest.numerator.is_negative();
        let rest = if negative { rest.negated() } else { rest };
        let [sine, cosine] = match self.expand.then(|| split_sum(&rest)).flatten() {
            Some((first, second)) => self.turns_of_sum(&first, &second)?,
            None => [self.turn(Function::Sin, &rest)?, self.turn(Function::Cos, &rest)?],
        };
        let sine = if negative { sine.negated() } else { sine };
        Some(match quarters {
            0 => [sine, cosine],
            1 => [cosine, sine.negated()],
            2 => [sine.negated(), cosine.negated()],
            _ => [cosine.negated(), sine],
        })
    }

    fn turn(&self, function: Function, angle: &Quotient) -> Option<Quotient> {
        match known_turn(function, angle) {
            Some(value) => self.quotient(&value),
            None => Some(atom(function, angle)),
        }
    }

    fn turns_of_sum(&self, first: &Quotient, second: &Quotient) -> Option<[Quotient; 2]> {
        let ([sine, cosine], [other_sine, other_cosine]) = (self.turns(first)?, self.turns(second)?);
        let sines = self.product(&sine, &other_sine)?;
        let cosines = self.product(&cosine, &other_cosine)?;
        let mixed = self.sum(&self.product(&sine, &other_cosine)?, &self.product(&cosine, &other_sine)?)?;
        Some([mixed, self.sum(&cosines, &sines.negated())?])
    }

    fn exponential(&self, form: &Quotient) -> Option<Quotient> {
        let mut product = Quotient::one();
        for (monomial, coefficient) in form.numerator.terms() {
            let share = Quotient::reduced(&Polynomial::term(Rational::ONE, monomial.clone()), &form.denominator)?;
            let factor = if let Some((Expr::Apply(Function::Ln, inner), 1)) = share.as_atom_power() {
                self.power(&self.quotient(inner.first()?)?, &Quotient::constant(coefficient.clone()))?
            } else {
                let (times, part) = whole_and_part(coefficient, &Monomial::default())?;
                let part = self.quotient(&part)?.times(&share)?.to_expr();
                Polynomial::term(Rational::ONE, Monomial::atom(Expr::apply(Function::Exp, part), times)).into()
            };
            product = self.product(&product, &factor)?;
        }
        Some(product)
    }

    fn logarithm(&self, form: &Quotient) -> Option<Quotient> {
        if form.as_constant().is_some_and(|value| value.is_one()) {
            return Some(Quotient::zero());
        }
        let mut sum = Quotient::zero();
        let mut rest = form.clone();
        let (_, above, _) = form.numerator.primitive();
        let (_, below, _) = form.denominator.primitive();
        for (part, power) in above.over(&below).powers() {
            let Expr::Apply(Function::Exp, inner) = part else { continue };
            let taken: Quotient = Polynomial::term(Rational::ONE, Monomial::atom(part.clone(), -power)).into();
            rest = rest.times(&taken)?;
            sum = sum.plus(&self.quotient(inner.first()?)?.scaled(&Rational::from(power)))?;
        }
        if self.expand {
            for (part, power) in above.over(&below).powers() {
                let Expr::Symbol(symbol) = part else { continue };
                if (self.positive)(*symbol) {
                    let taken = Quotient::atom(part.clone());
                    rest = rest.times(&taken.power(-power)?)?;
                    sum = sum.plus(&atom(Function::Ln, &taken).scaled(&Rational::from(power)))?;
                }
            }
        }
        if self.expand && !rest.numerator.is_zero() {
            let (number, _) = rest.numerator.content();
            rest = rest.scaled(&(Rational::ONE / &number));
            let parts = [(Rational::from(number.numerator().clone()), 1), (number.denominator().clone().into(), -1)];
            for (part, sign) in parts.into_iter().filter(|(part, _)| !part.is_one()) {
                sum = sum.plus(&atom(Function::Ln, &Quotient::constant(part)).scaled(&Rational::from(sign)))?;
            }
        }
        if rest.as_constant().is_some_and(|value| value.is_one()) {
            return Some(sum);
        }
        sum.plus(&atom(Function::Ln, &rest))
    }
}

/// Values at zero, a twelfth and an eighth of a turn, and at inverse functions.
fn known_turn(function: Function, angle: &Quotient) -> Option<Expr> {
    let sine = function == Function::Sin;
    if angle.numerator.is_zero() {
        return Some(Expr::integer(i64::from(!sine)));
    }
    let (monomial, coefficient) = angle.as_polynomial().filter(|sum| sum.len() == 1)?.leading()?;
    if *monomial == Monomial::atom(Expr::Pi, 1) {
        return if *coefficient == Rational::ONE / Rational::from(6) {
            Some(if sine { Expr::ratio(1, 2) } else { Expr::integer(3).sqrt() * Expr::ratio(1, 2) })
        } else if *coefficient == Rational::ONE / Rational::from(4) {
            Some(Expr::integer(2).sqrt() * Expr::ratio(1, 2))
        } else {
            None
        };
    }
    let (Expr::Apply(inverse, arguments), 1) = angle.as_atom_power()? else { return None };
    match (inverse, arguments.as_ref()) {
        (Function::Asin, [value]) if sine => Some(value.clone()),
        (Function::Acos, [value]) if !sine => Some(value.clone()),
        (Function::Asin | Function::Acos, [value]) => Some((Expr::one() - value.clone().powi(2)).sqrt()),
        (Function::Atan2, [y, x]) => {
            let radius = (x.clone().powi(2) + y.clone().powi(2)).sqrt();
            Some(if sine { y.clone() } else { x.clone() } / radius)
        }
        _ => None,
    }
}

fn atom(function: Function, argument: &Quotient) -> Quotient {
    Quotient::atom(Expr::Apply(function, Arc::new([argument.to_expr()])))
}

/// The principal arctangent.
fn arctangent(slope: &Quotient) -> Quotient {
    if slope.numerator.is_zero() {
        return Quotient::zero();
    }
    let negative = slope.numerator.is_negative();
    let size = if negative { slope.negated() } else { slope.clone() };
    let angle = Quotient::atom(Expr::Apply(Function::Atan2, Arc::new([size.to_expr(), Expr::one()])));
    if negative { angle.negated() } else { angle }
}

/// The number of quarter turns (0 to 3) that an angle contains, and what remains.
fn split_quarters(angle: &Quotient) -> Option<(u8, Quotient)> {
    let pi = Monomial::atom(Expr::Pi, 1);
    let turns = angle.as_polynomial().and_then(|sum| sum.terms().find(|(monomial, _)| **monomial == pi));
    let Some((_, coefficient)) = turns else { return Some((0, angle.clone())) };
    let quarters = (coefficient * Rational::from(2)).round();
    let taken = Polynomial::term(Rational::from(quarters.clone()) / Rational::from(2), pi);
    let rest = angle.plus(&Quotient::from(taken).negated())?;
    let remainder = ((quarters % dashu::Integer::from(4)) + dashu::Integer::from(4)) % dashu::Integer::from(4);
    Some((u8::try_from(remainder).ok()?, rest))
}

/// An angle as a sum of two: its first term and the others, or one of a whole multiple and the rest of it.
fn split_sum(angle: &Quotient) -> Option<(Quotient, Quotient)> {
    let (monomial, coefficient) = angle.numerator.leading()?;
    let whole =
        |value: &Rational| Quotient::reduced(&Polynomial::term(value.clone(), monomial.clone()), &angle.denominator);
    let first = if angle.numerator.len() > 1 {
        whole(coefficient)?
    } else {
        let multiple = u32::try_from(coefficient.numerator().clone()).ok()?;
        if !(2..=MAX_MULTIPLE).contains(&multiple) {
            return None;
        }
        whole(&(coefficient / Rational::from(multiple)))?
    };
    let second = angle.plus(&first.negated())?;
    Some((first, second))
}
