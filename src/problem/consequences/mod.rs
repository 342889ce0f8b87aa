//! Consequences of common mistakes and of a student's own earlier answers.

pub(super) mod feedback;
pub(super) mod follow;
pub(super) mod following;
pub(super) mod mistake;
pub(super) mod mistakes;
pub(super) mod restricted;
pub(super) mod simulated;
pub(super) mod slips;
pub(super) mod solver;
pub(super) mod taken;
