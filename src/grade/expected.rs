//! The right answer: all that marking needs to know of a solved variant.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolTable;
use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;

/// The expected answer to one part of a question.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// How the part is called in answers: `v_A2`.
    pub id: String,
    /// Its points.
    pub points: u32,
    /// How it is answered.
    pub kind: ExpectedKind,
}

/// How a part is answered.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpectedKind {
    /// By a number with a unit.
    Number(ExpectedNumber),
    /// By a vector.
    Vector(ExpectedVector),
    /// By a formula in what the sheet gives.
    Formula(ExpectedFormula),
    /// By an interval, or a condition such as `e <= 0.5`.
    Interval(Box<ExpectedInterval>),
    /// By one of several phrases.
    Choice {
        /// The question, as it is printed: what is asked may be said in its own words.
        question: String,
        /// The phrases, in the order in which they are offered.
        options: Vec<String>,
        /// The position of the right one.
        right: usize,
        /// Why it is right, as a sentence without a full stop. It is shown to those only who chose it.
        because: String,
    },
}

/// A number that is asked. All numbers but the tolerance's fraction are in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedNumber {
    /// The answer, to double precision.
    pub value: f64,
    /// How far the exact answer may lie from `value`: its certificate.
    pub error: f64,
    /// The exact answer, where it is known and rational.
    pub exact: Option<Rational>,
    /// The unit in which it is asked; any other of the same dimension is as good.
    pub unit: Unit,
    /// The size of that unit in SI units.
    pub size: f64,
    /// How far an answer may lie from the exact one.
    pub tolerance: Tolerance,
    /// The significant figures that are asked.
    pub figures: usize,
    /// How far honest rounding of every intermediate value can move the answer.
    pub allowance: f64,
    /// The size against which an answer that is exactly zero is judged: that of what cancels in it. Not looked at otherwise.
    pub scale: f64,
    /// Whether it is a direction: 358° is as good as -2°.
    pub cyclic: bool,
    /// The words for a positive and for a negative value, for the component of a vector: `to the right`, `to the left`.
    pub senses: Option<[String; 2]>,
    /// Whether it may be negative by its meaning, as a component or a difference: of anything else a student's minus sign is only
    /// a slip of the pen.
    pub signed: bool,
    /// Whether it is a whole number, found by counting.
    pub whole: bool,
    /// Which units will do.
    pub units: Units,
    /// The treatment of the figures with which a right value is written.
    pub writing: Writing,
    /// The reference of a direction, so that it may be answered in words: `36° N of E`.
    pub reference: Option<Reference>,
    /// How it is called, where it has a name.
    pub called: Option<Arc<Called>>,
}

/// How a number that is asked is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Called {
    /// Its name: another quantity's before a value is asked back.
    pub name: String,
    /// The axis along which it is counted, of a component: `-x` says its direction then, and `-y` does not.
    pub axis: Option<char>,
    /// The directions in space, positive first: of what hangs on a string along which it is counted, `downwards`, `upwards`, and of a
    /// place.
    pub in_space: Option<[String; 2]>,
    /// Whether the motion that the sheet tells goes in the positive direction: `back` and `in the same direction` are said of it.
    pub motion: Option<bool>,
    /// The quantity of which it is asked as a multiple.
    pub multiple_of: Option<Multiple>,
}

/// A quantity of which a number is asked as a multiple.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Multiple {
    /// Its name.
    pub name: String,
    /// The unit of the multiple and that of the product, where there are such. 6 m/s times a mass m is written `6m`, and may be written
    /// with either: `6 m/s m`, `6m N s`.
    pub units: Option<[Unit; 2]>,
}

/// Which units of the right dimension will do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Units {
    /// Any.
    #[default]
    Any,
    /// The form that the question asks for.
    AsAsked,
}

/// The treatment of the figures with which a right value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Writing {
    /// Nothing.
    Ignore,
    /// The student is told.
    #[default]
    Advise,
    /// The student is told, and it costs points.
    Require,
}

/// The axes of a question, with the words for their directions.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Frame {
    /// The axes, in the order in which components are written. Angles are counted from the first towards the second.
    pub axes: Vec<FrameAxis>,
}

/// An axis, with the words for its two directions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameAxis {
    /// Its letter: `x`, `y`, `n`, `t`.
    pub letter: char,
    /// The words for a positive and for a negative component.
    pub senses: [String; 2],
}

/// How a direction is counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// The axes.
    pub frame: Frame,
    /// The direction from which it is counted, in quarter turns from the first axis towards the second.
    pub quarters: i32,
    /// Whether it is counted clockwise, from the second axis towards the first.
    pub clockwise: bool,
}

impl Reference {
    /// Whether it is counted from the positive end of the first axis, or from none of its ends.
    pub(super) fn level(&self) -> bool {
        self.quarters.rem_euclid(4) != 2
    }

    /// The direction from which it is counted, as it is typed: `+x`.
    #[must_use]
    pub fn zero(&self) -> String {
        let letter = |axis: usize| self.frame.axes.get(axis).map_or(' ', |axis| axis.letter);
        let (sign, axis) = match self.quarters.rem_euclid(4) {
            0 => ('+', 0),
            1 => ('+', 1),
            2 => ('-', 0),
            _ => ('-', 1),
        };
        format!("{sign}{}", letter(axis))
    }
}

/// A vector that is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedVector {
    /// Its components, along the axes of the frame and in one unit. The tolerance of the first is that of the vector.
    pub components: Vec<ExpectedNumber>,
    /// The axes.
    pub frame: Frame,
}

/// A formula that is asked.
#[derive(Clone, Debug)]
pub struct ExpectedFormula {
    /// The right one, in the symbols of `domain`.
    pub formula: Expr,
    /// The names and dimensions of all symbols of the problem.
    pub symbols: Arc<SymbolTable>,
    /// The quantity that is asked, which may not stand in its own formula.
    pub asked: Symbol,
    /// The symbols that it may contain, each with the least and the greatest value that it has in the problem, in SI units.
    pub domain: Vec<(Symbol, f64, f64)>,
    /// Values of the symbols of `domain`, in its order, in variants of the problem: formulas are compared near them. A missing
    /// value may be any in its range; where there are no variants, all may.
    pub samples: Arc<[Vec<Option<f64>>]>,
    /// The other symbols that it may contain, each with what it stands for: a number that the sheet tells, or a term in the
    /// symbols above.
    pub values: Vec<(Symbol, Expr)>,
    /// The quantity of which the answer is asked as a multiple: the bare multiple is as good.
    pub multiple_of: Option<Symbol>,
    /// The dimension that it measures.
    pub dimension: Dimension,
    /// Its value with the numbers of the variant, in SI units, where it is a pure number.
    pub value: Option<f64>,
    /// Whether it may be negative by its meaning, as a component or a difference.
    pub signed: bool,
    /// Whether its sign is a direction.
    pub directed: bool,
}

impl ExpectedFormula {
    /// A formula in the symbols of `domain` alone, each between two values.
    #[must_use]
    pub fn new(formula: Expr, symbols: Arc<SymbolTable>, asked: Symbol, domain: Vec<(Symbol, f64, f64)>) -> Self {
        let dimension = symbols.entry(asked).dimension;
        let samples = Arc::default();
        Self {
            formula,
            symbols,
            asked,
            domain,
            samples,
            values: Vec::new(),
            multiple_of: None,
            dimension,
            value: None,
            signed: true,
            directed: true,
        }
    }

    /// The quantity of which an answer is the bare multiple.
    #[must_use]
    pub fn left_out(&self, answer: &Expr) -> Option<Symbol> {
        let dimension = answer.dimension(&self.symbols).ok()?;
        self.multiple_of.filter(|unit| dimension * self.symbols.entry(*unit).dimension == self.dimension)
    }

    /// An answer with everything that stands for something else written out; a bare multiple as what it is a multiple of.
    #[must_use]
    pub fn in_letters(&self, answer: &Expr) -> Expr {
        let whole = self.left_out(answer).map_or_else(|| answer.clone(), |unit| answer.clone() * Expr::from(unit));
        let value =
            |symbol: Symbol| self.values.iter().find(|(listed, _)| *listed == symbol).map(|(_, value)| value.clone());
        whole.substitute(&value)
    }
}

impl PartialEq for ExpectedFormula {
    fn eq(&self, other: &Self) -> bool {
        self.formula == other.formula
            && self.asked == other.asked
            && self.domain == other.domain
            && self.value == other.value
    }
}

/// An interval that is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedInterval {
    /// The name of the quantity: `e`.
    pub name: String,
    /// The lower end; none where it is open to minus infinity.
    pub low: Option<ExpectedEnd>,
    /// The upper end; none where it is open to infinity.
    pub high: Option<ExpectedEnd>,
    /// The unit of both ends.
    pub unit: Unit,
}

/// An end of an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedEnd {
    /// Its value.
    pub number: ExpectedNumber,
    /// Whether it belongs to the interval.
    pub closed: bool,
    /// Whether it is a limit of the quantity itself, which a condition need not repeat: `e > 0.5` for `0.5 < e <= 1`.
    pub is_limit: bool,
}

impl ExpectedNumber {
    /// A number to three figures within 1 %, judged by itself alone: everything else is as the default says.
    #[must_use]
    pub fn new(value: f64, unit: Unit) -> Self {
        Self {
            value,
            error: 0.0,
            exact: None,
            size: unit.factor().to_f64(),
            unit,
            tolerance: Tolerance::Relative(Decimal::from_scaled(1, 2)),
            figures: 3,
            allowance: 0.0,
            scale: 0.0,
            cyclic: false,
            senses: None,
            signed: true,
            whole: false,
            units: Units::Any,
            writing: Writing::Advise,
            reference: None,
            called: None,
        }
    }

    /// Whether it is a magnitude, in whose answer a minus sign is only a slip of the pen.
    #[must_use]
    pub fn is_magnitude(&self) -> bool {
        !self.signed && self.value >= 0.0
    }
}
