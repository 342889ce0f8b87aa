//! Words for an expression that its author gives no label: `v_B2 - v_A2` is the velocity of B minus that of A.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_quantity::Rational;

use super::builder::Builder;

impl Builder<'_> {
    /// The name of a term in words, made of the meanings of its quantities; none where it has no short one.
    pub(super) fn spoken(&self, term: &Expr) -> Option<String> {
        match term {
            Expr::Symbol(symbol) => {
                let meaning = &self.symbols.entry(*symbol).meaning;
                (!meaning.is_empty() && !self.is_literal(*symbol)).then(|| meaning.clone())
            }
            Expr::Sum(terms) => {
                let [first, second] = &terms[..] else { return None };
                match (opposite(first), opposite(second)) {
                    (None, None) => Some(format!("the sum of {} and {}", self.spoken(first)?, self.spoken(second)?)),
                    (None, Some(taken)) => Some(format!("{} minus {}", self.spoken(first)?, self.spoken(&taken)?)),
                    (Some(taken), None) => Some(format!("{} minus {}", self.spoken(second)?, self.spoken(&taken)?)),
                    (Some(_), Some(_)) => None,
                }
            }
            Expr::Product(factors) => {
                let [first, second] = &factors[..] else { return None };
                if let Expr::Number(number) = first {
                    let times =
                        if *number == Rational::from(2) { "twice".to_owned() } else { format!("{number} times") };
                    return Some(format!("{times} {}", self.spoken(second)?));
                }
                match (inverse(first), inverse(second)) {
                    (None, Some(below)) => {
                        Some(format!("the ratio of {} to {}", self.spoken(first)?, self.spoken(below)?))
                    }
                    (Some(below), None) => {
                        Some(format!("the ratio of {} to {}", self.spoken(second)?, self.spoken(below)?))
                    }
                    (None, None) => {
                        Some(format!("the product of {} and {}", self.spoken(first)?, self.spoken(second)?))
                    }
                    (Some(_), Some(_)) => None,
                }
            }
            Expr::Apply(Function::Abs, inner) => Some(format!("the magnitude of {}", self.spoken(inner.first()?)?)),
            _ => None,
        }
    }
}

/// The term of which another is the negative.
fn opposite(term: &Expr) -> Option<Expr> {
    let Expr::Product(factors) = term else { return None };
    match &factors[..] {
        [Expr::Number(minus), rest @ ..] if *minus == Rational::from(-1) => match rest {
            [only] => Some(only.clone()),
            several => Some(Expr::Product(several.into())),
        },
        _ => None,
    }
}

/// The term of which another is the inverse.
fn inverse(term: &Expr) -> Option<&Expr> {
    let Expr::Power(power) = term else { return None };
    let (base, exponent) = power.as_ref();
    matches!(exponent, Expr::Number(minus) if *minus == Rational::from(-1)).then_some(base)
}
