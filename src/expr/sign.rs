//! The sign of a number, and of a term with a number in front.

use dashu::base::Sign;

use momentous_quantity::Rational;

use super::Expr;

pub(super) fn is_negative(number: &Rational) -> bool {
    number.sign() == Sign::Negative
}

/// The absolute value of a number that is negative, or of a product with such a number in front.
pub(super) fn without_minus(term: &Expr) -> Option<Expr> {
    let number = match term {
        Expr::Product(factors) => factors.first()?.as_number()?,
        other => other.as_number()?,
    };
    is_negative(number).then(|| -term.clone())
}
