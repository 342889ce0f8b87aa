//! A place where an impulse can act.

/// A place where an impulse can act.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Contact {
    /// Two bodies, by their places in the list; on a line the first is the one at the left.
    Bodies(usize, usize),
    /// A body at a wall.
    Wall {
        /// The wall's place in the list.
        wall: usize,
        /// The body's place in the list.
        body: usize,
    },
    /// A cord that is taut.
    Cord(usize),
}
