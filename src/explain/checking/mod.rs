//! Checks that a student can copy: balances, energy, extremes.

pub(super) mod checks;
pub(super) mod energy;
pub(super) mod limits;
