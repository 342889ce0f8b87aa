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
#[path = "serving/server.rs"]
mod server;
