//! Terms of a solution as a checker reads them: an evaluator of its own, which shares nothing with the program.

use std::collections::BTreeMap;

/// Values by the names of quantities.
pub type Values = BTreeMap<String, f64>;

/// A term.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    Number(f64),
    Name(String),
    Sum(Box<Term>, Box<Term>),
    Product(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, Box<Term>),
    Minus(Box<Term>),
    Call(String, Vec<Term>),
    /// Values, each but the last with the bound up to which it holds: variable, bound.
    Pieces(Vec<(Option<(Term, Term)>, Term)>),
}

/// A value, and the size of what it was summed up from: rounding is a share of that.
#[derive(Clone, Copy, Debug)]
pub struct Sized {
    pub value: f64,
    pub size: f64,
}

impl Sized {
    pub fn of(value: f64) -> Self {
        Self { value, size: value.abs() }
    }

    /// Whether two values differ by no more than rounding.
    pub fn agrees(self, other: Self) -> bool {
        (self.value - other.value).abs() <= 1e-7 * (self.size + other.size) + 1e-300
    }

    pub fn minus(self, other: Self) -> Self {
        Self { value: self.value - other.value, size: self.size + other.size }
    }

    pub fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }

    pub fn times(self, other: Self) -> Self {
        Self { value: self.value * other.value, size: self.size * other.size }
    }

    /// A function's value: an error of its argument is carried on with the slope there.
    fn through(self, function: impl Fn(f64) -> f64) -> Self {
        let value = function(self.value);
        let step = 1e-6 * self.value.abs().max(1e-3);
        let slope = (function(self.value + step) - value).abs() / step;
        let carried = if slope.is_finite() { slope * self.size } else { self.size };
        Self { value, size: value.abs() + carried }
    }
}

impl Term {
    /// The value; NaN where a name has none, or a root is of what is negative.
    pub fn value(&self, values: &Values) -> Sized {
        match self {
            Self::Number(number) => Sized::of(*number),
            Self::Name(name) => Sized::of(values.get(name).copied().unwrap_or(f64::NAN)),
            Self::Sum(left, right) => left.value(values).plus(right.value(values)),
            Self::Minus(term) => {
                let Sized { value, size } = term.value(values);
                Sized { value: -value, size }
            }
            Self::Product(left, right) => left.value(values).times(right.value(values)),
            Self::Quotient(above, below) => above.value(values).times(below.value(values).through(f64::recip)),
            Self::Power(base, exponent) => {
                let exponent = exponent.value(values).value;
                base.value(values).through(|base| base.powf(exponent))
            }
            Self::Call(name, parts) => call(name, parts, values),
            Self::Pieces(pieces) => {
                let holds = |bound: &Option<(Term, Term)>| match bound {
                    Some((variable, until)) => variable.value(values).value <= until.value(values).value,
                    None => true,
                };
                pieces
                    .iter()
                    .find(|(bound, _)| holds(bound))
                    .map_or(Sized::of(f64::NAN), |(_, value)| value.value(values))
            }
        }
    }

    /// Whether a name stands in the term.
    pub fn mentions(&self, name: &str) -> bool {
        matches!(self, Self::Name(name_here) if name_here == name)
            || self.parts().into_iter().any(|part| part.mentions(name))
    }

    /// Every name, as often as it stands there.
    pub fn names(&self) -> Vec<String> {
        let names = if let Self::Name(name) = self { vec![name.clone()] } else { Vec::new() };
        names.into_iter().chain(self.parts().into_iter().flat_map(Self::names)).collect()
    }

    /// What stands below a bar, factor by factor.
    pub fn divisors(&self) -> Vec<Term> {
        let factors = if let Self::Quotient(_, below) = self { below.factors() } else { Vec::new() };
        factors.into_iter().chain(self.parts().into_iter().flat_map(Self::divisors)).collect()
    }

    fn factors(&self) -> Vec<Term> {
        match self {
            Self::Product(left, right) | Self::Quotient(left, right) => [left.factors(), right.factors()].concat(),
            Self::Power(base, _) => base.factors(),
            Self::Call(name, parts) if name == "sqrt" => parts.iter().flat_map(Self::factors).collect(),
            Self::Minus(term) => term.factors(),
            other if other.names().is_empty() => Vec::new(),
            other => vec![other.clone()],
        }
    }

    fn parts(&self) -> Vec<&Term> {
        match self {
            Self::Number(_) | Self::Name(_) => Vec::new(),
            Self::Sum(left, right)
            | Self::Product(left, right)
            | Self::Quotient(left, right)
            | Self::Power(left, right) => vec![left, right],
            Self::Minus(term) => vec![term],
            Self::Call(_, parts) => parts.iter().collect(),
            Self::Pieces(pieces) => pieces
                .iter()
                .flat_map(|(bound, value)| bound.iter().flat_map(|(variable, until)| [variable, until]).chain([value]))
                .collect(),
        }
    }
}

fn call(name: &str, parts: &[Term], values: &Values) -> Sized {
    if let ("integral", [integrand, Term::Name(variable), low, high]) = (name, parts) {
        return integral(integrand, variable, [low.value(values).value, high.value(values).value], values);
    }
    let numbers: Vec<Sized> = parts.iter().map(|part| part.value(values)).collect();
    match (name, numbers.as_slice()) {
        ("sqrt", [x]) => x.through(f64::sqrt),
        ("sin", [x]) => x.through(f64::sin),
        ("cos", [x]) => x.through(f64::cos),
        ("tan", [x]) => x.through(f64::tan),
        ("asin", [x]) => x.through(f64::asin),
        ("acos", [x]) => x.through(f64::acos),
        ("exp", [x]) => x.through(f64::exp),
        ("ln", [x]) => x.through(f64::ln),
        ("abs", [x]) => x.through(f64::abs),
        ("atan2", [y, x]) => Sized::of(y.value.atan2(x.value)),
        ("atan", [x]) => x.through(f64::atan),
        _ => Sized::of(f64::NAN),
    }
}

/// By Simpson's rule, fine enough for kinks between the points; the points crowd at both ends, where a root may be steep.
fn integral(integrand: &Term, variable: &str, [low, high]: [f64; 2], values: &Values) -> Sized {
    const PARTS: u32 = 4000;
    let mut inside = values.clone();
    let step = f64::from(PARTS).recip();
    let mut sum = Sized::of(0.0);
    for index in 0..=PARTS {
        let share = step * f64::from(index);
        let [place, slope] = [share * share * (3.0 - 2.0 * share), 6.0 * share * (1.0 - share)];
        inside.insert(variable.to_owned(), low + (high - low) * place);
        let weight = if index == 0 || index == PARTS { 1.0 } else { f64::from(2 + 2 * (index % 2)) };
        sum = sum.plus(integrand.value(&inside).times(Sized::of((high - low) * slope * weight * step / 3.0)));
    }
    sum
}

#[test]
fn terms_have_their_values() {
    let read = |text: &str| super::typed::read(text).unwrap_or_else(|fault| panic!("{text}: {fault}"));
    let values = Values::from([("a".into(), 3.0), ("b_1.x".into(), 4.0), ("60 deg".into(), 1.0)]);
    for (text, value) in [
        ("a + b_1.x*2", 11.0),
        ("-a^2/b_1.x - 1", -3.25),
        ("sqrt(a^2 + b_1.x^2)/(2*a)", 5.0 / 6.0),
        ("2*(60 deg)*atan2(0, -a)", 2.0 * std::f64::consts::PI),
        ("integral(2*a*t, t, 0, b_1.x)", 48.0),
        ("integral(sqrt(t), t, 0, b_1.x)", 16.0 / 3.0),
        ("{a while a <= 2; b_1.x}", 4.0),
        ("a - (b_1.x - a)", 2.0),
        ("1.5*a/(b_1.x*a)", 0.375),
    ] {
        assert!((read(text).value(&values).value - value).abs() < 1e-9, "{text}: {:?}", read(text).value(&values));
    }
}
