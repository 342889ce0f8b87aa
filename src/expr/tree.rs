//! The expression tree. It keeps the order in which an author or a law wrote its terms, so that it can be taught from;
//! equality of values is decided elsewhere, by the canonical form.

use std::collections::BTreeSet;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use dashu::base::BitTest;

use momentous_quantity::Decimal;
use momentous_quantity::Rational;
use momentous_quantity::Unit;

use super::Symbol;

/// A symbolic term.
///
/// Constructors fold numbers and drop neutral elements, and do no more: `m (v - u)` stays a product.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Expr {
    /// An exact number.
    Number(Rational),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// A quantity of the problem.
    Symbol(Symbol),
    /// Two or more terms.
    Sum(Arc<[Expr]>),
    /// Two or more factors.
    Product(Arc<[Expr]>),
    /// A base and its exponent; a square root is the power 1/2, a quotient a product with the power -1.
    Power(Arc<(Expr, Expr)>),
    /// A function of its arguments.
    Apply(Function, Arc<[Expr]>),
    /// A function of one variable, given piece by piece.
    Piecewise(Arc<Piecewise>),
}

/// The functions that occur in the subject's laws. Angles are in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Principal arc sine.
    Asin,
    /// Principal arc cosine.
    Acos,
    /// Angle of the point (x, y), written `atan2(y, x)`.
    Atan2,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Absolute value.
    Abs,
}

/// Pieces in increasing order of the variable: each holds until its bound, the last one for ever if it has none.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Piecewise {
    /// The variable that chooses the piece, time as a rule.
    pub variable: Expr,
    /// (until, value): the value holds while the variable is at most `until`.
    pub pieces: Vec<(Option<Expr>, Expr)>,
}

impl Expr {
    /// A value with its unit as a number of coherent SI units; a degree is pi/180.
    #[must_use]
    pub fn measured(value: &Decimal, unit: &Unit) -> Self {
        let factor = unit.factor();
        let number = Self::Number(value.to_rational() * factor.rational);
        if factor.pi == 0 { number } else { number * Self::Pi.powi(i64::from(factor.pi)) }
    }

    /// The integer `value`.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self::Number(Rational::from(value))
    }

    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Self::integer(0)
    }

    /// One.
    #[must_use]
    pub fn one() -> Self {
        Self::integer(1)
    }

    /// The fraction `numerator / denominator`; a zero denominator gives zero.
    #[must_use]
    pub fn ratio(numerator: i64, denominator: u32) -> Self {
        if denominator == 0 {
            return Self::zero();
        }
        Self::Number(Rational::from(numerator) / Rational::from(denominator))
    }

    /// Whether it is a product of which one factor is a hundred, as a percentage is often written.
    #[must_use]
    pub fn is_a_hundredfold(&self) -> bool {
        match self {
            Self::Number(number) => *number == Rational::from(100),
            Self::Product(factors) => factors.iter().any(Self::is_a_hundredfold),
            _ => false,
        }
    }

    /// The value, where the term is a plain number.
    #[must_use]
    pub fn as_number(&self) -> Option<&Rational> {
        match self {
            Self::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Whether the term is the number zero (as written: no algebra is done).
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.as_number().is_some_and(Rational::is_zero)
    }

    /// Whether the term is the number one (as written: no algebra is done).
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.as_number().is_some_and(Rational::is_one)
    }

    /// The sum of the terms, in order; nested sums are joined, numeric zeros dropped.
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let mut flat = Vec::new();
        for term in terms {
            match term {
                Self::Sum(inner) => flat.extend(inner.iter().cloned()),
                term if term.is_zero() => {}
                term => flat.push(term),
            }
        }
        if flat.iter().all(|term| term.as_number().is_some()) {
            return Self::Number(
                flat.iter().filter_map(Self::as_number).fold(Rational::ZERO, |sum, value| sum + value),
            );
        }
        match flat.len() {
            1 => flat.swap_remove(0),
            _ => Self::Sum(flat.into()),
        }
    }

    /// The product of the factors, in order; nested products are joined, numbers gathered in front.
    #[must_use]
    pub fn product(factors: impl IntoIterator<Item = Self>) -> Self {
        let mut number = Rational::ONE;
        let mut flat = Vec::new();
        let mut push = |factor: &Self, flat: &mut Vec<Self>| match factor {
            Self::Number(value) if number.is_one() => number.clone_from(value),
            Self::Number(value) => number *= value,
            other => flat.push(other.clone()),
        };
        for factor in factors {
            match &factor {
                Self::Product(inner) => inner.iter().for_each(|factor| push(factor, &mut flat)),
                other => push(other, &mut flat),
            }
        }
        if number.is_zero() || flat.is_empty() {
            return Self::Number(number);
        }
        if !number.is_one() {
            flat.insert(0, Self::Number(number));
        }
        match flat.len() {
            1 => flat.swap_remove(0),
            _ => Self::Product(flat.into()),
        }
    }

    /// `self` to the power `exponent`; integer powers of numbers are worked out.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        if exponent.is_one() || self.is_one() {
            return self;
        }
        if exponent.is_zero() {
            return Self::one();
        }
        if let (Self::Number(base), Self::Number(power)) = (&self, &exponent)
            && power.denominator().is_one()
            && let Ok(power) = i16::try_from(power.numerator().clone())
            && usize::from(power.unsigned_abs()).saturating_mul(bits(base)) <= MAX_BITS
            && !(base.is_zero() && power < 0)
        {
            return Self::Number(base.pow(isize::from(power)));
        }
        if let (Self::Power(inner), Self::Number(outer)) = (&self, &exponent)
            && outer.denominator().is_one()
            && let Self::Number(power) = &inner.1
        {
            return inner.0.clone().power(Self::Number(power * outer));
        }
        Self::Power(Arc::new((self, exponent)))
    }

    /// An integer power.
    #[must_use]
    pub fn powi(self, exponent: i64) -> Self {
        self.power(Self::integer(exponent))
    }

    /// The square root.
    #[must_use]
    pub fn sqrt(self) -> Self {
        self.power(Self::ratio(1, 2))
    }

    /// A function of one argument.
    #[must_use]
    pub fn apply(function: Function, argument: Self) -> Self {
        Self::Apply(function, Arc::new([argument]))
    }

    /// The sine; of zero, zero.
    #[must_use]
    pub fn sin(self) -> Self {
        if self.is_zero() { self } else { Self::apply(Function::Sin, self) }
    }

    /// The cosine; of zero, one.
    #[must_use]
    pub fn cos(self) -> Self {
        if self.is_zero() { Self::one() } else { Self::apply(Function::Cos, self) }
    }

    /// The angle of the point (`x`, `self`).
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        Self::Apply(Function::Atan2, Arc::new([self, x]))
    }

    /// The parts directly below this term.
    pub fn children(&self) -> impl Iterator<Item = &Self> {
        let (parts, last, pieces) = match self {
            Self::Number(_) | Self::Pi | Self::Symbol(_) => (&[][..], None, &[][..]),
            Self::Sum(parts) | Self::Product(parts) | Self::Apply(_, parts) => (parts.as_ref(), None, &[][..]),
            Self::Power(pair) => (std::slice::from_ref(&pair.0), Some(&pair.1), &[][..]),
            Self::Piecewise(piecewise) => {
                (std::slice::from_ref(&piecewise.variable), None, piecewise.pieces.as_slice())
            }
        };
        let pieces = pieces.iter().flat_map(|(until, value)| until.iter().chain([value]));
        parts.iter().chain(last).chain(pieces)
    }

    /// The same term with each part directly below it replaced; rebuilt through the constructors.
    #[must_use]
    pub fn map_children(&self, mut change: impl FnMut(&Self) -> Self) -> Self {
        match self {
            Self::Number(_) | Self::Pi | Self::Symbol(_) => self.clone(),
            Self::Sum(parts) => Self::sum(parts.iter().map(change)),
            Self::Product(parts) => Self::product(parts.iter().map(change)),
            Self::Apply(function, parts) => Self::Apply(*function, parts.iter().map(change).collect()),
            Self::Power(pair) => change(&pair.0).power(change(&pair.1)),
            Self::Piecewise(piecewise) => {
                let variable = change(&piecewise.variable);
                let pieces = piecewise.pieces.iter();
                let pieces = pieces.map(|(until, value)| (until.as_ref().map(&mut change), change(value))).collect();
                Self::Piecewise(Arc::new(Piecewise { variable, pieces }))
            }
        }
    }

    /// Every symbol that occurs, in the order of the symbol table.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        self.add_symbols(&mut symbols);
        symbols
    }

    /// Adds every symbol that occurs, as often as it does.
    pub fn add_symbols(&self, symbols: &mut impl Extend<Symbol>) {
        match self {
            Self::Number(_) | Self::Pi => {}
            Self::Symbol(symbol) => symbols.extend([*symbol]),
            Self::Sum(parts) | Self::Product(parts) | Self::Apply(_, parts) => {
                parts.iter().for_each(|part| part.add_symbols(symbols));
            }
            Self::Power(pair) => {
                pair.0.add_symbols(symbols);
                pair.1.add_symbols(symbols);
            }
            other @ Self::Piecewise(_) => other.children().for_each(|part| part.add_symbols(symbols)),
        }
    }

    /// Whether every symbol that occurs passes the test.
    #[must_use]
    pub fn all_symbols(&self, test: &impl Fn(Symbol) -> bool) -> bool {
        match self {
            Self::Symbol(symbol) => test(*symbol),
            other => other.children().all(|part| part.all_symbols(test)),
        }
    }

    /// Whether `symbol` occurs.
    #[must_use]
    pub fn contains(&self, symbol: Symbol) -> bool {
        !self.all_symbols(&|part| part != symbol)
    }

    /// The term with every symbol for which `value` has a term replaced by it.
    #[must_use]
    pub fn substitute(&self, value: &dyn Fn(Symbol) -> Option<Self>) -> Self {
        match self {
            Self::Symbol(symbol) => value(*symbol).unwrap_or_else(|| self.clone()),
            other => other.map_children(|part| part.substitute(value)),
        }
    }
}

/// Powers of numbers that would take more binary digits than this stay as written.
const MAX_BITS: usize = 2048;

/// The number of binary digits that the larger part of a fraction has.
fn bits(value: &Rational) -> usize {
    value.numerator().bit_len().max(value.denominator().bit_len())
}

impl From<Symbol> for Expr {
    fn from(symbol: Symbol) -> Self {
        Self::Symbol(symbol)
    }
}

impl Neg for Expr {
    type Output = Self;
    fn neg(self) -> Self {
        Self::product([Self::integer(-1), self])
    }
}

impl Add for Expr {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::sum([self, other])
    }
}

impl Sub for Expr {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::sum([self, -other])
    }
}

impl Mul for Expr {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::product([self, other])
    }
}

impl Div for Expr {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::product([self, other.powi(-1)])
    }
}
