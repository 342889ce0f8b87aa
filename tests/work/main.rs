//! Judging the work: whether lines that follow are accepted, lines that do not are refused, and mistakes named.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod algebra;
mod altered;
mod consequences;
mod forms;
mod kinds;
mod numbers;
mod rubric;
mod solutions;
mod students;

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::problem::{compile, load};

/// The first form of a problem of the bank, with the numbers of a seed.
fn drawn(problem: &str, seed: u64) -> Exercise {
    let source = Bank::built_in().sources().find(|source| source.name.contains(problem)).unwrap().clone();
    let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
    Exercise::draw(&problem, 0, seed).unwrap()
}
