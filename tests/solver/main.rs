//! The solver as a whole: which equations it takes, what it makes of them, and how true its bounds are.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod bounds;
mod certificates;
mod planning;
mod plans;
mod values;
#[path = "../support/variants.rs"]
mod variants;
mod world;
