//! Points reached of points that can be reached.

use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;
use momentous_quantity::exact;

use super::stored_report::StoredReport;

/// Points reached on a sheet, of those that can be reached.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Score {
    /// The points reached.
    #[serde(with = "exact")]
    pub points: Rational,
    /// Those that can be reached.
    pub out_of: u32,
}

impl Score {
    /// The score of the attempt that counts, by what was kept of the last one.
    #[must_use]
    pub fn of(last: &StoredReport) -> Option<Self> {
        Some(Self { points: last.history.points()?.clone(), out_of: last.out_of })
    }

    /// All points.
    #[must_use]
    pub fn full(out_of: u32) -> Self {
        Self { points: Rational::from(out_of), out_of }
    }

    /// The share of the points that was reached; all of none.
    #[must_use]
    pub fn share(&self) -> Rational {
        if self.out_of == 0 { Rational::ONE } else { &self.points / Rational::from(self.out_of) }
    }

    /// The same score where all of it is worth so many points.
    #[must_use]
    pub fn scaled(&self, out_of: u32) -> Self {
        Self { points: self.share() * Rational::from(out_of), out_of }
    }
}
