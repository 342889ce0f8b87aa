//! Derivatives and integrals, and what is seen of a term by its values.

pub(super) mod curvature;
pub(super) mod derivative;
pub(super) mod integral;
pub(super) mod pieces;
pub(super) mod slopes;
