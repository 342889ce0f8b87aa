//! The page of promises names tests that are there.

use std::fs;
use std::path::Path;

const PAGE: &str = include_str!("../../../docs/trust.md");

/// The text of every source file below a folder.
fn sources(folder: &Path) -> String {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let text = |path: std::path::PathBuf| match path.extension() {
        _ if path.is_dir() => sources(&path),
        Some(ending) if ending == "rs" => fs::read_to_string(path).unwrap(),
        _ => String::new(),
    };
    entries.map(text).collect()
}

#[test]
fn every_promise_is_held_by_a_test_that_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources = ["src", "tests"].map(|folder| sources(&root.join(folder))).concat();
    let rows: Vec<Vec<&str>> = PAGE
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| promise"))
        .map(|line| line.split(" | ").collect())
        .collect();
    assert!(rows.len() > 10, "{rows:?}");
    for row in rows {
        assert_eq!(row.len(), 3, "{row:?}");
        let tests: Vec<&str> = row[2].split('`').skip(1).step_by(2).collect();
        assert!(!tests.is_empty(), "no test holds: {}", row[0]);
        for test in tests {
            assert!(is_test(&sources, test), "there is no test `{test}`");
        }
    }
}

/// Whether a function of that name stands below `#[test]`, other attributes in between.
fn is_test(sources: &str, name: &str) -> bool {
    let head = format!("fn {name}(");
    sources.match_indices(&head).any(|(place, _)| {
        let above = sources[..place].lines().rev().skip_while(|line| line.trim().is_empty());
        above.take_while(|line| line.trim_start().starts_with("#[")).any(|line| line.trim() == "#[test]")
    })
}
