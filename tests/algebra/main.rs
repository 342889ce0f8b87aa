//! Each sentence of algebra in a worked solution is true: it is applied literally to the equations that it names, and what
//! comes out is compared with what is printed.

#![allow(clippy::unwrap_used, clippy::cast_precision_loss, clippy::cast_possible_truncation)]

mod lines;
mod page;
mod points;
mod printed;
mod term;
mod typed;

#[path = "../support/variants.rs"]
mod variants;

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::render::Format;
use momentous::render::Renderer;
use momentous::render::Solution;
use serde_json::Value;
use term::Values;

/// Every quantity of an exercise that has a value, by its name.
fn values(exercise: &Exercise) -> Values {
    let worked = exercise.worked();
    let named = worked
        .problem
        .model()
        .symbols
        .iter()
        .filter_map(|(symbol, entry)| Some((entry.name.clone(), worked.variant.value(symbol)?.value)));
    named.collect()
}

/// The lines of a solution, without the numbers that they give.
fn lines_of(exercise: &Exercise) -> Vec<Value> {
    let mut record = exercise.record(Some(String::new()));
    let Value::Array(mut lines) = record["lines"].take() else { panic!("a solution without lines") };
    for line in &mut lines {
        line["value"].take();
    }
    lines
}

/// The worked solution as Markdown.
fn page_of(exercise: &Exercise, renderer: &Renderer) -> String {
    let audience = Audience::Everyone;
    let outline = exercise.outline(audience);
    let solution = Solution { outline, identity: exercise.identity(), audience, faded: None };
    renderer.render_solution(&solution, Format::Markdown).unwrap().text
}

/// The LaTeX of every quantity, and its typed name.
fn names(exercise: &Exercise) -> printed::Names {
    let problem = exercise.problem();
    let named =
        problem.model().symbols.iter().map(|(symbol, entry)| (problem.math_of(symbol).latex(), entry.name.clone()));
    named.collect()
}

#[test]
fn each_sentence_of_algebra_is_true() {
    let renderer = Renderer::new(None).unwrap();
    let mut faults = Vec::new();
    for problem in variants::bank().into_iter().map(Arc::new) {
        for form in 0..problem.forms().len() {
            let name = variants::form_name(&problem, form);
            // Most variants of a form share their lines.
            let mut seen = BTreeSet::new();
            for seed in 1..=variants::seeds(50) {
                let exercise = Exercise::draw(&problem, form, seed).unwrap();
                let lines = lines_of(&exercise);
                let actual = values(&exercise);
                let found = if seen.insert(Value::Array(lines.clone()).to_string()) {
                    let page = page_of(&exercise, &renderer);
                    let page = page::faults(&page, &lines, &names(&exercise), &actual);
                    lines::faults(&lines, &actual).into_iter().chain(page).collect()
                } else {
                    lines::faults_of_numbers(&lines, &actual)
                };
                faults.extend(found.into_iter().map(|fault| format!("{name} seed {seed}: {fault}")));
            }
        }
    }
    let shown = faults.iter().take(40).cloned().collect::<Vec<_>>().join("\n");
    assert!(faults.is_empty(), "{} faults\n{shown}", faults.len());
}
