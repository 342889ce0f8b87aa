//! The value of a term in numbers that know their error.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;

use super::number::exact::Exact;
use super::number::real::{Real, Sign};

/// The value of a term, with `value` giving that of each symbol in base units.
///
/// ```
/// use momentous_expr::Expr;
/// use momentous_solve::{Precise, Real, Sign, evaluate};
/// let root = Expr::integer(2).sqrt();
/// let difference = root.clone() * root - Expr::integer(2);
/// let value: Precise = evaluate(&difference, &|_| Precise::integer(0));
/// assert!(value.rough().abs() < 1e-70);
/// ```
pub fn evaluate<R: Real>(term: &Expr, value: &dyn Fn(Symbol) -> R) -> R {
    match term {
        Expr::Number(number) => R::from_exact(&Exact::from(number.clone())),
        Expr::Pi => R::from_exact(&Exact { rational: momentous_quantity::Rational::ONE, pi_power: 1 }),
        Expr::Symbol(symbol) => value(*symbol),
        Expr::Sum(terms) => folded(terms, value, 0, R::add),
        Expr::Product(factors) => folded(factors, value, 1, R::mul),
        Expr::Power(pair) => raised(&evaluate(&pair.0, value), &pair.1, value),
        Expr::Apply(function, arguments) => match (function, arguments.as_ref()) {
            (Function::Atan2, [y, x]) => evaluate(y, value).atan2(&evaluate(x, value)),
            (_, [argument]) => evaluate(argument, value).apply(*function),
            _ => R::not_real(),
        },
        Expr::Piecewise(piecewise) => {
            let at = evaluate(&piecewise.variable, value);
            let reaches = |until: &Option<Expr>| {
                let rest = |until: &Expr| at.sub(&evaluate(until, value)).sign();
                let is_end = |until: &Expr| *until == piecewise.variable;
                until.as_ref().is_none_or(|until| is_end(until) || matches!(rest(until), Sign::Negative | Sign::Zero))
            };
            let piece = piecewise.pieces.iter().find(|(until, _)| reaches(until));
            piece.map_or_else(R::not_real, |(_, piece)| evaluate(piece, value))
        }
    }
}

fn folded<R: Real>(terms: &[Expr], value: &dyn Fn(Symbol) -> R, none: i64, join: fn(&R, &R) -> R) -> R {
    let values = terms.iter().map(|term| evaluate(term, value));
    values.reduce(|left, right| join(&left, &right)).unwrap_or_else(|| R::integer(none))
}

fn raised<R: Real>(base: &R, exponent: &Expr, value: &dyn Fn(Symbol) -> R) -> R {
    let Some(number) = exponent.as_number() else { return base.raise(&evaluate(exponent, value)) };
    let parts = (i32::try_from(number.numerator()), u32::try_from(number.denominator()));
    match parts {
        (Ok(whole), Ok(1)) => base.powi(whole),
        (Ok(above), Ok(degree)) => base.root(degree).powi(above),
        _ => base.raise(&evaluate(exponent, value)),
    }
}
