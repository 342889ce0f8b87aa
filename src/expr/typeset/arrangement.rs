//! A term as a textbook arranges it, before it is said what stands for its symbols: brackets exactly where that needs them.

use std::sync::Arc;

use super::super::{Expr, Math, Operator, Symbol};

/// The text in place of a symbol: its name, or the number that it has.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
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

/// A term laid out once, in which names or the numbers of many variants may be put.
#[derive(Clone, Debug)]
pub struct Arrangement(pub(super) Node);

/// A part of an arrangement.
#[derive(Clone, Debug)]
pub(super) enum Node {
    /// A part without symbols.
    Fixed(Math, Shape),
    Symbol(Symbol),
    /// A minus in front.
    Minus(Box<Node>),
    /// Terms, each with whether a minus stands before it.
    Sum(Vec<(bool, Node)>),
    /// Factors side by side.
    Row(Vec<Node>),
    /// Factors side by side behind a numerical fraction: `1/2 m v^2`.
    Coefficient(Math, Vec<Node>),
    Fraction(Box<[Node; 2]>),
    Root(Box<Node>),
    Power(Box<[Node; 2]>),
    /// A function's name and its arguments; a short argument of a sine or cosine needs no brackets.
    Apply {
        name: Math,
        may_be_bare: bool,
        arguments: Vec<Node>,
    },
    /// The angle of the point (x, y), as the arctangent of the ratio y/x; and the two terms themselves.
    Direction(Math, Box<[(Node, Expr); 2]>),
    Bars(Vec<Node>),
    /// A variable, and what holds up to each value of it.
    Cases(Box<Node>, Vec<(Option<Node>, Node)>),
}

impl Arrangement {
    /// Typeset mathematics, with `leaf` saying what stands for each symbol.
    #[must_use]
    pub fn with(&self, leaf: &dyn Fn(Symbol) -> Leaf) -> Math {
        self.0.put(&Put { leaf, value: None }).0
    }

    /// The same with numbers, where `value` gives that of each symbol: an angle in the second or third quadrant is then the
    /// arctangent and half a turn, as a calculator needs it.
    #[must_use]
    pub fn with_numbers(&self, leaf: &dyn Fn(Symbol) -> Leaf, value: &dyn Fn(Symbol) -> f64) -> Math {
        self.0.put(&Put { leaf, value: Some(value) }).0
    }
}

/// The texts that stand for the symbols.
struct Put<'a> {
    leaf: &'a dyn Fn(Symbol) -> Leaf,
    /// Their values, where numbers stand for them.
    value: Option<&'a dyn Fn(Symbol) -> f64>,
}

impl Node {
    fn put(&self, leaf: &Put<'_>) -> (Math, Shape) {
        let inner = |node: &Self| Arc::new(node.put(leaf).0);
        match self {
            Self::Fixed(math, shape) => (math.clone(), *shape),
            Self::Symbol(symbol) => {
                let Leaf { math, kind } = (leaf.leaf)(*symbol);
                match kind {
                    LeafKind::Name => (math, Shape::Whole),
                    LeafKind::Number { negative } => (math, Shape::Number { negative }),
                }
            }
            Self::Minus(positive) => {
                let (math, shape) = positive.put(leaf);
                (Math::Row(vec![Math::Operator(Operator::Minus), after_sign(math, shape)]), Shape::Sum)
            }
            Self::Sum(terms) => (sum(terms, leaf), Shape::Sum),
            Self::Row(factors) => row(factors, leaf),
            Self::Coefficient(number, factors) => {
                let factors = row(factors, leaf).0;
                (Math::Row(vec![number.clone(), Math::Operator(Operator::Juxtapose), factors]), Shape::Product)
            }
            Self::Fraction(parts) => {
                let [above, below] = parts.each_ref().map(inner);
                (Math::Fraction(above, below), Shape::Whole)
            }
            Self::Root(radicand) => (Math::Root(inner(radicand)), Shape::Whole),
            Self::Power(parts) => power(parts, leaf),
            Self::Apply { name, may_be_bare, arguments } => apply(name, *may_be_bare, arguments, leaf),
            Self::Direction(name, parts) => direction(name, parts, leaf),
            Self::Bars(arguments) => (Math::Bars(Arc::new(separated(arguments, leaf))), Shape::Whole),
            Self::Cases(variable, pieces) => {
                let variable = variable.put(leaf).0;
                let rows = pieces.iter().map(|(until, value)| {
                    let condition = match until {
                        Some(until) => Math::relation(variable.clone(), Operator::AtMost, until.put(leaf).0),
                        None => Math::Text("otherwise".to_owned()),
                    };
                    (condition, value.put(leaf).0)
                });
                (Math::Cases(rows.collect()), Shape::Whole)
            }
        }
    }
}

/// A term after a plus or minus.
fn after_sign(math: Math, shape: Shape) -> Math {
    match shape {
        Shape::Sum | Shape::Number { negative: true } => bracketed(math),
        _ => math,
    }
}

fn sum(terms: &[(bool, Node)], leaf: &Put<'_>) -> Math {
    let mut row = Vec::with_capacity(2 * terms.len());
    for (index, (minus, term)) in terms.iter().enumerate() {
        let (math, shape) = term.put(leaf);
        match (minus, index) {
            (true, _) => row.push(Math::Operator(Operator::Minus)),
            (false, 0) => {}
            (false, _) => row.push(Math::Operator(Operator::Plus)),
        }
        let first = index == 0 && !minus;
        row.push(if first && shape != Shape::Sum { math } else { after_sign(math, shape) });
    }
    Math::Row(row)
}

/// Factors side by side, open where the last one is; a single one as it is.
fn row(factors: &[Node], leaf: &Put<'_>) -> (Math, Shape) {
    let whole = |last: Shape| if last == Shape::Open { Shape::Open } else { Shape::Product };
    if let [single] = factors {
        let (math, shape) = single.put(leaf);
        return (math, whole(shape));
    }
    let mut row: Vec<Math> = Vec::with_capacity(2 * factors.len());
    let mut parts = factors.iter().map(|factor| factor.put(leaf)).peekable();
    let mut end = Shape::Product;
    while let Some((math, shape)) = parts.next() {
        end = shape;
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
    (Math::Row(row), whole(end))
}

fn power([base, exponent]: &[Node; 2], leaf: &Put<'_>) -> (Math, Shape) {
    let (math, shape) = base.put(leaf);
    let fraction = matches!(math, Math::Fraction(..) | Math::Sup(..) | Math::SubSup(..));
    let holds = matches!(shape, Shape::Whole | Shape::Constant) && !fraction;
    let exponent = Arc::new(exponent.put(leaf).0);
    let base = if holds { math } else { bracketed(math) };
    let raised = match base {
        Math::Sub(name, subscript) => Math::SubSup(name.clone(), subscript.clone(), exponent),
        _ => Math::Sup(Arc::new(base), exponent),
    };
    (raised, Shape::Whole)
}

fn apply(name: &Math, may_be_bare: bool, arguments: &[Node], leaf: &Put<'_>) -> (Math, Shape) {
    let name = name.clone();
    if let ([single], true) = (arguments, may_be_bare) {
        let (math, shape) = single.put(leaf);
        let bare = matches!(shape, Shape::Whole | Shape::Constant | Shape::Number { negative: false });
        if bare && !matches!(math, Math::Fraction(..)) {
            return (Math::Row(vec![name, Math::Operator(Operator::Juxtapose), math]), Shape::Open);
        }
        return (Math::Row(vec![name, bracketed(math)]), Shape::Whole);
    }
    (Math::Row(vec![name, bracketed(separated(arguments, leaf))]), Shape::Whole)
}

/// The angle of a point: with numbers, half a turn from the arctangent where x is below zero, a quarter where it is zero.
fn direction(name: &Math, parts: &[(Node, Expr); 2], leaf: &Put<'_>) -> (Math, Shape) {
    let [y, x] = parts.each_ref().map(|(_, term)| leaf.value.map_or(f64::NAN, |value| term.evaluate(value)));
    let degrees = |size: &str| Math::Row(vec![Math::Number(size.into()), Math::Text("\u{b0}".into())]);
    if x == 0.0 && y != 0.0 && !y.is_nan() {
        return (degrees(if y < 0.0 { "-90" } else { "90" }), Shape::Number { negative: y < 0.0 });
    }
    let [above, below] = parts.each_ref().map(|(node, _)| Arc::new(node.put(leaf).0));
    let ratio = Math::Bracketed(Arc::new(Math::Fraction(above, below)));
    let mut row = vec![name.clone(), ratio];
    if x < 0.0 {
        row.extend([Math::Operator(if y < 0.0 { Operator::Minus } else { Operator::Plus }), degrees("180")]);
        return (Math::Row(row), Shape::Sum);
    }
    (Math::Row(row), Shape::Whole)
}

/// Arguments with commas between them.
fn separated(arguments: &[Node], leaf: &Put<'_>) -> Math {
    match arguments {
        [single] => single.put(leaf).0,
        many => {
            let separated = many.iter().flat_map(|part| [Math::Operator(Operator::Comma), part.put(leaf).0]);
            Math::Row(separated.skip(1).collect())
        }
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
