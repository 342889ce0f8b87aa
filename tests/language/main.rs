//! The language of problem files: what it says, what is drawn from it, and how its faults are told.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod audits;
mod bad_problems;
mod bank_loads;
#[path = "../support/blocks.rs"]
mod blocks;
mod docs;
mod draws;
mod golden;
mod limits;
mod load_properties;
mod other_values;
mod pages;
mod schema;
mod sheet_numbers;
mod stages;
#[path = "../support/works.rs"]
mod works;
