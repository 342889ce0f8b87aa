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

impl Tolerance {
    /// How far an answer of a size may lie from the exact one, where rounding on the way is allowed for; both in the unit of the
    /// question.
    ///
    /// ```
    /// use momentous_quantity::{Decimal, Tolerance};
    /// assert_eq!(Tolerance::Relative(Decimal::from_scaled(1, 2)).reach(-4.0), Some(0.04));
    /// assert_eq!(Tolerance::ToFigures.reach(-4.0), None);
    /// ```
    #[must_use]
    pub fn reach(&self, size: f64) -> Option<f64> {
        match self {
            Self::Relative(fraction) => Some(fraction.to_f64().abs() * size.abs()),
            Self::Absolute(distance) => Some(distance.to_f64().abs()),
            Self::ToFigures => None,
        }
    }
}

/// How many tolerances rounding on the way may shift an answer by: what is further away is another answer.
pub const MOST_TOLERANCES: f64 = 3.0;
