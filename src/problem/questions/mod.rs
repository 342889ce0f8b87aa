//! Questions, compiled: each kind, and what it depends on.

pub(super) mod choices;
pub(super) mod conservation;
pub(super) mod counted;
pub(super) mod enough;
pub(super) mod equality;
pub(super) mod number;
pub(super) mod part;
pub(super) mod parts;
pub(super) mod pictures;
pub(super) mod range;
mod rubric;
pub(super) mod to_solve;
pub(super) mod vector;
