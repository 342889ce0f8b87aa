//! All partial derivatives of a term at given values, in one pass over it and without a term being made.
//! (Reverse accumulation: Griewank and Walther, Evaluating Derivatives, chapter 3.)

use smallvec::SmallVec;

use super::super::evaluate::raise;
use super::super::{Expr, Function, Symbol};

/// Most products have no more factors.
const FEW: usize = 8;

impl Expr {
    /// Gives `add` the partial derivative by a symbol, times `share`, once for each place where the symbol stands; the
    /// derivative is the sum over these places. Where there is none, what is added is not finite.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    /// use momentous_quantity::Dimension;
    ///
    /// let mut table = SymbolTable::default();
    /// let v = table.intern(SymbolEntry { name: "v".into(), dimension: Dimension::VELOCITY, meaning: "v".into() });
    /// let energy = Expr::from(v).powi(2) / Expr::integer(2);
    /// let mut slope = 0.0;
    /// energy.slopes(&|_| 3.0, 1.0, &mut |_, part| slope += part);
    /// assert_eq!(slope, 3.0);
    /// ```
    pub fn slopes(&self, value: &dyn Fn(Symbol) -> f64, share: f64, add: &mut dyn FnMut(Symbol, f64)) {
        match self {
            Self::Number(_) | Self::Pi => {}
            Self::Symbol(symbol) => add(*symbol, share),
            Self::Sum(terms) => terms.iter().for_each(|term| term.slopes(value, share, add)),
            Self::Product(factors) => {
                let values: SmallVec<[f64; FEW]> = factors.iter().map(|factor| factor.evaluate(value)).collect();
                for (place, factor) in factors.iter().enumerate() {
                    let others = values.iter().enumerate().filter(|(other, _)| *other != place);
                    factor.slopes(value, share * others.map(|(_, value)| value).product::<f64>(), add);
                }
            }
            Self::Power(pair) => {
                let (base, exponent) = (pair.0.evaluate(value), pair.1.evaluate(value));
                pair.0.slopes(value, share * exponent * raise(base, exponent - 1.0), add);
                if pair.1.as_number().is_none() {
                    pair.1.slopes(value, share * raise(base, exponent) * libm::log(base), add);
                }
            }
            Self::Apply(Function::Atan2, parts) => {
                let [y, x] = parts.as_ref() else { return };
                let (above, along) = (y.evaluate(value), x.evaluate(value));
                let square = above * above + along * along;
                y.slopes(value, share * along / square, add);
                x.slopes(value, -share * above / square, add);
            }
            Self::Apply(function, parts) => {
                for part in parts.iter() {
                    part.slopes(value, share * function.slope_at(part.evaluate(value)), add);
                }
            }
            Self::Piecewise(piecewise) => {
                if let Some(piece) = piecewise.piece(value) {
                    piece.slopes(value, share, add);
                }
            }
        }
    }
}

impl Function {
    /// The derivative of a function of one argument.
    #[must_use]
    pub fn slope_at(self, argument: f64) -> f64 {
        match self {
            Self::Sin => libm::cos(argument),
            Self::Cos => -libm::sin(argument),
            Self::Tan => 1.0 + libm::tan(argument) * libm::tan(argument),
            Self::Asin => 1.0 / (1.0 - argument * argument).sqrt(),
            Self::Acos => -1.0 / (1.0 - argument * argument).sqrt(),
            Self::Exp => libm::exp(argument),
            Self::Ln => 1.0 / argument,
            Self::Abs => argument / argument.abs(),
            Self::Atan2 => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;
    use super::*;

    #[test]
    fn slopes_are_those_of_the_derivative() {
        for text in [
            "a*x^2/2 + b*x - c",
            "(a + x)/(b - x)^2",
            "sqrt(a^2 + x^2)*x",
            "sin(a*x) + cos(x)^2 - tan(x/3)",
            "asin(x/9) + acos(x/9)",
            "e^(a*x) + exp(-x) + ln(b + x)",
            "a^x",
            "abs(x - 20)*b",
            "atan2(x, a)",
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            let value = |symbol: Symbol| [1.3, 0.7, 2.1, 1.7].get(symbol.index()).copied().unwrap_or(1.1);
            for symbol in term.symbols() {
                let mut slope = 0.0;
                term.slopes(&value, 1.0, &mut |of_symbol, part| slope += if of_symbol == symbol { part } else { 0.0 });
                let expected = term.differentiate(symbol).evaluate(&value);
                assert!((slope - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{text}: {slope} not {expected}");
            }
        }
    }
}
