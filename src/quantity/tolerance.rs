//! How far an answer may lie from the exact one.

use super::Decimal;

/// How far an answer may lie from the exact one, boundaries included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tolerance {
    /// A fraction of the exact value: `0.01`.
    Relative(Decimal),
    /// A distance, in the unit of the question.
    Absolute(Decimal),
    /// Half a unit of the exact value's last asked figure: strict, and without any allowance for rounding in between.
    ToFigures,
}
