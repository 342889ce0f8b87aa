//! The value of printed mathematics to more than fifty digits, with units: what a reader with a calculator finds. Nothing is
//! read but the typeset lines.

use dashu::float::FBig;
use dashu::float::round::mode::HalfEven;
use momentous::expr::{Math, Operator};
use momentous::quantity::{Decimal, Rational, Unit};

/// Numbers of about 77 digits.
pub type Float = FBig<HalfEven, 2>;

const BITS: usize = 256;

/// What stands on one side of an equals sign, one or the other.
pub struct Printed {
    /// Its values in base units.
    pub values: Vec<Float>,
    /// Half a unit of the last place of each, where they are plain numbers.
    pub halves: Option<Vec<Float>>,
}

pub fn float(value: &Rational) -> Float {
    let part = |integer: dashu::integer::IBig| Float::from(integer).with_precision(BITS).value();
    part(value.numerator().clone()) / part(value.denominator().clone().into())
}

fn pi() -> Float {
    dashu::float::Context::<HalfEven>::new(BITS).pi::<2>(None).value()
}

fn precise(value: Float) -> Float {
    value.with_precision(BITS).value()
}

/// The parts of a line between its equals signs.
pub fn sides(lines: &[Math]) -> Vec<Vec<Math>> {
    let mut flat = Vec::new();
    for line in lines {
        flatten(line, &mut flat);
    }
    let sides = flat.split(|part| matches!(part, Math::Operator(Operator::Equals)));
    // What a number is about is no result: its zeros may only hold the place.
    let exact = |side: &[Math]| {
        let end = side.iter().position(|part| matches!(part, Math::Operator(Operator::Approximately)));
        side[..end.unwrap_or(side.len())].to_vec()
    };
    sides.map(exact).filter(|side| !side.is_empty()).collect()
}

/// Rows within rows as one row.
pub fn flatten(math: &Math, flat: &mut Vec<Math>) {
    match math {
        Math::Row(parts) => parts.iter().for_each(|part| flatten(part, flat)),
        other => flat.push(other.clone()),
    }
}

/// The value of a side; nothing where it holds a name.
pub fn side(parts: &[Math]) -> Option<Printed> {
    let alternatives: Vec<&[Math]> = parts.split(|part| matches!(part, Math::Text(text) if text == " or ")).collect();
    let mut values = Vec::new();
    for alternative in &alternatives {
        // Letters alone are a name, even those of a unit: GM.
        if !alternative.iter().any(|part| part.plain().contains(|letter: char| letter.is_ascii_digit())) {
            return None;
        }
        values.extend(both(alternative)?);
    }
    let halves = alternatives.iter().map(|text| half_unit(text).filter(|_| is_number(text))).collect();
    Some(Printed { values, halves })
}

/// The two values of a term with one plus-or-minus; the one of any other.
fn both(parts: &[Math]) -> Option<Vec<Float>> {
    let signs = [Operator::Plus, Operator::Minus].map(|sign| parts.iter().map(|part| replaced(part, sign)).collect());
    let [plus, minus]: [Vec<Math>; 2] = signs;
    if plus == minus {
        Some(vec![Reader::read(parts)?])
    } else {
        Some(vec![Reader::read(&plus)?, Reader::read(&minus)?])
    }
}

fn replaced(math: &Math, sign: Operator) -> Math {
    use std::sync::Arc;
    let inner = |part: &Arc<Math>| Arc::new(replaced(part, sign));
    match math {
        Math::Operator(Operator::PlusMinus) => Math::Operator(sign),
        Math::Row(parts) => Math::Row(parts.iter().map(|part| replaced(part, sign)).collect()),
        Math::Fraction(above, below) => Math::Fraction(inner(above), inner(below)),
        Math::Bracketed(part) => Math::Bracketed(inner(part)),
        other => other.clone(),
    }
}

/// Whether a side is nothing but a number with its unit, so that it has a last place.
fn is_number(parts: &[Math]) -> bool {
    let mut bare = parts.iter().filter(|part| !matches!(part, Math::Operator(Operator::Minus)));
    let first = bare.next().is_some_and(|part| matches!(part, Math::Number(_)));
    first && bare.all(|part| matches!(part, Math::Text(_) | Math::Operator(Operator::Times)) || is_power_of_ten(part))
}

fn is_power_of_ten(math: &Math) -> bool {
    matches!(math, Math::Sup(base, _) if matches!(&**base, Math::Number(ten) if ten == "10"))
}

fn half_unit(parts: &[Math]) -> Option<Float> {
    let digits = parts.iter().find_map(|part| match part {
        Math::Number(text) => Decimal::parse(text).ok(),
        _ => None,
    })?;
    let place = Decimal::parse(&format!("0.5e{}", -digits.scale())).ok()?;
    let [mut half, ten] = [float(&place.to_rational()), Float::from(10)];
    for part in parts {
        half = match part {
            Math::Sup(_, exponent) => half * ten.clone().with_precision(BITS).value().powi(integer(exponent)?.into()),
            Math::Text(text) => half * unit(text)?,
            _ => half,
        };
    }
    Some(precise(half))
}

fn integer(math: &Math) -> Option<i32> {
    math.plain().replace('\u{2212}', "-").parse().ok()
}

fn unit(text: &str) -> Option<Float> {
    let factor = Unit::parse(text.trim_matches(['\u{a0}', ' '])).ok()?.factor();
    let size = float(&factor.rational);
    Some(precise(match factor.pi {
        0 => size,
        power if power > 0 => size * pi().powi(i32::from(power).into()),
        power => size / pi().powi((-i32::from(power)).into()),
    }))
}

/// Reads a row from left to right.
struct Reader<'a> {
    rest: &'a [Math],
}

impl Reader<'_> {
    fn read(parts: &[Math]) -> Option<Float> {
        let mut flat = Vec::new();
        for part in parts {
            flatten(part, &mut flat);
        }
        let mut reader = Reader { rest: &flat };
        let value = reader.sum()?;
        reader.rest.is_empty().then_some(value)
    }

    fn operator(&mut self) -> Option<Operator> {
        match self.rest.first() {
            Some(Math::Operator(operator)) => Some(*operator),
            _ => None,
        }
    }

    fn next(&mut self) -> Option<Math> {
        let (first, rest) = self.rest.split_first()?;
        self.rest = rest;
        Some(first.clone())
    }

    fn sum(&mut self) -> Option<Float> {
        let mut sum = Float::ZERO;
        let mut is_first = true;
        while is_first || matches!(self.operator(), Some(Operator::Plus | Operator::Minus)) {
            let minus = self.operator() == Some(Operator::Minus);
            if matches!(self.operator(), Some(Operator::Plus | Operator::Minus)) {
                self.next();
            }
            let term = self.product()?;
            sum = if minus { sum - term } else { sum + term };
            is_first = false;
        }
        Some(precise(sum))
    }

    fn product(&mut self) -> Option<Float> {
        let mut product = self.factor()?;
        loop {
            match self.rest.first() {
                None | Some(Math::Operator(Operator::Plus | Operator::Minus)) => return Some(product),
                Some(Math::Operator(Operator::Juxtapose | Operator::Times)) => {
                    self.next();
                }
                Some(Math::Operator(_)) => return None,
                Some(_) => {}
            }
            product = precise(product * self.factor()?);
        }
    }

    fn factor(&mut self) -> Option<Float> {
        match self.next()? {
            Math::Number(text) => Some(float(&Decimal::parse(&text).ok()?.to_rational())),
            Math::Text(text) => unit(&text),
            Math::Identifier(text) if text == "\u{3c0}" => Some(pi()),
            Math::Operator(Operator::Minus) => Some(-self.factor()?),
            Math::Bracketed(inner) | Math::Squared(inner) => Self::read(&[(*inner).clone()]),
            Math::Bars(inner) => {
                let value = Self::read(&[(*inner).clone()])?;
                Some(if value < Float::ZERO { -value } else { value })
            }
            Math::Fraction(above, below) => {
                let [above, below] = [above, below].map(|part| Self::read(&[(*part).clone()]));
                let below = below.filter(|below| *below != Float::ZERO)?;
                Some(precise(above? / below))
            }
            Math::Root(inner) => {
                let inner = Self::read(&[(*inner).clone()]).filter(|inner| *inner >= Float::ZERO)?;
                Some(precise(inner.sqrt()))
            }
            Math::Sup(base, exponent) => match &*base {
                Math::Function(name) => Some(self.function(name)?.powi(integer(&exponent)?.into())),
                _ => {
                    let [base, exponent] = [base, exponent].map(|part| Self::read(&[(*part).clone()]));
                    let (base, exponent) = (base?, exponent?);
                    if exponent == exponent.clone().trunc() {
                        let power = i32::try_from(exponent.to_int().value()).ok()?;
                        return Some(precise(base.powi(power.into())));
                    }
                    Some(precise(base.powf(&exponent)))
                }
            },
            Math::Function(name) => self.function(&name),
            _ => None,
        }
    }

    /// A function's value; its argument is what stands next, with its unit where it has no brackets.
    fn function(&mut self, name: &str) -> Option<Float> {
        if self.operator() == Some(Operator::Juxtapose) {
            self.next();
        }
        let mut argument = self.factor()?;
        if let Some(Math::Text(text)) = self.rest.first() {
            argument *= unit(text)?;
            self.next();
        }
        let argument = precise(argument);
        let value = match name {
            "sin" => argument.sin(),
            "cos" => argument.cos(),
            "tan" => argument.clone().sin() / argument.cos(),
            "arcsin" => argument.asin(),
            "arccos" => argument.acos(),
            "arctan" => argument.atan(),
            "exp" => argument.exp(),
            "ln" => argument.ln(),
            _ => return None,
        };
        Some(precise(value))
    }
}
