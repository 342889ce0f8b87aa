//! Terms laid out as a textbook prints them: fraction bars, minus signs in place, brackets exactly where needed.

use std::sync::Arc;

use crate::quantity::Rational;

use super::sign::without_minus;
use super::text::{decimal, reads_as_decimal, split_quotient};
use super::{Expr, Function, Math, Operator, Piecewise, Symbol};

/// What stands for a symbol: its name, or the number that it has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The typeset name, or the number with its unit.
    pub math: Math,
    /// Which of the two it is.
    pub kind: LeafKind,
}

/// Names stand free; numbers in a product stand in brackets: `m v`, `(2 kg)(3 m/s)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeafKind {
    /// A name.
    Name,
    /// A number put in for a name.
    Number {
        /// Whether it is below zero; then it stands in brackets after any operator.
        negative: bool,
    },
}

/// How a laid-out part must be treated by what surrounds it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    /// A sum, or anything with a sign in front.
    Sum,
    Product,
    /// A constant as written.
    Constant,
    /// A number put in for a symbol.
    Number {
        negative: bool,
    },
    /// A function whose argument has no brackets; what follows would seem to belong to it.
    Open,
    /// Holds together by itself.
    Whole,
}

struct Layout<'a> {
    leaf: &'a dyn Fn(Symbol) -> Leaf,
}

impl Expr {
    /// The term as typeset mathematics, with `leaf` saying what stands for each symbol.
    ///
    /// ```
    /// use momentous::expr::{Expr, Math, SymbolTable};
    /// let half_turn = Expr::Pi / Expr::integer(2) - Expr::one();
    /// let no_symbols = |_| unreachable!("there are none");
    /// assert_eq!(half_turn.layout(&no_symbols).latex(), r"\frac{\pi}{2} - 1");
    /// ```
    pub fn layout(&self, leaf: &dyn Fn(Symbol) -> Leaf) -> Math {
        Layout { leaf }.term(self).0
    }
}

/// In square brackets what has round ones inside.
fn bracketed(math: Math) -> Math {
    if has_brackets(&math) { Math::Squared(Arc::new(math)) } else { Math::Bracketed(Arc::new(math)) }
}

fn has_brackets(math: &Math) -> bool {
    match math {
        Math::Bracketed(_) | Math::Squared(_) => true,
        Math::Row(parts) => parts.iter().any(has_brackets),
        Math::Sub(base, _) | Math::Sup(base, _) | Math::SubSup(base, _, _) => has_brackets(base),
        _ => false,
    }
}

fn starts_with_bracket(math: &Math) -> bool {
    match math {
        Math::Bracketed(_) | Math::Squared(_) => true,
        Math::Sub(base, _) | Math::Sup(base, _) | Math::SubSup(base, _, _) => starts_with_bracket(base),
        Math::Row(parts) => parts.first().is_some_and(starts_with_bracket),
        _ => false,
    }
}

fn ends_with_bracket(math: &Math) -> bool {
    match math {
        Math::Bracketed(_) | Math::Squared(_) | Math::Number(_) => true,
        Math::Sup(base, _) => ends_with_bracket(base),
        Math::Row(parts) => parts.last().is_some_and(ends_with_bracket),
        _ => false,
    }
}

fn starts_with_digit(math: &Math) -> bool {
    match math {
        Math::Number(_) => true,
        Math::Sup(base, _) => starts_with_digit(base),
        Math::Row(parts) => parts.first().is_some_and(starts_with_digit),
        _ => false,
    }
}

fn constant(value: &Rational) -> (Math, Shape) {
    if reads_as_decimal(value)
        && let Some(text) = decimal(value)
    {
        return (Math::Number(text), Shape::Constant);
    }
    let part = |text: String| Arc::new(Math::Number(text));
    let fraction = Math::Fraction(part(value.numerator().to_string()), part(value.denominator().to_string()));
    (fraction, Shape::Whole)
}

/// A term after a plus or minus.
fn after_sign(math: Math, shape: Shape) -> Math {
    match shape {
        Shape::Sum | Shape::Number { negative: true } => bracketed(math),
        _ => math,
    }
}

impl Layout<'_> {
    fn term(&self, term: &Expr) -> (Math, Shape) {
        if let Some(positive) = without_minus(term) {
            let (math, shape) = self.term(&positive);
            return (Math::Row(vec![Math::Operator(Operator::Minus), after_sign(math, shape)]), Shape::Sum);
        }
        match term {
            Expr::Number(value) => constant(value),
            Expr::Pi => (Math::Identifier("\u{3c0}".to_owned()), Shape::Whole),
            Expr::Symbol(symbol) => {
                let Leaf { math, kind } = (self.leaf)(*symbol);
                match kind {
                    LeafKind::Name => (math, Shape::Whole),
                    LeafKind::Number { negative } => (math, Shape::Number { negative }),
                }
            }
            Expr::Sum(terms) => (self.sum(terms), Shape::Sum),
            Expr::Product(factors) => self.product(factors),
            Expr::Power(pair) => self.power(&pair.0, &pair.1),
            Expr::Apply(Function::Abs, arguments) => (Math::Bars(Arc::new(self.arguments(arguments))), Shape::Whole),
            Expr::Apply(Function::Atan2, arguments) => self.direction(arguments),
            Expr::Apply(function, arguments) => {
                self.apply(Math::Function(printed_name(*function).to_owned()), *function, arguments)
            }
            Expr::Piecewise(piecewise) => (self.piecewise(piecewise), Shape::Whole),
        }
    }

    fn sum(&self, terms: &[Expr]) -> Math {
        let mut row = Vec::new();
        for (index, term) in terms.iter().enumerate() {
            let minus = without_minus(term);
            let (math, shape) = self.term(minus.as_ref().unwrap_or(term));
            match (&minus, index) {
                (Some(_), _) => row.push(Math::Operator(Operator::Minus)),
                (None, 0) => {}
                (None, _) => row.push(Math::Operator(Operator::Plus)),
            }
            let first = index == 0 && minus.is_none();
            row.push(if first && shape != Shape::Sum { math } else { after_sign(math, shape) });
        }
        Math::Row(row)
    }

    fn product(&self, factors: &[Expr]) -> (Math, Shape) {
        let (above, below) = split_quotient(factors, reads_as_decimal);
        let only_number = below.iter().all(|factor| factor.as_number().is_some());
        if let (true, Some(number), [_, rest @ ..]) = (only_number, factors.first().and_then(Expr::as_number), factors)
            && !below.is_empty()
            && rest.len() > 1
        // 1/2 m v^2, but v^2/2
        {
            let (coefficient, _) = constant(number);
            let row = self.row(rest).0;
            return (Math::Row(vec![coefficient, Math::Operator(Operator::Juxtapose), row]), Shape::Product);
        }
        if below.is_empty() {
            return self.row(&above);
        }
        let above = if above.is_empty() { Math::Number("1".to_owned()) } else { self.row(&above).0 };
        (Math::Fraction(Arc::new(above), Arc::new(self.row(&below).0)), Shape::Whole)
    }

    /// Factors side by side, open where the last one is; a single one as it is.
    fn row(&self, factors: &[Expr]) -> (Math, Shape) {
        let mut parts: Vec<(Math, Shape)> = factors.iter().map(|factor| self.term(factor)).collect();
        let open = parts.last().is_some_and(|(_, shape)| *shape == Shape::Open);
        let whole = if open { Shape::Open } else { Shape::Product };
        if parts.len() == 1
            && let Some((single, _)) = parts.pop()
        {
            return (single, whole);
        }
        let mut row: Vec<Math> = Vec::new();
        let mut parts = parts.into_iter().peekable();
        while let Some((math, shape)) = parts.next() {
            let math = match shape {
                Shape::Sum | Shape::Number { .. } => bracketed(math),
                Shape::Open if parts.peek().is_some_and(|(_, next)| *next != Shape::Open) => bracketed(math),
                _ => math,
            };
            if let Some(last) = row.last() {
                if starts_with_digit(&math) {
                    row.push(Math::Operator(Operator::Times));
                } else if !(ends_with_bracket(last) && starts_with_bracket(&math)) {
                    row.push(Math::Operator(Operator::Juxtapose));
                }
            }
            row.push(math);
        }
        (Math::Row(row), whole)
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> (Math, Shape) {
        if let Some(power) = exponent.as_number() {
            if *power < Rational::ZERO {
                let below = self.term(&base.clone().power(-exponent.clone())).0;
                return (Math::Fraction(Arc::new(Math::Number("1".to_owned())), Arc::new(below)), Shape::Whole);
            }
            if *exponent == Expr::ratio(1, 2) {
                return (Math::Root(Arc::new(self.term(base).0)), Shape::Whole);
            }
            if let Expr::Apply(function, arguments) = base
                && power.is_int()
                && matches!(function, Function::Sin | Function::Cos | Function::Tan)
            {
                let name = Arc::new(Math::Function(printed_name(*function).to_owned()));
                let name = Math::Sup(name, Arc::new(self.term(exponent).0));
                return self.apply(name, *function, arguments);
            }
        }
        let (math, shape) = self.term(base);
        let fraction = matches!(math, Math::Fraction(..) | Math::Sup(..) | Math::SubSup(..));
        let holds = matches!(shape, Shape::Whole | Shape::Constant) && !fraction;
        let exponent = Arc::new(self.term(exponent).0);
        let raised = match if holds { math } else { bracketed(math) } {
            Math::Sub(name, subscript) => Math::SubSup(name, subscript, exponent),
            other => Math::Sup(Arc::new(other), exponent),
        };
        (raised, Shape::Whole)
    }

    /// A function's name with its argument; a short argument of a sine or cosine needs no brackets.
    fn apply(&self, name: Math, function: Function, arguments: &[Expr]) -> (Math, Shape) {
        let may_be_bare = matches!(function, Function::Sin | Function::Cos | Function::Tan | Function::Ln);
        if let ([single], true) = (arguments, may_be_bare) {
            let (math, shape) = self.term(single);
            let bare = matches!(shape, Shape::Whole | Shape::Constant | Shape::Number { negative: false });
            if bare && !matches!(math, Math::Fraction(..)) {
                return (Math::Row(vec![name, Math::Operator(Operator::Juxtapose), math]), Shape::Open);
            }
        }
        (Math::Row(vec![name, bracketed(self.arguments(arguments))]), Shape::Whole)
    }

    /// The angle of the point (x, y), as the arctangent of the ratio; what is printed beside it tells the quadrant.
    fn direction(&self, arguments: &[Expr]) -> (Math, Shape) {
        let name = Math::Function("arctan".to_owned());
        match arguments {
            [y, x] if !x.is_one() => {
                let ratio = Math::Fraction(Arc::new(self.term(y).0), Arc::new(self.term(x).0));
                (Math::Row(vec![name, Math::Bracketed(Arc::new(ratio))]), Shape::Whole)
            }
            _ => self.apply(name, Function::Atan2, arguments.get(..1).unwrap_or_default()),
        }
    }

    fn arguments(&self, arguments: &[Expr]) -> Math {
        match arguments {
            [single] => self.term(single).0,
            many => {
                let separated = many.iter().flat_map(|part| [Math::Operator(Operator::Comma), self.term(part).0]);
                Math::Row(separated.skip(1).collect())
            }
        }
    }

    fn piecewise(&self, piecewise: &Piecewise) -> Math {
        let variable = self.term(&piecewise.variable).0;
        let rows = piecewise.pieces.iter().map(|(until, value)| {
            let condition = match until {
                Some(until) => Math::relation(variable.clone(), Operator::AtMost, self.term(until).0),
                None => Math::Text("afterwards".to_owned()),
            };
            (condition, self.term(value).0)
        });
        Math::Cases(rows.collect())
    }
}

fn printed_name(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        other => other.name(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::name_math;
    use super::super::testing::AnyName;
    use super::*;

    #[test]
    fn symbols_stand_as_in_a_textbook() {
        for (text, plain, latex) in [
            ("m_A*v_A1 - m_B*v_B1", "m_A v_A1 \u{2212} m_B v_B1", r"m_{A}\,v_{A1} - m_{B}\,v_{B1}"),
            ("m*v^2/2", "1/2 m v^2", r"\frac{1}{2}\,m\,v^{2}"),
            ("v_A1^2", "v_A1^2", r"v_{A1}^{2}"),
            ("-(a + b)*c", "\u{2212}(a + b) c", r"-(a + b)\,c"),
            ("a - (b - c)", "a \u{2212} (b \u{2212} c)", "a - (b - c)"),
            ("-a/(b + c)", "\u{2212}a/(b + c)", r"-\frac{a}{b + c}"),
            ("a*(b*(c - 1) + 2)", "a [b (c \u{2212} 1) + 2]", r"a\,[b\,(c - 1) + 2]"),
            ("sqrt(2*g*h)", "sqrt(2 g h)", r"\sqrt{2\,g\,h}"),
            ("v*cos(theta)", "v cos \u{3b8}", r"v\,\cos \theta"),
            ("cos(theta)*v", "(cos \u{3b8}) v", ""),
            ("sin(a)^2 + sin(2*a)", "sin^2 a + sin(2 a)", r"\sin^{2} a + \sin(2\,a)"),
            ("0.7*v + 1.25", "0.7 v + 5/4", r"0.7\,v + \frac{5}{4}"),
            ("e^n*x", "e^n x", r"e^{n}\,x"),
            ("(a/b)^2", "(a/b)^2", r"\left(\frac{a}{b}\right)^{2}"),
            ("a/b/c", "a/(b c)", r"\frac{a}{b\,c}"),
            ("x/3", "x/3", r"\frac{x}{3}"),
            ("-0.5*x", "\u{2212}x/2", r"-\frac{x}{2}"),
            ("abs(a - b)", "|a \u{2212} b|", r"\lvert a - b\rvert"),
            ("2*(-3)^n", "", r"2(-3)^{n}"),
            ("atan2(y, x)", "arctan(y/x)", r"\arctan\left(\frac{y}{x}\right)"),
            ("a + atan2(y - 1, -x)", "a + arctan((y \u{2212} 1)/(\u{2212}x))", ""),
            ("atan(y/x)", "arctan(y/x)", r"\arctan\left(\frac{y}{x}\right)"),
            ("2*atan(k)", "2 arctan(k)", r"2\,\arctan(k)"),
            ("9/8*x + 5/4*y - 1.2*z", "9 x/8 + 5 y/4 \u{2212} 1.2 z", ""),
            ("9/8", "9/8", r"\frac{9}{8}"),
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            let leaf = |symbol| Leaf { math: name_math(&names.0.entry(symbol).name), kind: LeafKind::Name };
            let math = term.layout(&leaf);
            if !plain.is_empty() {
                assert_eq!(math.plain(), plain, "{text}");
            }
            if !latex.is_empty() {
                assert_eq!(math.latex(), latex, "{text}");
            }
        }
    }

    #[test]
    fn numbers_put_in_stand_in_brackets_where_they_must() {
        for (text, expected) in [
            ("m*v + n*w", "(3 kg)(3 m/s) + (2 kg)(\u{2212}2 m/s)"),
            ("v + w", "3 m/s + (\u{2212}2 m/s)"),
            ("w - v", "\u{2212}2 m/s \u{2212} 3 m/s"),
            ("-w", "\u{2212}(\u{2212}2 m/s)"),
            ("m*w^2/2", "1/2 (3 kg)(\u{2212}2 m/s)^2"),
            ("v^2", "(3 m/s)^2"),
            ("m*v/(m + n)", "(3 kg)(3 m/s)/(3 kg + 2 kg)"),
            ("2*v", "2(3 m/s)"),
            ("n*(v - w)", "(2 kg)[3 m/s \u{2212} (\u{2212}2 m/s)]"),
            ("v*cos(b)", "(3 m/s) cos 30\u{b0}"),
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            let leaf = |symbol| {
                let (number, unit, negative) = match names.0.entry(symbol).name.as_str() {
                    "m" => ("3", "kg", false),
                    "n" => ("2", "kg", false),
                    "v" => ("3", "m/s", false),
                    "b" => ("30", "\u{b0}", false),
                    _ => ("-2", "m/s", true),
                };
                let math = Math::Row(vec![Math::Number(number.into()), Math::Text(unit.into())]);
                Leaf { math, kind: LeafKind::Number { negative } }
            };
            assert_eq!(term.layout(&leaf).plain(), expected, "{text}");
        }
    }
}
