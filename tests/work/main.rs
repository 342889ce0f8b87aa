//! Judging the work: whether lines that follow are accepted, lines that do not are refused, and mistakes named.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod algebra;
mod altered;
mod consequences;
mod forms;
mod rubric;
mod solutions;
mod students;
