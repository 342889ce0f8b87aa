//! Small scenes off the usual path, each worked by hand and by stepping Newton's laws: they are solved with these numbers and every
//! promise of `check` holds, or they are refused by name.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::thread;

use assert_cmd::Command;
use serde_json::Value;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/hand")
}

/// Each scene with its outcome: `name = answer; answer`, or `name refused: words of the refusal`.
fn rows() -> Vec<(String, String)> {
    let text = fs::read_to_string(folder().join("outcomes.txt")).unwrap();
    let row = |line: &str| line.split_once(' ').map(|(name, outcome)| (name.to_owned(), outcome.to_owned())).unwrap();
    text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).map(row).collect()
}

/// Exit code and output.
fn run(arguments: &[&str]) -> (i32, String) {
    let output = Command::cargo_bin("momentous").unwrap().args(arguments).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
}

fn answers(file: &str) -> String {
    let (_, solved) = run(&["solve", file, "--format", "json"]);
    let record: Value = serde_json::from_str(&solved).unwrap();
    let printed = |part: &Value| part["printed"].as_str().or(part["value"].as_str()).unwrap().to_owned();
    record["ask"].as_array().unwrap().iter().map(printed).collect::<Vec<_>>().join("; ").replace('\u{a0}', " ")
}

/// What becomes of a scene, where that is not its outcome.
fn differing((name, outcome): &(String, String)) -> Option<String> {
    let file = folder().join(format!("{name}.yaml")).display().to_string();
    let (code, said) = run(&["check", &file, "--seeds", "2"]);
    let said_now = if code == 0 { format!("= {}", answers(&file)) } else { said };
    let expected = match outcome.strip_prefix("refused: ") {
        Some(words) => code == 2 && said_now.contains(words),
        None => said_now == *outcome,
    };
    (!expected).then(|| format!("{name}: exit {code}, not {outcome}\n{said_now}"))
}

#[test]
fn each_scene_ends_as_worked_by_hand() {
    let rows = rows();
    let workers = thread::available_parallelism().map_or(1, usize::from);
    let differing: Vec<String> = thread::scope(|scope| {
        let shares = rows.chunks(rows.len().div_ceil(workers));
        let running: Vec<_> =
            shares.map(|share| scope.spawn(|| share.iter().filter_map(differing).collect::<Vec<_>>())).collect();
        running.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    assert!(differing.is_empty(), "\n{}", differing.join("\n"));
}

#[test]
fn every_scene_has_a_row() {
    let files = fs::read_dir(folder()).unwrap().map(|file| file.unwrap().path());
    let scenes = files.filter(|path| path.extension().is_some_and(|extension| extension == "yaml"));
    let scenes: BTreeSet<String> = scenes.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    let named: BTreeSet<String> = rows().into_iter().map(|(name, _)| name).collect();
    assert_eq!(scenes, named);
}
