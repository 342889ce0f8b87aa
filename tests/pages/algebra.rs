//! Each sentence of algebra in a worked solution is true: it is applied literally to the equations that it names, and what
//! comes out is compared with what is printed.

#![allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "what is printed has few digits")]

mod lines;
mod page;
mod points;
mod printed;
mod term;
mod typed;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::problem::Problem;
use momentous::render::Format;
use momentous::render::Renderer;
use momentous::render::Solution;
use serde_json::Value;
use term::Values;

use crate::variants;

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
    let outline = exercise.outline(audience, Detail::Full);
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

/// What is not true in the solutions of a problem.
fn faults(problem: &Arc<Problem>, seeds: u64, renderer: &Renderer) -> Vec<String> {
    let mut faults = Vec::new();
    for form in 0..problem.forms().len() {
        let name = variants::form_name(problem, form);
        // Most variants of a form share their lines.
        let mut seen = BTreeSet::new();
        for seed in 1..=seeds {
            let Ok(exercise) = Exercise::draw(problem, form, seed) else { continue };
            let lines = lines_of(&exercise);
            let actual = values(&exercise);
            let found = if seen.insert(Value::Array(lines.clone()).to_string()) {
                let page = page_of(&exercise, renderer);
                let page = page::faults(&page, &lines, &names(&exercise), &actual);
                lines::faults(&lines, &actual).into_iter().chain(page).collect()
            } else {
                lines::faults_of_numbers(&lines, &actual)
            };
            faults.extend(found.into_iter().map(|fault| format!("{name} seed {seed}: {fault}")));
        }
    }
    faults
}

fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults[..faults.len().min(40)].join("\n"));
}

#[test]
fn each_sentence_of_algebra_is_true() {
    let renderer = Renderer::new(None).unwrap();
    let seeds = variants::seeds(50);
    let faults: Vec<String> =
        variants::bank().into_iter().flat_map(|problem| faults(&Arc::new(problem), seeds, &renderer)).collect();
    assert_none(&faults);
}

/// Problems that are not in the bank take other ways: systems that it has not, and equations without a formula.
#[test]
fn each_sentence_is_true_in_problems_of_others() {
    let renderer = Renderer::new(None).unwrap();
    let mut read = 0;
    let mut found = Vec::new();
    for folder in ["exercises", "reference", "problems", "pictures", "found"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures").join(folder);
        let mut files: Vec<PathBuf> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            let Ok(problem) = variants::read(&file.display().to_string(), &text) else { continue };
            read += 1;
            found.extend(faults(&Arc::new(problem), 3, &renderer));
        }
    }
    assert!(read > 100, "{read} problems were read");
    assert_none(&found);
}

#[test]
fn what_may_be_anything_stays_a_letter_and_cancels() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/pictures/any_mass.yaml"));
    let text = text.unwrap().replace("{ min: 0.3, max: 0.9, step: 0.05 }", "0.5");
    let exercise = Exercise::draw(&Arc::new(variants::problem("test.yaml", &text)), 0, 1).unwrap();
    let page = page_of(&exercise, &Renderer::new(None).unwrap());
    // By hand, with B twice as heavy: v_B2 = (1 + e)/3 v_A1 and v_A2 = (1 - 2 e)/3 v_A1, which is nothing.
    assert!(page.contains(r"=0.500\,v_{A1}") && page.contains("Here $m_{A}$ cancels."), "{page}");
    assert!(page.contains(r"=\frac{m_{A}\,v_{A1} + m_{A}\,(0.5)\,v_{A1}}{2\,m_{A} + m_{A}}"), "{page}");
    assert!(!page.contains(r"(0\text{ m/s})"), "{page}");
}

#[test]
fn a_gain_of_energy_is_not_called_a_loss() {
    let scene = "axes: { x: right }\nbodies:\n  A: { name: cart A }\n  B: { name: cart B }\nstages:\n  - impact: { between: [A, B] }";
    let masses = [("m_A", "1 kg"), ("m_B", "1 kg"), ("v_A1", "1.5 m/s"), ("v_B1", "0 m/s")];
    let page = |after: &str, allow: &str| {
        let given: Vec<(&str, &str)> = masses.into_iter().chain([("v_A2", after)]).collect();
        let text = variants::sheet(scene, &given, &["v_B2", "T_lost"]) + allow;
        let exercise = Exercise::draw(&Arc::new(variants::problem("test.yaml", &text)), 0, 1).unwrap();
        page_of(&exercise, &Renderer::new(None).unwrap())
    };
    // By hand: T_1 = 1.125 J; with v_A2 = -1 m/s, v_B2 = 2.5 m/s and T_2 = 3.625 J; with 0.5 m/s, 1 m/s and 0.625 J.
    let gained = page("-1.0 m/s", "allow: [energy-created]\n");
    assert!(gained.contains("is gained") && gained.contains("-2.50") && !gained.contains("not negative"), "{gained}");
    let lost = page("0.5 m/s", "");
    assert!(lost.contains("not negative") && !lost.contains("is gained"), "{lost}");
}
