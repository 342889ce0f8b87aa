//! Proofs by algebra that two formulas are equal, where they are short.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::equal_rational;
use momentous_expr::equal_where;
use momentous_quantity::Rational;

use super::super::expected::ExpectedFormula;

/// Two formulas whose canonical forms may have more terms than this are compared at points only.
const MOST_TERMS: f64 = 300.0;

/// The result of algebra on two formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Proof {
    /// They are equal wherever both have a value.
    Equal,
    /// They are not: of rational formulas algebra knows.
    Different,
    /// It was not tried, or no proof was found.
    None,
}

/// Tries to prove two formulas equal; not where their forms could grow large.
pub(super) fn prove(expected: &ExpectedFormula, answer: &Expr) -> Proof {
    let fixed = |symbol: Symbol| {
        let zero = expected.domain.iter().any(|(bound, low, high)| *bound == symbol && *low == 0.0 && *high == 0.0);
        zero.then(Expr::zero)
    };
    let (right, given) = (expected.formula.substitute(&fixed), answer.substitute(&fixed));
    let (terms_of_right, other) = (terms(&right), terms(&given));
    if terms_of_right.0 * other.1 + terms_of_right.1 * other.0 > MOST_TERMS {
        return Proof::None;
    }
    if is_rational(&right) && is_rational(&given) {
        return match equal_rational(&right, &given) {
            Some(true) => Proof::Equal,
            Some(false) => Proof::Different,
            None => Proof::None,
        };
    }
    let positive = |symbol: Symbol| expected.domain.iter().any(|(bound, low, _)| *bound == symbol && *low > 0.0);
    if equal_where(&right, &given, &positive) { Proof::Equal } else { Proof::None }
}

/// Whether a formula has neither roots nor functions.
fn is_rational(formula: &Expr) -> bool {
    let is_rational_itself = match formula {
        Expr::Apply(..) | Expr::Piecewise(_) => false,
        Expr::Power(pair) => pair.1.as_number().is_some_and(Rational::is_int),
        _ => true,
    };
    is_rational_itself && formula.children().all(is_rational)
}

/// About how many terms the canonical form of a formula can have above and below its bar.
fn terms(formula: &Expr) -> (f64, f64) {
    match formula {
        Expr::Sum(parts) => parts
            .iter()
            .map(terms)
            .fold((0.0, 1.0), |(above, below), (top, under)| (above * under + top * below, below * under)),
        Expr::Product(parts) => {
            parts.iter().map(terms).fold((1.0, 1.0), |(above, below), (top, under)| (above * top, below * under))
        }
        Expr::Power(pair) => {
            let (above, below) = terms(&pair.0);
            let exponent = pair.1.as_number().map_or(1.0, |number| number.to_f64().value());
            let size = exponent.abs().max(1.0);
            let (above, below) = (libm::pow(above, size), libm::pow(below, size));
            if exponent < 0.0 { (below, above) } else { (above, below) }
        }
        Expr::Apply(_, arguments) => {
            let inside: f64 = arguments
                .iter()
                .map(|argument| {
                    let (above, below) = terms(argument);
                    above * below
                })
                .sum();
            (inside.max(1.0), 1.0)
        }
        Expr::Piecewise(_) => (f64::INFINITY, 1.0),
        Expr::Number(_) | Expr::Pi | Expr::Symbol(_) => (1.0, 1.0),
    }
}
