//! What the model says in words, over the bank and the problems of books: every reason, condition and meaning says something.

use std::fs;
use std::path::Path;

use momentous::model::Because;
use momentous::problem::Problem;

use crate::variants::bank;
use crate::variants::read;

/// Every text of a problem's model, with where it stands.
fn said(problem: &Problem) -> Vec<(String, String)> {
    let model = problem.model();
    let because = model.instances.iter().filter(|instance| instance.because != Because::Definition);
    let because = because.map(|instance| (format!("why {} applies", instance.law.id), instance.because.to_string()));
    let reasons = model.reasons.iter().map(|reason| ("what forbids a value".to_owned(), reason.to_string()));
    let ways =
        model.choices.iter().flatten().map(|alternative| ("a way of a stage".to_owned(), alternative.what.clone()));
    let omitted = model
        .omissions
        .iter()
        .flat_map(|omission| [&omission.what, &omission.why].map(|text| ("omitted".to_owned(), text.clone())));
    let called = model.impulses.iter().map(|impulse| ("an impulse".to_owned(), impulse.called.clone()));
    because.chain(reasons).chain(ways).chain(omitted).chain(called).collect()
}

/// The problems of books, compiled.
fn published() -> Vec<Problem> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/reference");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let problems = files.filter(|file| file.extension().is_some_and(|extension| extension == "yaml"));
    let compiled =
        problems.filter_map(|file| read(&file.display().to_string(), &fs::read_to_string(&file).unwrap()).ok());
    compiled.collect()
}

#[test]
fn every_reason_says_something() {
    let mut texts = 0;
    for problem in bank().iter().chain(&published()) {
        for (place, text) in said(problem) {
            texts += 1;
            let is_clause = text.chars().any(char::is_alphabetic) && text.trim() == text && !text.ends_with('.');
            let is_whole = !["  ", "{", "}", " ,", "Fact(", "Some("].iter().any(|sign| text.contains(sign));
            assert!(is_clause && is_whole, "{}: {place}: `{text}`", problem.id());
        }
    }
    assert!(texts > 1000, "only {texts} texts were read");
}
