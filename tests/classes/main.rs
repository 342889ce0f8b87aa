//! Classes on a server: its pages, courses and their rules, the records, and what an operator relies on.

#![cfg(feature = "serve")]
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[cfg(feature = "courses")]
#[path = "../support/blocks.rs"]
mod blocks;
#[cfg(feature = "courses")]
mod course_rules;
#[cfg(feature = "courses")]
mod courses;
#[cfg(feature = "courses")]
mod serving;
#[cfg(feature = "courses")]
mod store;
mod web;
