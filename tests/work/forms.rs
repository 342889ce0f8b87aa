//! Lines in the forms of calculus, series and vectors, each with its verdict.

use std::fs;

use momentous::grade::DecimalMark;
use momentous::work::Judge;
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
