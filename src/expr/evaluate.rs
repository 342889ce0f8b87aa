//! The value of a term in floating point, the same on every platform.

use momentous_quantity::nearest_double;

use super::{Expr, Function, Piecewise, Symbol};

impl Expr {
    /// The value, with `value` giving that of each symbol in base units. Not a number where the term has no real value.
    ///
    /// ```
    /// use momentous_expr::Expr;
    /// let half = Expr::ratio(1, 2);
    /// assert_eq!((half.clone() * (half + Expr::integer(1)).powi(2)).evaluate(&|_| 0.0), 1.125);
    /// ```
    pub fn evaluate(&self, value: &dyn Fn(Symbol) -> f64) -> f64 {
        match self {
            Self::Number(number) => nearest_double(number),
            Self::Pi => std::f64::consts::PI,
            Self::Symbol(symbol) => value(*symbol),
            Self::Sum(terms) => terms.iter().map(|term| term.evaluate(value)).sum(),
            Self::Product(factors) => factors.iter().map(|factor| factor.evaluate(value)).product(),
            Self::Power(pair) => raise(pair.0.evaluate(value), pair.1.evaluate(value)),
            Self::Apply(function, arguments) => match arguments.as_ref() {
                [argument] => function.evaluate(argument.evaluate(value), 1.0),
                [first, second] => function.evaluate(first.evaluate(value), second.evaluate(value)),
                _ => f64::NAN,
            },
            Self::Piecewise(piecewise) => piecewise.piece(value).map_or(f64::NAN, |piece| piece.evaluate(value)),
        }
    }
}

impl Piecewise {
    /// The piece that holds at these values.
    pub(super) fn piece(&self, value: &dyn Fn(Symbol) -> f64) -> Option<&Expr> {
        let at = self.variable.evaluate(value);
        let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= until.evaluate(value));
        self.pieces.iter().find(|(until, _)| holds(until)).map(|(_, piece)| piece)
    }
}

impl Function {
    /// The value at an argument; `second` is that of `atan2`, and ignored by all others.
    #[must_use]
    pub fn evaluate(self, argument: f64, second: f64) -> f64 {
        match self {
            Self::Sin => libm::sin(argument),
            Self::Cos => libm::cos(argument),
            Self::Tan => libm::tan(argument),
            Self::Asin => libm::asin(argument),
            Self::Acos => libm::acos(argument),
            Self::Atan2 => libm::atan2(argument, second),
            Self::Exp => libm::exp(argument),
            Self::Ln => libm::log(argument),
            Self::Abs => argument.abs(),
        }
    }
}

/// Small whole powers by multiplication and half powers by the square root: both are exact where the library's power is not.
#[allow(clippy::float_cmp, reason = "exponents that are exactly these")]
pub(super) fn raise(base: f64, exponent: f64) -> f64 {
    if exponent == 0.5 {
        return base.sqrt();
    }
    if exponent == -0.5 {
        return 1.0 / base.sqrt();
    }
    #[allow(clippy::cast_possible_truncation, reason = "compared with the exponent itself right after")]
    let whole = exponent as i32;
    if f64::from(whole) != exponent || whole.unsigned_abs() > 8 {
        return libm::pow(base, exponent);
    }
    let power = (0..whole.unsigned_abs()).fold(1.0, |power, _| power * base);
    if whole < 0 { 1.0 / power } else { power }
}
