//! Ordinary differential equations: one integrator for worlds and for stages, with two pairs of formulas.

mod eighth;
mod fifth;
mod pair;
mod step;

pub(crate) use eighth::EIGHTH;
pub(crate) use fifth::FIFTH;
pub(crate) use pair::Pair;
pub(crate) use step::{Quartic, Step};
