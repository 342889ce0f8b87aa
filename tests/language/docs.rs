//! The examples of the pages on the language are problems that work, and its tables are complete.

use std::collections::BTreeSet;

use momentous::bank::Promise;
use momentous::grade::{Rubric, Verdict};
use momentous::problem::json_schema;

use crate::blocks::blocks;
use crate::pages::{PAGES, language};
use crate::works;

const MARKING: &str = include_str!("../../docs/marking.md");

#[test]
fn every_example_is_a_problem_that_works() {
    let mut ids = BTreeSet::new();
    for (path, page) in PAGES {
        for example in blocks(page).iter().filter(|block| block.language == "yaml") {
            let problem = works::works(&format!("{path}:{}", example.line), &example.text);
            assert!(ids.insert(problem.id().to_owned()), "{} stands there twice", problem.id());
        }
    }
    assert!(ids.len() > 12, "only {} examples were found", ids.len());
}

/// The kinds of stage in the schema, each with an example of its own.
#[test]
fn every_stage_has_an_example() {
    let language = language();
    let schema = serde_json::to_value(json_schema()).unwrap();
    let stages = schema["$defs"]["Stage"]["oneOf"].as_array().unwrap();
    assert!(stages.len() > 6);
    for stage in stages {
        let key = stage["required"][0].as_str().unwrap();
        // Another word for `moment`.
        if key == "torque" {
            continue;
        }
        assert!(language.contains(&format!("    - {key}:")), "there is no example of `{key}`");
    }
}

#[test]
fn every_key_is_mentioned() {
    let language = language();
    let schema = serde_json::to_value(json_schema()).unwrap();
    let definitions = schema["$defs"].as_object().unwrap().values().chain([&schema]);
    let keys = definitions.filter_map(|definition| definition["properties"].as_object()).flat_map(|keys| keys.keys());
    let missing: BTreeSet<&String> =
        keys.filter(|key| !language.contains(&format!("`{key}")) && !language.contains(&format!("{key}: "))).collect();
    assert_eq!(missing, BTreeSet::new());
}

#[test]
fn every_verdict_is_listed_with_its_worth() {
    for verdict in Verdict::all() {
        let worth = Rubric::default().fraction(verdict);
        let row = format!("| `{verdict}` | {} | {worth} |", verdict.meaning());
        assert!(MARKING.contains(&row), "docs/marking.md lacks the row {row}");
    }
}

#[test]
fn every_promise_is_listed() {
    let language = language();
    for promise in Promise::all() {
        let row = format!("| `{}` | {} |", promise.name(), promise.sentence());
        assert!(language.contains(&row), "the pages on the language lack the row {row}");
    }
}
