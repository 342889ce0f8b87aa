//! One of several ways in which a stage can go.

use momentous_solve::Condition;
use momentous_solve::Equation;

/// One of several ways in which a stage can go, with what holds only there.
#[derive(Clone, Debug, Default)]
pub struct Alternative {
    /// The course of events, as a clause: `the crate stays at rest`.
    pub what: String,
    /// Equations that hold only there.
    pub equations: Vec<Equation>,
    /// When it is the way that is taken.
    pub conditions: Vec<Condition>,
    /// The stage, counted from 0, all through which a body stands still, and the short name of the body.
    pub still: Option<(usize, String)>,
}
