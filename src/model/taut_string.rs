//! A string that is taut: since when, and where it leads.

use super::frame::Direction;

/// A string that was jerked taut.
#[derive(Clone, Debug)]
pub struct TautString {
    /// The stage in which it was jerked.
    pub jerk: usize,
    /// The bodies at its ends, the second ahead of the first.
    pub ends: [String; 2],
    /// The direction in which it leads from the first body.
    pub direction: Direction,
}
