//! Terms as text in the grammar that [`super::parse`] reads.

use momentous_quantity::Rational;

use super::super::sign::{is_negative, without_minus};
use super::super::{Expr, Function, Symbol, SymbolTable};

/// How tightly a text holds together; a part looser than its place needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Whole,
}

impl Function {
    /// Its name in problem files and answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan2 => "atan2",
            Self::Exp => "exp",
            Self::Ln => "ln",
            Self::Abs => "abs",
        }
    }
}

impl Expr {
    /// The term as an author would type it, with the names of `symbols`; it reads back as the same term.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolTable};
    /// let term = Expr::Pi * (Expr::one() - Expr::Pi.sqrt()) / Expr::integer(2);
    /// assert_eq!(term.text(&SymbolTable::default()), "pi*(1 - sqrt(pi))/2");
    /// ```
    #[must_use]
    pub fn text(&self, symbols: &SymbolTable) -> String {
        self.text_with(&|symbol| symbols.entry(symbol).name.clone())
    }

    /// The same with names of the caller's.
    #[must_use]
    pub fn text_with(&self, name: &dyn Fn(Symbol) -> String) -> String {
        write(self, name).0
    }

    /// Whether the term begins with a minus as it is printed, be it behind a bracket.
    ///
    /// ```
    /// use momentous_expr::Expr;
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

/// Numerator and denominator: the factors with negative numeric powers, turned over, and a number's denominator.
pub(crate) fn split_quotient(factors: &[Expr], decimal: impl Fn(&Rational) -> bool) -> (Vec<Expr>, Vec<Expr>) {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    for factor in factors {
        match factor {
            Expr::Number(value) if !value.is_int() && !decimal(value) => {
                above.push(Expr::Number(Rational::from(value.numerator().clone())));
                below.push(Expr::Number(Rational::from(value.denominator().clone())));
            }
            Expr::Power(pair) if pair.1.as_number().is_some_and(is_negative) => {
                below.push(pair.0.clone().power(-pair.1.clone()));
            }
            other => above.push(other.clone()),
        }
    }
    if above.len() > 1 {
        above.retain(|factor| !factor.is_one());
    }
    (above, below)
}

/// A number with few decimals, exactly; `None` where it has many, or never ends.
pub(crate) fn decimal(value: &Rational) -> Option<String> {
    let decimals = decimals(value)?;
    if decimals == 0 {
        return Some(value.numerator().to_string());
    }
    let scaled = value * Rational::from(10_u64.pow(decimals));
    let sign = if is_negative(value) { "-" } else { "" };
    let decimals = decimals as usize;
    let digits = format!("{:0>width$}", scaled.numerator().clone().into_parts().1, width = decimals + 1);
    let (whole, part) = digits.split_at(digits.len() - decimals);
    Some(format!("{sign}{whole}.{part}"))
}

/// The number of decimals that a number has, where they are few: its denominator then divides a power of ten.
fn decimals(value: &Rational) -> Option<u32> {
    const MAX_DECIMALS: u32 = 6;
    let below = u64::try_from(value.denominator()).ok()?;
    (0..=MAX_DECIMALS).find(|decimals| 10_u64.pow(*decimals) % below == 0)
}

/// Whether a number reads better as a decimal than as a fraction: `0.7` and `120.5`, but `1/2`, `5/4`, `9/8` and `1/3`.
pub(crate) fn reads_as_decimal(value: &Rational) -> bool {
    const DENOMINATORS: [u8; 4] = [2, 4, 8, 16];
    const LARGEST: u8 = 100;
    let is_below = || DENOMINATORS.iter().any(|below| *value.denominator() == (*below).into());
    let is_small = || *value < Rational::from(LARGEST) && *value > -Rational::from(LARGEST);
    decimals(value).is_some_and(|decimals| decimals == 0 || !(is_below() && is_small()))
}

fn write(term: &Expr, name: &dyn Fn(Symbol) -> String) -> (String, Binding) {
    let held = |part: &Expr, least: Binding| {
        let (text, binding) = write(part, name);
        if binding < least { format!("({text})") } else { text }
    };
    let list = |parts: &[Expr]| parts.iter().map(|part| write(part, name).0).collect::<Vec<_>>().join(", ");
    if let Some(positive) = without_minus(term) {
        return (format!("-{}", held(&positive, Binding::Product)), Binding::Sum);
    }
    match term {
        Expr::Number(value) => match decimal(value).filter(|_| reads_as_decimal(value)) {
            Some(text) => (text, Binding::Whole),
            None => (format!("{}/{}", value.numerator(), value.denominator()), Binding::Product),
        },
        Expr::Pi => ("pi".to_owned(), Binding::Whole),
        Expr::Symbol(symbol) => (name(*symbol), Binding::Whole),
        Expr::Sum(terms) => {
            let mut text = String::new();
            for (index, term) in terms.iter().enumerate() {
                let minus = without_minus(term);
                text.push_str(match (&minus, index) {
                    (Some(_), 0) => "-",
                    (Some(_), _) => " - ",
                    (None, 0) => "",
                    (None, _) => " + ",
                });
                text.push_str(&held(minus.as_ref().unwrap_or(term), Binding::Product));
            }
            (text, Binding::Sum)
        }
        Expr::Product(factors) => {
            let (above, below) = split_quotient(factors, reads_as_decimal);
            let join = |factors: &[Expr]| {
                let texts: Vec<_> = factors.iter().map(|factor| held(factor, Binding::Power)).collect();
                texts.join("*")
            };
            let above = if above.is_empty() { "1".to_owned() } else { join(&above) };
            let text = match below.as_slice() {
                [] => above,
                [single] => format!("{above}/{}", held(single, Binding::Power)),
                many => format!("{above}/({})", join(many)),
            };
            (text, Binding::Product)
        }
        Expr::Power(pair) => match &pair.1 {
            Expr::Number(power) if is_negative(power) => {
                let below = pair.0.clone().power(-pair.1.clone());
                (format!("1/{}", held(&below, Binding::Power)), Binding::Product)
            }
            power if *power == Expr::ratio(1, 2) => (format!("sqrt({})", write(&pair.0, name).0), Binding::Whole),
            power => (format!("{}^{}", held(&pair.0, Binding::Whole), held(power, Binding::Whole)), Binding::Power),
        },
        Expr::Apply(function, arguments) => (format!("{}({})", function.name(), list(arguments)), Binding::Whole),
        Expr::Piecewise(piecewise) => {
            let variable = write(&piecewise.variable, name).0;
            let piece = |(until, value): &(Option<Expr>, Expr)| {
                let value = write(value, name).0;
                match until {
                    Some(until) => format!("{value} while {variable} <= {}", write(until, name).0),
                    None => value,
                }
            };
            let pieces: Vec<_> = piecewise.pieces.iter().map(piece).collect();
            (format!("{{{}}}", pieces.join("; ")), Binding::Whole)
        }
    }
}
