//! Every problem of the bank loads, and stands where its identity says.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use momentous::fault::Source;
use momentous::problem::load;

#[test]
fn every_problem_of_the_bank_loads() {
    let bank = Path::new(env!("CARGO_MANIFEST_DIR")).join("problem_bank");
    let files = problem_files(&bank).unwrap();
    assert!(files.len() >= 16, "only {} problems in {}", files.len(), bank.display());
    let mut wrong = Vec::new();
    for file in &files {
        let place = file.strip_prefix(&bank).unwrap().with_extension("");
        let text = fs::read_to_string(file).unwrap();
        match load(Source::new(&file.display().to_string(), &text)) {
            Ok(loaded) => {
                let draft = &loaded.draft;
                let topic = draft.id.split('/').next().unwrap();
                let hints = loaded.questions.iter().map(|question| question.hints.len()).min().unwrap();
                if Path::new(&draft.id) != place {
                    wrong.push(format!("{} calls itself `{}`", file.display(), draft.id));
                }
                if hints < 2 {
                    wrong.push(format!("{} has fewer than two hints", draft.id));
                }
                if draft.tags.iter().all(|tag| tag != topic) {
                    wrong.push(format!("{} lacks its topic among its tags", draft.id));
                }
            }
            Err(faults) => wrong.push(faults.to_string()),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// All problem files under a folder, in the order of their paths.
fn problem_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "yaml") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}
