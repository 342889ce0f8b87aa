//! What a right answer is: all that marking needs to know of a solved variant.

use crate::quantity::Decimal;
use crate::quantity::Rational;
use crate::quantity::Unit;

/// What is expected as the answer to one part of a question.
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
    /// By one of several phrases.
    Choice {
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
    /// How far an answer may lie from the exact one.
    pub tolerance: Tolerance,
    /// The significant figures that are asked.
    pub figures: usize,
    /// How far honest rounding of every intermediate value can move the answer.
    pub allowance: f64,
    /// The size of such quantities in this problem, against which a zero is judged.
    pub scale: f64,
    /// Whether it is a direction: 358° is as good as -2°.
    pub cyclic: bool,
    /// The words for a positive and for a negative value, for the component of a vector: `to the right`, `to the left`.
    pub senses: Option<[String; 2]>,
    /// Whether it is never negative by its meaning, as a speed or an energy lost: a student's sign is then only a slip of the pen.
    pub magnitude: bool,
    /// Whether it is a whole number, found by counting.
    pub whole: bool,
}

/// How far an answer may lie from the exact one, boundaries included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tolerance {
    /// A fraction of the exact value: `0.01`.
    Relative(Decimal),
    /// A distance, in the unit of the question.
    Absolute(Decimal),
}
