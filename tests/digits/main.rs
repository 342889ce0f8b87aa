//! What is printed can be computed with: the numbers of a sheet lead to its answers.

#![allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]

mod givens;
