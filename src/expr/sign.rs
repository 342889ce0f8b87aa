//! The sign in front of a term, seen without laying it out.

use dashu::base::Sign;

use crate::quantity::Rational;

use super::Expr;
use super::grammar::text::{reads_as_decimal, split_quotient};

impl Expr {
    /// Whether the term begins with a minus as it is printed, be it behind a bracket.
    ///
    /// ```
    /// use momentous::expr::Expr;
    /// let below_one = Expr::Pi - Expr::one();
    /// assert!((-Expr::Pi + Expr::one()).begins_with_minus() && !below_one.begins_with_minus());
    /// ```
    #[must_use]
    pub fn begins_with_minus(&self) -> bool {
        let of_first = |parts: &[Self]| parts.first().is_some_and(Self::begins_with_minus);
        match self {
            Self::Number(value) => is_negative(value),
            Self::Sum(terms) => of_first(terms),
            Self::Product(factors) => match factors.first() {
                Some(Self::Number(value)) => is_negative(value),
                // A fraction bar stands between the bracket and what is before it.
                _ => of_first(factors) && split_quotient(factors, reads_as_decimal).1.is_empty(),
            },
            _ => false,
        }
    }
}

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
