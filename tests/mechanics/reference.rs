//! Problems from textbooks, examinations and open courses, each with the answer that was published: facts in our own words, with
//! their source in the file.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};
use serde::Deserialize;

/// What is known about a problem from elsewhere.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Published {
    /// Whether the book's own value is wrong or was rounded early, so that an independent calculation stands in its place.
    #[serde(default)]
    recomputed: bool,
    /// Part of the question, and its answer with the figures in which it was published.
    answers: BTreeMap<String, String>,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/reference")
}

/// How many problems with published answers were collected.
const COLLECTED: usize = 138;

/// The problems that cannot be said, each with the reason.
fn left_out() -> BTreeMap<String, String> {
    serde_yaml::from_str(&fs::read_to_string(folder().join("left_out.yaml")).unwrap()).unwrap()
}

fn solved(name: &str) -> (String, Exercise) {
    let path = folder().join(name).with_extension("yaml");
    let text = fs::read_to_string(&path).unwrap();
    let problem = load(Source::new(name, &text)).and_then(|loaded| compile(loaded, None));
    let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")));
    let exercise = Exercise::draw(&problem, 0, 1).unwrap_or_else(|reason| panic!("{name}: {reason}"));
    (text, exercise)
}

/// Number, unit and one unit in the last figure of a published value: `-0.135 m/s`, `1.50e6 m/s`.
fn read(text: &str) -> (f64, &str, f64) {
    let (number, unit) = text.split_once(' ').unwrap_or((text, ""));
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent: i32 = exponent.parse().unwrap();
    let place = 10_f64.powi(exponent - i32::try_from(decimals).unwrap());
    // A zero was published as a word, and is exactly that.
    let value: f64 = number.parse().unwrap();
    (value, unit, if value == 0.0 { 1e-9 } else { place })
}

#[test]
fn published_answers_are_reached() {
    let answers = fs::read_to_string(folder().join("answers.yaml")).unwrap();
    let answers: BTreeMap<String, Published> = serde_yaml::from_str(&answers).unwrap();
    let (mut parts, mut recomputed, mut with_relations, mut wrong) = (0, 0, Vec::new(), Vec::new());
    for (name, published) in &answers {
        let (text, exercise) = solved(name);
        let record = exercise.record(None);
        let asked = record["ask"].as_array().unwrap();
        assert_eq!(asked.len(), published.answers.len(), "{name}: every part has its published answer");
        for part in asked {
            let id = part["id"].as_str().unwrap();
            let (value, unit, tolerance) = read(&published.answers[id]);
            assert_eq!(part["unit"].as_str().unwrap().replace('°', "deg"), unit, "{name}: the unit of `{id}`");
            let computed = part["value"].as_f64().unwrap();
            if (computed - value).abs() > tolerance * 1.000_001 {
                wrong.push(format!("{name}: `{id}` is {computed}, published {value} {unit}"));
            }
            parts += 1;
        }
        recomputed += usize::from(published.recomputed);
        if text.contains("\nrelations:") {
            with_relations.push(name.as_str());
        }
    }
    println!(
        "{} published problems with {parts} answers, {recomputed} of the problems recomputed independently",
        answers.len()
    );
    println!("{} of the {COLLECTED} problems collected are done, {} are left out", answers.len(), left_out().len());
    println!("{} need a relation of the author's own: {}", with_relations.len(), with_relations.join(", "));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(with_relations.len() < 10, "laws that many problems need belong into the language");
}

#[test]
fn every_problem_collected_is_done_or_left_out_with_a_reason() {
    let answers = fs::read_to_string(folder().join("answers.yaml")).unwrap();
    let answers: BTreeMap<String, Published> = serde_yaml::from_str(&answers).unwrap();
    let left_out = left_out();
    for (name, reason) in &left_out {
        assert!(!answers.contains_key(name), "{name} is done, and left out");
        assert!(reason.len() > 20, "{name}: say why");
    }
    assert_eq!(answers.len() + left_out.len(), COLLECTED);
}

#[test]
fn every_file_has_a_published_answer() {
    let answers = fs::read_to_string(folder().join("answers.yaml")).unwrap();
    let answers: BTreeMap<String, Published> = serde_yaml::from_str(&answers).unwrap();
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let named = |path: PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    let mut files: Vec<String> = files.map(named).filter(|name| name != "answers" && name != "left_out").collect();
    files.sort();
    assert_eq!(files, answers.into_keys().collect::<Vec<_>>());
}
