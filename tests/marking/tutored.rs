//! Answers as students give them, judged as a tutor would; and notations of which other programs were told as bugs.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::{DecimalMark, PartReport, Verdict};
use momentous::problem::{Problem, compile, load};

/// Of wrong answers that students give, so many in a hundred have their mistake named.
const LEAST_NAMED: usize = 85;

fn compiled(source: Source) -> Arc<Problem> {
    Arc::new(compile(load(source).unwrap(), None).unwrap())
}

fn rows(name: &str) -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers").join(name);
    let mut rows = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    rows.records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect()
}

/// What is found of a part, with the answers to all.
fn marked(exercise: &Exercise, answers: &str, part: &str) -> PartReport {
    let pairs = answers.split(" || ").map(|pair| pair.split_once(" = ").unwrap());
    let answers: BTreeMap<String, String> = pairs.map(|(id, text)| (id.to_owned(), text.to_owned())).collect();
    let report = exercise.grade(&answers, DecimalMark::Point);
    report.parts.into_iter().find(|own| own.id == part).unwrap()
}

#[test]
fn answers_of_students_are_judged_as_a_tutor_judges_them() {
    let mut problems: BTreeMap<String, Arc<Problem>> = BTreeMap::new();
    let (mut wrong, mut found, mut named) = (0, Vec::new(), 0);
    for row in rows("tutored.csv") {
        let [id, seed, form, answers, part, verdict, said] = row.try_into().unwrap();
        let problem =
            problems.entry(id.clone()).or_insert_with(|| compiled(Bank::built_in().find(&id).unwrap().clone()));
        let is_form = |own: &momentous::problem::PlannedForm| own.question.name.as_deref().unwrap_or("") == form;
        let place = if form.is_empty() { 0 } else { problem.forms().iter().position(is_form).unwrap() };
        let exercise = Exercise::draw(problem, place, seed.parse().unwrap()).unwrap();
        let own = marked(&exercise, &answers, &part);
        let is = match own.verdict {
            Verdict::Unreadable => "asked",
            verdict if verdict.is_right() => "right",
            _ => "wrong",
        };
        let codes = own.diagnosis.map(|own| own.codes).unwrap_or_default();
        if is != verdict || !said.is_empty() && !codes.contains(&said.as_str()) && own.verdict.code() != said {
            found.push(format!("{id} {seed} {answers}: {part} is {} {codes:?}, not {verdict} {said}", own.verdict));
        }
        wrong += usize::from(is == "wrong");
        named += usize::from(is == "wrong" && !said.is_empty());
    }
    assert!(found.is_empty(), "{}\n{}", found.len(), found.join("\n"));
    assert!(100 * named >= LEAST_NAMED * wrong, "{named} of {wrong}");
}

#[test]
fn notations_of_bug_reports_are_read() {
    let mut problems: BTreeMap<String, Exercise> = BTreeMap::new();
    let mut found = Vec::new();
    for row in rows("tutored_readings.csv") {
        let [kind, id, part, answer, verdict] = row.try_into().unwrap();
        let exercise = problems.entry(id.clone()).or_insert_with(|| {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/fixtures/tutored/{id}.yaml"));
            let source = Source::new(&format!("{id}.yaml"), &std::fs::read_to_string(path).unwrap());
            Exercise::draw(&compiled(source), 0, 1).unwrap()
        });
        let report = exercise.grade(&BTreeMap::from([(part.clone(), answer.clone())]), DecimalMark::Point);
        let own = report.parts.iter().find(|own| own.id == part).unwrap();
        if own.verdict.is_right() != (verdict == "right") {
            found.push(format!("{kind}: {answer}: {}, not {verdict}", own.verdict));
        }
    }
    assert!(found.is_empty(), "{}\n{}", found.len(), found.join("\n"));
}
