//! Lines in the forms of calculus, series and vectors, each with its verdict.

use std::fs;

use momentous::grade::DecimalMark;
use momentous::work::{Judge, Verdict};
use serde::Deserialize;

use super::drawn;

/// The variant on which the lines are judged.
const SEED: u64 = 1;

#[derive(Deserialize)]
struct Work {
    problem: String,
    lines: Vec<Line>,
}

#[derive(Deserialize)]
struct Line {
    text: String,
    verdict: serde_yaml::Value,
}

#[test]
fn integrals_series_and_vectors_are_read() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/work/forms.yaml");
    let works: Vec<Work> = serde_yaml::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let mut apart = Vec::new();
    for work in &works {
        let exercise = drawn(&work.problem, SEED);
        let mut judge = Judge::new(exercise.worked(), DecimalMark::Point);
        for line in &work.lines {
            let judged = judge.line(&line.text);
            if serde_yaml::to_value(judged.verdict).unwrap() != line.verdict {
                apart.push(format!("{}: {:?}: {}", line.text, judged.verdict, judged.message));
            }
        }
    }
    assert!(apart.is_empty(), "{}", apart.join("\n"));
}

#[test]
fn a_side_that_is_too_long_is_not_taken_apart() {
    let deep = |open: &str, close: &str| format!("{}1{} = 3", open.repeat(5_000), close.repeat(5_000));
    for line in [deep("∫_0^1 ", " dt"), deep("t]_{[", "]_0^1}^1"), deep("\\vec{", "}"), deep("|", "|")] {
        let exercise = drawn("impact/two-carts", SEED);
        let mut judge = Judge::new(exercise.worked(), DecimalMark::Point);
        // Also where it would say what a letter of one's own stands for.
        for line in [format!("h = {line}"), line] {
            let judged = judge.line(&line);
            assert_eq!(judged.verdict, Verdict::Unreadable);
            assert!(judged.message.contains("1000 characters"), "{}", judged.message);
        }
    }
}
