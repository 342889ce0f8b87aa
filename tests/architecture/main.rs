//! The rules of the house, read from the source as text: which room may import which, which room alone knows an outside
//! package, how long a file may grow, and that no files of a room need each other. `docs/architecture.md` says why.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::path::Path;

use words::{code_of, mentions};

mod cycles;
mod reading;
mod silence;
mod words;

/// The rooms from left to right. A room imports what stands before its own place; rooms of one place never each other.
const ORDER: &[&[&str]] = &[
    &["fault"],
    &["quantity"],
    &["expr"],
    &["solve"],
    &["scene"],
    &["laws"],
    &["model"],
    &["problem"],
    &["figure", "simulate"],
    &["explain", "grade", "witness"],
    &["render"],
    &["exercise"],
    &["bank"],
    &["course", "export"],
    &["store"],
    &["web"],
    &["cli"],
];

/// Rooms that see less than their place allows: a simulation that shared code with the laws could not check them.
const NARROW: &[(&str, &[&str])] = &[("simulate", &["fault", "quantity", "expr", "scene"])];

/// Outside packages that one room alone knows, so that they can be exchanged there.
const PACKAGES: &[(&str, &str)] = &[
    ("base64", "render"),
    ("tera", "render"),
    ("pulldown_cmark", "render"),
    ("math_core", "render"),
    ("typst", "render"),
    ("typst_layout", "render"),
    ("typst_pdf", "render"),
    ("clap", "cli"),
    ("clap_complete", "cli"),
    ("resvg", "cli"),
    ("sqlx", "store"),
    ("jiff", "course"),
    ("axum", "web"),
    ("prometheus_client", "web"),
    ("rapier2d_f64", "simulate"),
    ("zip", "export"),
];

/// The lines that a file may have.
const LONGEST: usize = 400;

/// A file of Rust, named by its path from the package's folder, with `/`.
struct Source {
    file: String,
    text: String,
}

/// A rule that a line breaks.
#[derive(Debug, PartialEq, Eq)]
struct Violation {
    file: String,
    line: usize,
    rule: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{}: {}", self.file, self.line, self.rule)
    }
}

#[test]
fn every_room_imports_only_what_stands_before_it() {
    let found = violations(&["src"], import_rules);
    assert!(found.is_empty(), "\n{}\nThe order is {}.\n", listed(&found), order());
}

#[test]
fn outside_packages_stay_in_their_rooms() {
    let found = violations(&["src"], package_rules);
    assert!(found.is_empty(), "\n{}\n", listed(&found));
}

#[test]
fn every_file_is_short_and_opens_with_what_it_is() {
    let found = violations(&["src", "tests", "benches"], shape_rules);
    assert!(found.is_empty(), "\n{}\n", listed(&found));
}

#[test]
fn every_room_has_a_place_in_the_order_and_is_declared() {
    let sources = sources(&["src"]);
    let rooms: BTreeSet<&str> = sources.iter().filter_map(|source| room_of(&source.file)).collect();
    assert!(rooms.contains("fault") && rooms.contains("solve"), "src was not read: found only {rooms:?}");
    let root = sources.iter().find(|source| source.file == "src/lib.rs").expect("src/lib.rs is there");
    let declared = code_of(&root.text);
    for room in rooms {
        assert!(place(room).is_some(), "src/{room} has no place in the order {}", order());
        assert!(declared.contains(&format!("pub mod {room};")), "src/lib.rs: does not declare `pub mod {room};`");
    }
}

#[test]
fn the_page_on_architecture_says_the_same_order() {
    let page = fs::read_to_string(package().join("docs/architecture.md")).expect("docs/architecture.md is there");
    assert!(page.contains(&order()), "docs/architecture.md: does not say the order {}", order());
    for room in ORDER.concat() {
        assert!(page.contains(&format!("\n| `{room}` |")), "docs/architecture.md: the table of rooms has no `{room}`");
    }
}

/// The rules of importing: for a room its place in the order, for `main.rs` that it knows the command line only.
fn import_rules(source: &Source) -> Vec<Violation> {
    let mut found = Vec::new();
    for mention in mentions(&code_of(&source.text)) {
        let path: Vec<&str> = mention.path.iter().map(String::as_str).collect();
        let rule = match (room_of(&source.file), path.as_slice()) {
            (Some(_), ["crate"]) if mention.open => Some("write one `use crate::room::Name;` for each room".to_owned()),
            (Some(room), ["crate", other, ..]) => room_rule(room, other),
            (Some(_), ["super", ..]) => {
                let up = path.iter().take_while(|step| **step == "super").count();
                (up >= depth_of(&source.file) + mention.modules)
                    .then(|| "`super` leaves the room: write `crate::room::Name`".to_owned())
            }
            (None, ["momentous", other, ..]) if *other != "cli" => Some(format!("main.rs knows only cli, not {other}")),
            (None, ["momentous"]) if mention.open => {
                Some("main.rs knows only cli: write `momentous::cli::...`".to_owned())
            }
            (None, ["mod"]) if source.file == "src/main.rs" => {
                Some("main.rs declares no module: lib.rs does".to_owned())
            }
            _ => None,
        };
        found.extend(rule.map(|rule| Violation { file: source.file.clone(), line: mention.line, rule }));
    }
    found
}

/// What is wrong with `room` importing `other`.
fn room_rule(room: &str, other: &str) -> Option<String> {
    let (Some(own), Some(theirs)) = (place(room), place(other)) else {
        let stranger = if place(room).is_none() { room } else { other };
        return Some(format!("`{stranger}` is not a room"));
    };
    if room == other {
        return None;
    }
    if own == theirs {
        return Some(format!("{room} may not import {other}, which stands beside it"));
    }
    if own < theirs {
        return Some(format!("{room} may not import {other}, which comes after it"));
    }
    let narrow = NARROW.iter().find(|(narrow, _)| *narrow == room).map(|(_, allowed)| *allowed);
    narrow
        .filter(|allowed| !allowed.contains(&other))
        .map(|allowed| format!("{room} may not import {other}: it sees only {}", allowed.join(", ")))
}

/// Outside packages are named in their own rooms only.
fn package_rules(source: &Source) -> Vec<Violation> {
    let mut found = Vec::new();
    for mention in mentions(&code_of(&source.text)) {
        let Some(first) = mention.path.first() else { continue };
        let leads = mention.path.len() > 1 || mention.open || mention.used;
        let owner = PACKAGES.iter().find(|(package, _)| package == first).map(|(_, owner)| *owner);
        if let Some(owner) = owner.filter(|owner| leads && room_of(&source.file) != Some(owner)) {
            let rule = format!("only {owner} knows {first}");
            found.push(Violation { file: source.file.clone(), line: mention.line, rule });
        }
    }
    found
}

/// A file opens with a line that says what it is, and ends while it is still one idea.
fn shape_rules(source: &Source) -> Vec<Violation> {
    let mut found = Vec::new();
    let mut broken = |line, rule: String| found.push(Violation { file: source.file.clone(), line, rule });
    if !source.text.starts_with("//!") {
        broken(1, "a file opens with a `//!` line that says what it is".to_owned());
    }
    let lines = source.text.lines().count();
    if lines > LONGEST {
        broken(
            LONGEST + 1,
            format!("a file has at most {LONGEST} lines, this one {lines}: which two ideas are in it?"),
        );
    }
    found
}

/// The room that a file belongs to; `None` for the crate roots.
fn room_of(file: &str) -> Option<&str> {
    let inside = file.strip_prefix("src/")?;
    let first = inside.split('/').next()?;
    (!["lib.rs", "main.rs"].contains(&inside)).then(|| first.trim_end_matches(".rs"))
}

/// How many modules a file lies within, its own counted: 1 for `src/solve/mod.rs`, 2 for `src/solve/plan.rs`.
fn depth_of(file: &str) -> usize {
    file.split('/').count() - 1 - usize::from(file.ends_with("/mod.rs"))
}

fn place(room: &str) -> Option<usize> {
    ORDER.iter().position(|rooms| rooms.contains(&room))
}

fn order() -> String {
    ORDER.iter().map(|rooms| rooms.join(", ")).collect::<Vec<_>>().join(" < ")
}

fn package() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn violations(folders: &[&str], rules: fn(&Source) -> Vec<Violation>) -> Vec<Violation> {
    sources(folders).iter().flat_map(rules).collect()
}

fn listed(found: &[Violation]) -> String {
    found.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// The Rust files under these folders of the package, in the order of their names.
fn sources(folders: &[&str]) -> Vec<Source> {
    let mut found = Vec::new();
    let mut waiting: Vec<String> = folders.iter().map(ToString::to_string).collect();
    while let Some(folder) = waiting.pop() {
        let Ok(entries) = fs::read_dir(package().join(&folder)) else { continue };
        for entry in entries.flatten() {
            let file = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                waiting.push(file);
            } else if entry.path().extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(entry.path()).unwrap_or_else(|error| panic!("{file}: {error}"));
                found.push(Source { file, text });
            }
        }
    }
    found.sort_by(|left, right| left.file.cmp(&right.file));
    found
}

/// The rules themselves, on texts that break them.
mod the_rules {
    use super::*;

    fn broken(rules: fn(&Source) -> Vec<Violation>, file: &str, text: &str) -> Vec<String> {
        rules(&Source { file: file.to_owned(), text: text.to_owned() }).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn catch_an_import_against_the_order() {
        for (file, text, expected) in [
            ("src/solve/plan.rs", "use crate::model::Model;", "1: solve may not import model, which comes after it"),
            (
                "src/fault/mod.rs",
                "//! A\n\nfn f() -> crate::expr::Expr {}",
                "3: fault may not import expr, which comes after it",
            ),
            (
                "src/figure/svg.rs",
                "use crate::simulate::Run;",
                "1: figure may not import simulate, which stands beside it",
            ),
            (
                "src/simulate/event.rs",
                "use crate::laws;",
                "1: simulate may not import laws: it sees only fault, quantity, expr, scene",
            ),
            (
                "src/cli/solve.rs",
                "use crate::{expr::Expr, solve::Plan};",
                "1: write one `use crate::room::Name;` for each room",
            ),
            ("src/cli/solve.rs", "use crate::nowhere::Plan;", "1: `nowhere` is not a room"),
            ("src/cellar/wine.rs", "use crate::expr::Expr;", "1: `cellar` is not a room"),
            ("src/exercise.rs", "pub use super::bank;", "1: `super` leaves the room: write `crate::room::Name`"),
            (
                "src/solve/mod.rs",
                "mod a {\nuse super::super::cli;\n}",
                "2: `super` leaves the room: write `crate::room::Name`",
            ),
            ("src/main.rs", "use momentous::exercise;", "1: main.rs knows only cli, not exercise"),
            ("src/main.rs", "mod other;", "1: main.rs declares no module: lib.rs does"),
        ] {
            assert_eq!(broken(import_rules, file, text), [format!("{file}:{expected}")], "{text}");
        }
    }

    #[test]
    fn leave_lawful_imports_alone() {
        for (file, text) in [
            ("src/solve/plan.rs", "use crate::expr::{Expr, Symbol};\nuse super::System;\npub(crate) fn f() {}"),
            ("src/solve/tactics/tear.rs", "use crate::solve::Plan;\nuse super::super::Plan as Other;"),
            ("src/solve/mod.rs", "mod tests { mod inner { use super::super::Plan; } }"),
            (
                "src/model/name.rs",
                "/// See [`crate::cli::run`].\n// crate::cli\n/* crate::cli */ fn f<'a>() { g('\"', '\\'', \"\\\"crate::cli\", r#\"\"crate::cli\"#); }",
            ),
            ("src/lib.rs", "pub mod cli;\npub use crate::cli::run;"),
            ("src/main.rs", "fn main() -> std::process::ExitCode { momentous::cli::run(std::env::args_os()) }"),
            ("src/simulate/event.rs", "use crate::scene::Scene;"),
        ] {
            assert_eq!(broken(import_rules, file, text), [""; 0], "{text}");
        }
    }

    #[test]
    fn keep_packages_in_their_rooms() {
        let text = "use clap::Parser;\n#[derive(clap::Args)]\nuse tera as t;\nlet tera = crate::render::tera::Page;";
        let expected = [
            "src/bank/list.rs:1: only cli knows clap",
            "src/bank/list.rs:2: only cli knows clap",
            "src/bank/list.rs:3: only render knows tera",
        ];
        assert_eq!(broken(package_rules, "src/bank/list.rs", text), expected);
        assert_eq!(broken(package_rules, "src/render/page.rs", "use tera::Tera;"), [""; 0]);
    }

    #[test]
    fn measure_a_file() {
        let long = format!("//! Long.{}", "\n".repeat(LONGEST + 1));
        let expected = "tests/a.rs:401: a file has at most 400 lines, this one 401: which two ideas are in it?";
        assert_eq!(broken(shape_rules, "tests/a.rs", &long), [expected]);
        assert_eq!(broken(shape_rules, "tests/a.rs", "//! Short.\n"), [""; 0]);
        assert_eq!(
            broken(shape_rules, "tests/a.rs", "use a;\n"),
            ["tests/a.rs:1: a file opens with a `//!` line that says what it is"]
        );
    }
}
