//! Terms laid out as a textbook prints them: fraction bars, minus signs in place.

use std::sync::Arc;

use momentous_quantity::Rational;

use super::super::grammar::text::{decimal, reads_as_decimal, split_quotient};
use super::super::sign::without_minus;
use super::super::{Expr, Function, Math, Piecewise, Symbol};
use super::arrangement::{Arrangement, Leaf, Node, Shape};

impl Expr {
    /// The term as typeset mathematics, with `leaf` saying what stands for each symbol.
    ///
    /// ```
    /// use momentous_expr::{Expr, Math, SymbolTable};
    /// let half_turn = Expr::Pi / Expr::integer(2) - Expr::one();
    /// let no_symbols = |_| unreachable!("there are none");
    /// assert_eq!(half_turn.layout(&no_symbols).latex(), r"\frac{\pi}{2} - 1");
    /// ```
    pub fn layout(&self, leaf: &dyn Fn(Symbol) -> Leaf) -> Math {
        self.arranged().with(leaf)
    }

    /// The same before it is known what stands for the symbols, for a term that is laid out with many numbers.
    #[must_use]
    pub fn arranged(&self) -> Arrangement {
        Arrangement(node(self))
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

fn fixed((math, shape): (Math, Shape)) -> Node {
    Node::Fixed(math, shape)
}

fn one() -> Node {
    fixed((Math::Number("1".to_owned()), Shape::Constant))
}

fn nodes(terms: &[Expr]) -> Vec<Node> {
    terms.iter().map(node).collect()
}

fn node(term: &Expr) -> Node {
    if let Some(positive) = without_minus(term) {
        return Node::Minus(Box::new(node(&positive)));
    }
    match term {
        Expr::Number(value) => fixed(constant(value)),
        Expr::Pi => fixed((Math::Identifier("\u{3c0}".to_owned()), Shape::Whole)),
        Expr::Symbol(symbol) => Node::Symbol(*symbol),
        Expr::Sum(terms) => {
            let signed = |term: &Expr| match without_minus(term) {
                Some(positive) => (true, node(&positive)),
                None => (false, node(term)),
            };
            Node::Sum(terms.iter().map(signed).collect())
        }
        Expr::Product(factors) => product(factors),
        Expr::Power(pair) => power(&pair.0, &pair.1),
        Expr::Apply(Function::Abs, arguments) => Node::Bars(nodes(arguments)),
        Expr::Apply(Function::Atan2, arguments) => direction(arguments),
        Expr::Apply(function, arguments) => {
            apply(Math::Function(printed_name(*function).to_owned()), *function, arguments)
        }
        Expr::Piecewise(piecewise) => cases(piecewise),
    }
}

fn product(factors: &[Expr]) -> Node {
    let (above, below) = split_quotient(factors, reads_as_decimal);
    let only_number = below.iter().all(|factor| factor.as_number().is_some());
    if let (true, Some(number), [_, rest @ ..]) = (only_number, factors.first().and_then(Expr::as_number), factors)
        && !below.is_empty()
        && rest.len() > 1
    // 1/2 m v^2, but v^2/2
    {
        return Node::Coefficient(constant(number).0, nodes(rest));
    }
    if below.is_empty() {
        return Node::Row(nodes(&above));
    }
    let above = if above.is_empty() { one() } else { Node::Row(nodes(&above)) };
    Node::Fraction(Box::new([above, Node::Row(nodes(&below))]))
}

fn power(base: &Expr, exponent: &Expr) -> Node {
    if let Some(power) = exponent.as_number() {
        if *power < Rational::ZERO {
            let below = node(&base.clone().power(-exponent.clone()));
            return Node::Fraction(Box::new([one(), below]));
        }
        if *exponent == Expr::ratio(1, 2) {
            return Node::Root(Box::new(node(base)));
        }
        if let Expr::Apply(function, arguments) = base
            && power.is_int()
            && matches!(function, Function::Sin | Function::Cos | Function::Tan)
        {
            let name = Arc::new(Math::Function(printed_name(*function).to_owned()));
            let name = Math::Sup(name, Arc::new(constant(power).0));
            return apply(name, *function, arguments);
        }
    }
    Node::Power(Box::new([node(base), node(exponent)]))
}

fn apply(name: Math, function: Function, arguments: &[Expr]) -> Node {
    let may_be_bare = matches!(function, Function::Sin | Function::Cos | Function::Tan | Function::Ln);
    Node::Apply { name, may_be_bare, arguments: nodes(arguments) }
}

/// The angle of the point (x, y), as the arctangent of the ratio; what is printed beside it tells the quadrant.
fn direction(arguments: &[Expr]) -> Node {
    let name = Math::Function("arctan".to_owned());
    match arguments {
        [y, x] if !x.is_one() => Node::Direction(name, Box::new([(node(y), y.clone()), (node(x), x.clone())])),
        [y, ..] => apply(name, Function::Atan2, std::slice::from_ref(y)),
        [] => apply(name, Function::Atan2, &[]),
    }
}

fn cases(piecewise: &Piecewise) -> Node {
    let piece = |(until, value): &(Option<Expr>, Expr)| (until.as_ref().map(node), node(value));
    Node::Cases(Box::new(node(&piecewise.variable)), piecewise.pieces.iter().map(piece).collect())
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
    use super::super::super::LeafKind;
    use super::super::super::name_math;
    use super::super::super::testing::AnyName;
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
