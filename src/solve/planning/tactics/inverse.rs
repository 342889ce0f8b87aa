//! Undoing what is done to an unknown that is written once: `f(x) = c` gives `x = g(c)`, for every `g` that there is.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::tidy::{negative, over};

/// All values of `unknown` for which `side`, where it is written once, equals `value`; `None` where something is done to
/// it that cannot be undone. Angles: all branches between -pi and 2 pi that an unknown of a triangle may take.
pub(super) fn undo(side: &Expr, value: Expr, unknown: Symbol, positive: &dyn Fn(Symbol) -> bool) -> Option<Vec<Expr>> {
    let sure = |part: &Expr| matches!(part, Expr::Symbol(symbol) if positive(*symbol));
    let (part, values) = match side {
        Expr::Symbol(written) => return (*written == unknown).then(|| vec![value]),
        Expr::Sum(parts) => {
            let (inner, others) = apart(parts, unknown)?;
            (inner, vec![Expr::sum([value, negative(&Expr::sum(others))])])
        }
        Expr::Product(parts) => {
            let (inner, others) = apart(parts, unknown)?;
            (inner, vec![over(&value, &Expr::product(others))])
        }
        Expr::Power(pair) if pair.1.contains(unknown) => (&pair.1, vec![over(&ln(value), &ln(pair.0.clone()))]),
        Expr::Power(pair) => match pair.1.as_number() {
            Some(exponent) => (&pair.0, roots(value, exponent, sure(&pair.0))),
            // Of a power that is not told, only a positive base has one root.
            None => (&pair.0, sure(&pair.0).then(|| value.power(over(&Expr::one(), &pair.1))).into_iter().collect()),
        },
        Expr::Apply(Function::Atan2, parts) => match parts.as_ref() {
            [y, x] if y.contains(unknown) => (y, vec![x.clone() * tan(value)]),
            [y, x] => (x, vec![y.clone() / tan(value)]),
            _ => return None,
        },
        Expr::Apply(function, parts) => {
            let inner = parts.first()?;
            (inner, inverses(*function, value, sure(inner)))
        }
        Expr::Number(_) | Expr::Pi | Expr::Piecewise(_) => return None,
    };
    if values.is_empty() {
        return None;
    }
    let mut undone = Vec::new();
    for value in values {
        undone.extend(undo(part, value, unknown, positive)?);
    }
    Some(undone)
}

/// The part with the unknown, and the others.
fn apart(parts: &[Expr], unknown: Symbol) -> Option<(&Expr, Vec<Expr>)> {
    let inner = parts.iter().find(|part| part.contains(unknown))?;
    Some((inner, parts.iter().filter(|part| !part.contains(unknown)).cloned().collect()))
}

/// The bases whose power is `value`.
fn roots(value: Expr, exponent: &Rational, positive: bool) -> Vec<Expr> {
    let even = (exponent.numerator() % 2_i8) == 0;
    let root = value.power(Expr::Number(Rational::ONE / exponent.clone()));
    if even && !positive { vec![root.clone(), -root] } else { vec![root] }
}

fn inverses(function: Function, value: Expr, positive: bool) -> Vec<Expr> {
    match function {
        Function::Sin => {
            let principal = Expr::apply(Function::Asin, value);
            vec![principal.clone(), Expr::Pi - principal]
        }
        Function::Cos => {
            let principal = Expr::apply(Function::Acos, value);
            if positive { vec![principal] } else { vec![principal.clone(), -principal] }
        }
        Function::Tan => {
            let principal = value.atan2(Expr::one());
            vec![principal.clone(), Expr::Pi + principal]
        }
        Function::Asin => vec![value.sin()],
        Function::Acos => vec![value.cos()],
        Function::Exp => vec![ln(value)],
        Function::Ln => vec![Expr::apply(Function::Exp, value)],
        Function::Abs => {
            if positive {
                vec![value]
            } else {
                vec![value.clone(), -value]
            }
        }
        Function::Atan2 => Vec::new(),
    }
}

fn ln(value: Expr) -> Expr {
    Expr::apply(Function::Ln, value)
}

fn tan(value: Expr) -> Expr {
    Expr::apply(Function::Tan, value)
}
