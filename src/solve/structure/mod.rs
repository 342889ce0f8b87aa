//! The structure of equations: which symbols they contain, and their derivatives at sampled places.

pub(super) mod basis;
pub(super) mod bits;
pub(super) mod blocks;
mod determined;
pub(super) mod freedom;
pub(super) mod incidence;
pub(super) mod matching;
pub(super) mod rank;
pub(super) mod residuals;
pub(super) mod sample;
