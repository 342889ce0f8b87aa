//! What the tests of whole problems share: the bank, problems written in a test, and their variants.

#![allow(dead_code, reason = "each test takes what it needs")]

pub mod truth;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use momentous::expr::Symbol;
use momentous::fault::Source;
use momentous::problem::{Problem, Sampler, Variant, Worked, compile, load};
use momentous::quantity::{Decimal, Quantity, Rational, Unit};
use momentous::solve::Bounded;

/// Every problem of the bank, in the order of their paths.
pub fn bank() -> Vec<Problem> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("problem_bank")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path: PathBuf = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "yaml") {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(files.len() >= 14, "the bank has only {} problems", files.len());
    files.iter().map(|path| problem(&path.display().to_string(), &fs::read_to_string(path).unwrap())).collect()
}

/// A problem of the bank.
pub fn bank_problem(id: &str) -> Problem {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("problem_bank").join(id).with_extension("yaml");
    problem(id, &fs::read_to_string(&path).unwrap())
}

/// A compiled problem.
pub fn problem(name: &str, text: &str) -> Problem {
    read(name, text).unwrap_or_else(|faults| panic!("{faults}\n{text}"))
}

/// A compiled problem, or what its author is told.
pub fn read(name: &str, text: &str) -> Result<Problem, String> {
    load(Source::new(name, text)).and_then(|loaded| compile(loaded, None)).map_err(|faults| faults.to_string())
}

/// How many seeds of each form are looked at: `MOMENTOUS_SEEDS`, or a number that takes seconds.
pub fn seeds(usual: u64) -> u64 {
    std::env::var("MOMENTOUS_SEEDS").map_or(usual, |text| text.parse().expect("MOMENTOUS_SEEDS is a whole number"))
}

/// The name of a form.
pub fn form_name(problem: &Problem, form: usize) -> String {
    let name = problem.forms()[form].question.name.clone().unwrap_or_default();
    format!("{} {name}", problem.id())
}

/// A problem file: a scene in block style, what is given and what is asked, and a text that prints what is given.
pub fn sheet(scene: &str, given: &[(&str, &str)], ask: &[&str]) -> String {
    let lines = |list: Vec<String>| list.concat();
    let indented = lines(scene.trim_matches('\n').lines().map(|line| format!("  {line}\n")).collect());
    let values = lines(given.iter().map(|(name, value)| format!("  {name}: {value}\n")).collect());
    let text = lines(given.iter().map(|(name, _)| format!("{{{{ {name} }}}} ")).collect());
    let questions = lines(ask.iter().map(|find| format!("  - {{ find: \"{find}\" }}\n")).collect());
    format!(
        "id: test/sheet\ntitle: A sheet\nlevel: core\nscene:\n{indented}given:\n{values}text: '{text}'\nask:\n{questions}"
    )
}

/// A problem with fixed values and one form, solved.
pub fn solved(text: &str) -> (Problem, Variant) {
    let problem = problem("test.yaml", text);
    let variant = Sampler::new(&problem, 0).unwrap().variant(1).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
    (problem, variant)
}

/// What a variant says of a name, in base units.
pub fn value(problem: &Problem, variant: &Variant, name: &str) -> Bounded {
    let symbol = problem.model().symbol_of(name).unwrap_or_else(|| panic!("{} knows no `{name}`", problem.id()));
    variant.value(symbol).unwrap_or_else(|| panic!("{} does not find `{name}`", problem.id()))
}

/// The same, where it is known.
pub fn value_if_known(problem: &Problem, variant: &Variant, name: &str) -> Option<Bounded> {
    variant.value(problem.model().symbol_of(name)?)
}

/// The answers in the units in which they are asked, by part.
pub fn answers(problem: &Problem, variant: &Variant) -> BTreeMap<String, Bounded> {
    let worked = Worked::new(problem, variant).unwrap();
    let number = |part: &momentous::problem::Part| match &part.kind {
        momentous::problem::PartKind::Number(number) => Some((part.id.clone(), worked.answer(number))),
        _ => None,
    };
    worked.form.parts.iter().filter_map(number).collect()
}

/// A value that replaces a drawn one: symbol, number, unit.
pub fn instead(problem: &Problem, name: &str, quantity: &str) -> (Symbol, Decimal, Unit) {
    let quantity = Quantity::parse(quantity).unwrap();
    (problem.model().symbol_of(name).unwrap(), quantity.value, quantity.unit)
}

/// The exact value of a given in base units; angles are not rational.
pub fn rational(problem: &Problem, variant: &Variant, name: &str) -> Rational {
    let symbol = problem.model().symbol_of(name).unwrap();
    let (value, unit) = variant.given(symbol).unwrap_or_else(|| panic!("`{name}` is not given"));
    assert_eq!(unit.factor().pi, 0);
    value.to_rational() * unit.factor().rational
}
