//! The problems of the bank, as tests need them.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};

/// Every form of every problem of the bank at one seed, in the order of the files.
pub fn exercises(seed: u64) -> Vec<Exercise> {
    files().iter().flat_map(|file| forms(file, seed)).collect()
}

/// Every form of the problem in one file.
fn forms(file: &Path, seed: u64) -> Vec<Exercise> {
    let text = fs::read_to_string(file).unwrap();
    let loaded = load(Source::new(&file.display().to_string(), &text)).unwrap_or_else(|faults| panic!("{faults}"));
    let problem = Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}")));
    let draw =
        |form| Exercise::draw(&problem, form, seed).unwrap_or_else(|reason| panic!("{}: {reason}", problem.id()));
    (0..problem.forms().len()).map(draw).collect()
}

/// All files of the bank, in the order of their paths.
fn files() -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("problem_bank")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "yaml") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

/// The name of an exercise, fit for a file: `impact-two-carts-forward`.
pub fn name(exercise: &Exercise) -> String {
    let identity = exercise.identity();
    let name = identity.problem.replace('/', "-");
    identity.form.map_or(name.clone(), |form| format!("{name}-{form}"))
}
