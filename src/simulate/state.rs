//! States: the places and velocities of bodies.

/// A vector of `D` components; with `D = 1` the compiler works with plain numbers.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;

/// The place and velocity of every body at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct State<const D: usize> {
    /// The time in s.
    pub time: f64,
    /// The centres in m.
    pub positions: Vec<Vector<D>>,
    /// The velocities in m/s.
    pub velocities: Vec<Vector<D>>,
}
