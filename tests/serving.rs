//! What an operator relies on: the check of a set-up, what is measured and told, and that `docs/serving.md` names what exists.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[path = "documents/blocks.rs"]
mod blocks;
#[path = "serving/check.rs"]
mod check;
#[path = "serving/documents.rs"]
mod documents;
#[path = "serving/measured.rs"]
mod measured;
#[path = "serving/retention.rs"]
mod retention;
#[allow(dead_code, reason = "the tests of the store make more of it")]
#[path = "store/sample.rs"]
mod sample;
#[path = "serving/server.rs"]
mod server;

/// When the course of the sample was made: 2025-12-01, 08:00 UTC.
const NOW: momentous::course::Moment = momentous::course::Moment::from_millis(1_764_576_000_000);
