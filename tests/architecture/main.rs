//! The rules of the house: which room may build on which, which room alone knows an outside package, how long a file may
//! grow, and that no files of a room need each other. `docs/architecture.md` says why.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::path::Path;

mod cycles;
mod reading;
mod silence;
mod words;

/// The rooms from left to right: each is a member of the workspace, but for `cli`, which is the program itself. Cargo refuses
/// circles; this order is the one that `docs/architecture.md` explains. A room builds on rooms before its own place.
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
    &["render", "work"],
    &["exercise"],
    &["bank"],
    &["course", "export", "pages"],
    &["browser", "store", "web"],
    &["course_pages"],
    &["cli"],
    &["python"],
];

/// Rooms that see less than their place allows: a simulation that shared code with the laws could not check them.
const NARROW: &[(&str, &[&str])] = &[("simulate", &["fault", "quantity", "expr", "scene"])];

/// Outside packages that few rooms know, so that they can be exchanged there.
const PACKAGES: &[(&str, &[&str])] = &[
    ("tera", &["render"]),
    ("pulldown-cmark", &["render"]),
    ("math-core", &["render"]),
    ("typst", &["render"]),
    ("typst-layout", &["render"]),
    ("typst-pdf", &["render"]),
    ("clap", &["cli"]),
    ("clap_complete", &["cli"]),
    ("resvg", &["cli"]),
    ("sqlx", &["store"]),
    ("jiff", &["course", "web"]),
    ("axum", &["web", "course_pages"]),
    ("prometheus-client", &["web"]),
    ("rapier2d-f64", &["simulate"]),
    ("zip", &["export"]),
    ("pyo3", &["python"]),
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
fn every_room_builds_only_on_what_stands_before_it() {
    let broken: Vec<String> = rooms().iter().flat_map(|room| order_rules(room, &manifest(room))).collect();
    assert!(broken.is_empty(), "\n{}\nThe order is {}.\n", broken.join("\n"), order());
}

#[test]
fn outside_packages_stay_in_their_rooms() {
    let broken: Vec<String> = rooms().iter().flat_map(|room| package_rules(room, &manifest(room))).collect();
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

#[test]
fn every_file_is_short_and_opens_with_what_it_is() {
    let found = violations(&["src", "tests", "benches"], shape_rules);
    assert!(found.is_empty(), "\n{}\n", listed(&found));
}

#[test]
fn every_room_has_a_place_in_the_order() {
    let placed: BTreeSet<String> = ORDER.concat().into_iter().map(str::to_owned).collect();
    assert_eq!(rooms(), placed);
}

#[test]
fn the_page_on_architecture_says_the_same_order() {
    let page = fs::read_to_string(package().join("docs/architecture.md")).expect("docs/architecture.md is there");
    assert!(page.contains(&order()), "docs/architecture.md: does not say the order {}", order());
    for room in ORDER.concat() {
        assert!(page.contains(&format!("\n| `{room}` |")), "docs/architecture.md: the table of rooms has no `{room}`");
    }
}

/// The folders under `src`.
fn rooms() -> BTreeSet<String> {
    let folders = fs::read_dir(package().join("src")).unwrap_or_else(|error| panic!("src: {error}")).flatten();
    folders
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect()
}

/// The manifest of a room; that of `cli` is the workspace's.
fn manifest(room: &str) -> String {
    let folder = if room == "cli" { package().to_owned() } else { package().join("src").join(room) };
    let file = folder.join("Cargo.toml");
    fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// The packages that a manifest lists under `[dependencies]`.
fn dependencies(manifest: &str) -> Vec<&str> {
    let section = manifest.lines().skip_while(|line| *line != "[dependencies]").skip(1);
    let lines = section.take_while(|line| !line.starts_with('['));
    lines.filter_map(|line| line.split(['.', ' ', '=']).next()).filter(|name| !name.is_empty()).collect()
}

/// The rooms on which this one builds, against the order.
fn order_rules(room: &str, manifest: &str) -> Vec<String> {
    let others = dependencies(manifest).into_iter().filter_map(|name| name.strip_prefix("momentous-"));
    let others = others.map(|name| name.replace('-', "_"));
    others.filter_map(|other| room_rule(room, &other).map(|rule| format!("src/{room}/Cargo.toml: {rule}"))).collect()
}

/// The fault where `room` builds on `other`.
fn room_rule(room: &str, other: &str) -> Option<String> {
    let (Some(place), Some(before)) = (place(room), place(other)) else {
        return Some(format!("`{other}` is not a room"));
    };
    if place == before {
        return Some(format!("{room} may not build on {other}, which stands beside it"));
    }
    if place < before {
        return Some(format!("{room} may not build on {other}, which comes after it"));
    }
    let narrow = NARROW.iter().find(|(narrow, _)| *narrow == room).map(|(_, allowed)| *allowed);
    narrow
        .filter(|allowed| !allowed.contains(&other))
        .map(|allowed| format!("{room} may not build on {other}: it sees only {}", allowed.join(", ")))
}

/// Outside packages are listed by their own rooms only.
fn package_rules(room: &str, manifest: &str) -> Vec<String> {
    let strangers = dependencies(manifest).into_iter().filter_map(|name| {
        let (package, owners) = PACKAGES.iter().find(|(package, _)| *package == name)?;
        (!owners.contains(&room))
            .then(|| format!("src/{room}/Cargo.toml: only {} knows {package}", owners.join(" and ")))
    });
    strangers.collect()
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
    fn catch_a_room_against_the_order() {
        for (room, other, rule) in [
            ("solve", "model", "solve may not build on model, which comes after it"),
            ("figure", "simulate", "figure may not build on simulate, which stands beside it"),
            ("simulate", "laws", "simulate may not build on laws: it sees only fault, quantity, expr, scene"),
            ("problem", "cellar", "`cellar` is not a room"),
        ] {
            let manifest = format!("[dependencies]\nmomentous-{other}.workspace = true\n\n[lints]\nworkspace = true\n");
            assert_eq!(order_rules(room, &manifest), [format!("src/{room}/Cargo.toml: {rule}")]);
        }
        let lawful = "[package]\nname = \"momentous-laws\"\n\n[dependencies]\nmomentous-expr.workspace = true\n\n[dev-dependencies]\nmomentous-bank.workspace = true\n";
        assert_eq!(order_rules("laws", lawful), [""; 0]);
    }

    #[test]
    fn keep_packages_in_their_rooms() {
        let manifest = "[dependencies]\ntera.workspace = true\nclap = { workspace = true, optional = true }\n";
        assert_eq!(
            package_rules("bank", manifest),
            ["src/bank/Cargo.toml: only render knows tera", "src/bank/Cargo.toml: only cli knows clap"]
        );
        assert_eq!(package_rules("render", "[dependencies]\ntera.workspace = true\n"), [""; 0]);
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
