//! Answers to whole sheets: what is found about one part of them, and what is said.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{Problem, compile, load};

/// A problem of the bank, or of a file, with the seed that is used: that behind an `@`, or the usual one.
fn problem(name: &str) -> (Arc<Problem>, u64) {
    if let Some((name, seed)) = name.split_once('@') {
        return (problem(name).0, seed.parse().unwrap_or_else(|_| panic!("{seed}")));
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/problems").join(name);
    let (source, seed) = match std::fs::read_to_string(&file) {
        Ok(text) => (Source::new(name, &text), 1),
        Err(_) => (Bank::built_in().find(name).unwrap_or_else(|_| panic!("{name}")).clone(), 5),
    };
    let loaded = load(source).unwrap_or_else(|faults| panic!("{faults}"));
    (Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}"))), seed)
}

#[test]
fn answers_to_sheets_are_found_to_be_what_they_are() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers/diagnosed.txt");
    let table = std::fs::read_to_string(path).expect("the table is there");
    let mut wrong = Vec::new();
    for row in table.lines().filter(|row| !row.is_empty() && !row.starts_with('#')) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let [name, form, typed, part, verdict, codes, says] = cells[..] else { panic!("{row}") };
        let (problem, seed) = problem(name);
        let named = problem.forms().iter().position(|own| own.question.name.as_deref() == Some(form));
        let exercise = Exercise::draw(&problem, named.unwrap_or(0), seed).unwrap_or_else(|reason| panic!("{reason}"));
        let answers: BTreeMap<String, String> = typed
            .split("; ")
            .filter_map(|own| own.split_once('='))
            .map(|(name, text)| (exercise.usual_name(name).to_owned(), text.to_owned()))
            .collect();
        let report = exercise.grade(&answers, DecimalMark::Point);
        let own = report.parts.iter().find(|own| own.id == part).unwrap_or_else(|| panic!("{row}"));
        let found = own.diagnosis.as_ref().map(|own| own.codes.join(" ")).unwrap_or_default();
        if own.verdict.code() != verdict || found != codes || !own.message.contains(says) {
            wrong.push(format!("{row}\n    {} | {found} | {}", own.verdict, own.message));
        }
        let sentences: Vec<&str> = own.message.split_inclusive(['.', '?']).map(str::trim).collect();
        assert!(sentences.windows(2).all(|pair| pair[0] != pair[1]), "{}", own.message);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
