//! Derivatives.

use std::sync::Arc;

use super::super::{Expr, Function, Piecewise, Symbol};

impl Expr {
    /// The derivative with respect to `symbol`; pieces are differentiated one by one.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    /// use momentous_quantity::Dimension;
    /// let mut table = SymbolTable::default();
    /// let t = table.intern(SymbolEntry { name: "t".into(), dimension: Dimension::TIME, meaning: String::new() });
    /// assert_eq!(Expr::from(t).powi(3).differentiate(t).text(&table), "3*t^2");
    /// ```
    #[must_use]
    pub fn differentiate(&self, symbol: Symbol) -> Self {
        if !self.contains(symbol) {
            return Self::zero();
        }
        match self {
            Self::Number(_) | Self::Pi => Self::zero(),
            Self::Symbol(written) => Self::integer(i64::from(*written == symbol)),
            Self::Sum(terms) => Self::sum(terms.iter().map(|term| term.differentiate(symbol))),
            Self::Product(factors) => {
                let one_changed = |changed: usize| {
                    Self::product(factors.iter().enumerate().map(|(index, factor)| {
                        if index == changed { factor.differentiate(symbol) } else { factor.clone() }
                    }))
                };
                Self::sum((0..factors.len()).map(one_changed))
            }
            Self::Power(pair) => power(&pair.0, &pair.1, symbol),
            Self::Apply(function, arguments) => match arguments.as_ref() {
                [y, x] => {
                    let turning = x.clone() * y.differentiate(symbol) - y.clone() * x.differentiate(symbol);
                    turning / (x.clone().powi(2) + y.clone().powi(2))
                }
                [argument] => function.slope(argument) * argument.differentiate(symbol),
                _ => Self::zero(),
            },
            Self::Piecewise(piecewise) => {
                let pieces = piecewise.pieces.iter();
                let pieces = pieces.map(|(until, value)| (until.clone(), value.differentiate(symbol))).collect();
                Self::Piecewise(Arc::new(Piecewise { variable: piecewise.variable.clone(), pieces }))
            }
        }
    }
}

fn power(base: &Expr, exponent: &Expr, symbol: Symbol) -> Expr {
    let lowered = base.clone().power(exponent.clone() - Expr::one());
    let by_base = Expr::product([exponent.clone(), lowered, base.differentiate(symbol)]);
    if !exponent.contains(symbol) {
        return by_base;
    }
    let growth = Expr::apply(Function::Ln, base.clone()) * exponent.differentiate(symbol);
    by_base + base.clone().power(exponent.clone()) * growth
}

impl Function {
    /// The derivative of a function of one argument, at that argument.
    fn slope(self, argument: &Expr) -> Expr {
        let inner = argument.clone();
        let other = |function| Expr::apply(function, inner.clone());
        let arc = || (Expr::one() - inner.clone().powi(2)).power(Expr::ratio(-1, 2));
        match self {
            Self::Sin => other(Self::Cos),
            Self::Cos => -other(Self::Sin),
            Self::Tan => other(Self::Cos).powi(-2),
            Self::Asin => arc(),
            Self::Acos => -arc(),
            Self::Exp => other(Self::Exp),
            Self::Ln => inner.powi(-1),
            Self::Abs => inner.clone() / other(Self::Abs),
            Self::Atan2 => Expr::zero(),
        }
    }
}
