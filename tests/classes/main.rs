//! Classes on a server: its pages, courses and their rules, the records, and what an operator relies on.

#![cfg(feature = "serve")]
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[path = "../support/blocks.rs"]
mod blocks;
mod course_rules;
mod courses;
mod serving;
mod store;
mod web;
