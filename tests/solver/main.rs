//! The solver as a whole: which equations it takes, what it makes of them, and how true its bounds are.

#![allow(clippy::expect_used, clippy::unwrap_used, reason = "a test may panic")]

mod bounds;
mod planning;
mod values;
mod world;
