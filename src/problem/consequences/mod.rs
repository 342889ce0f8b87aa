//! What comes of common mistakes and of a student's own earlier answers.

pub(super) mod feedback;
pub(super) mod follow;
pub(super) mod misjudged;
pub(super) mod mistakes;
pub(super) mod restricted;
pub(super) mod simulated;
