//! The mechanics is right: against balances, calculations by hand, published answers and independent simulations.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod concepts;
mod conservation;
mod exercises;
mod followed;
mod graphs;
mod hunt;
mod least;
mod near_zero;
mod orbits;
mod physics;
mod point_impact;
mod reference;
mod separation;
mod stability;
mod textbook;
#[path = "../support/variants.rs"]
mod variants;
mod watched;
mod witness;
mod wording;
