//! A body that a stage does not name while something acts on it.

/// Which body, and in which stage.
pub(super) struct LeftAlone {
    /// The stage, counted from 0.
    pub(super) stage: usize,
    /// The short name of the body.
    pub(super) body: String,
    /// The forces on it.
    pub(super) by: Acts,
}

/// The forces on a body that a stage does not name.
pub(super) enum Acts {
    /// Its weight.
    Weight,
    /// A bond that an earlier stage left, in words: `the spring still presses`.
    Bond(&'static str),
}
