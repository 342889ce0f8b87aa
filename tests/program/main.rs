//! The program as whoever runs it meets it: its commands, its files, and what it refuses.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

#[path = "../support/blocks.rs"]
mod blocks;
mod cli;
mod course_repository;
mod course_symbols;
mod diagnosis_table;
mod found;
#[cfg(feature = "serve")]
mod fuzz;
mod grade_files;
mod hand;
mod help_examples;
mod homework;
mod issued_numbers;
mod other_tables;
mod readme;
#[path = "../support/room.rs"]
mod room;
mod spoilt_seeds;
mod term;
mod trust;
mod trusted_tables;
#[cfg(all(feature = "serve", not(feature = "courses")))]
mod without_courses;
