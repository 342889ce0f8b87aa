//! Where bodies are and how they move.

/// A vector of `D` components; with `D = 1` the compiler works with plain numbers.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;

/// Where every body is at a time, and how it moves.
#[derive(Clone, Debug, PartialEq)]
pub struct State<const D: usize> {
    /// The time in s.
    pub time: f64,
    /// The centres in m.
    pub positions: Vec<Vector<D>>,
    /// The velocities in m/s.
    pub velocities: Vec<Vector<D>>,
}
