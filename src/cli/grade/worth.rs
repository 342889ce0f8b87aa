//! Points of parts in a homework, and what is earned of them.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::grade::{PartReport, Points};
use crate::quantity::Rational;

/// The points of each part of a problem in the homework, by the part's name.
pub(super) type Worth = BTreeMap<String, Rational>;

/// The points of sheets, by the texts of a submission: student, problem, form and seed.
pub(super) type Worths = BTreeMap<[String; 4], Arc<Worth>>;

/// The points that a part earned, and those that it could.
pub(super) struct Earned {
    pub(super) points: Points,
    pub(super) out_of: Points,
}

impl Earned {
    /// In the points of the homework where there is one, else in those of the problem's file.
    pub(super) fn of(part: &PartReport, worth: Option<&Worth>) -> Self {
        let out_of = Rational::from(part.out_of);
        match worth.and_then(|worth| worth.get(&part.id)) {
            Some(worth) if out_of != Rational::ZERO => {
                Self { points: Points(&part.points.0 * worth / out_of), out_of: Points(worth.clone()) }
            }
            // A part without points of its own is right or not.
            Some(worth) if part.verdict.is_right() => {
                Self { points: Points(worth.clone()), out_of: Points(worth.clone()) }
            }
            Some(worth) => Self { points: Points(Rational::ZERO), out_of: Points(worth.clone()) },
            None => Self { points: part.points.clone(), out_of: Points(out_of) },
        }
    }
}
