//! What a symbol stands for and why something holds are data until they are written: logic reads no names and no sentences.
//! Every kind of stage is told apart by the compiler.

use std::collections::BTreeSet;
use std::fs;

use super::{Source, Violation, listed, package, sources};

/// Rooms that reason about scenes.
const ROOMS: &[&str] = &["src/model", "src/explain", "src/problem"];

/// Looks into a text. A method with a literal or a closure is one on text; on a slice it has neither.
const LOOKS: &[&str] =
    &["starts_with(", "ends_with(", "strip_prefix(", "strip_suffix(", ".contains(", ".replace(", ".replacen("];

/// Files that may look into texts, and what these are.
const READERS: &[(&str, &str)] = &[
    ("src/model/name.rs", "names as authors write them"),
    ("src/model/quantity_kind.rs", "names as authors write them"),
    ("src/model/check.rs", "names of bodies as authors choose them"),
    ("src/model/frame.rs", "directions as authors write them"),
    ("src/model/directions.rs", "directions as authors write them"),
    ("src/model/stage/tow.rs", "terms as authors write them"),
    ("src/problem/reading/check.rs", "conditions as authors write them"),
    ("src/problem/questions/choices/impulsive.rs", "forces as authors call them"),
    ("src/problem/reading/document.rs", "YAML"),
    ("src/problem/language/given.rs", "values as authors write them"),
    ("src/problem/language/literal.rs", "values as authors write them"),
    ("src/problem/reading/digest.rs", "line ends of files"),
    ("src/problem/reading/numerals.rs", "numbers in authors' texts"),
    ("src/problem/questions/number.rs", "questions as authors write them"),
    ("src/problem/language/rubric.rs", "marks as authors write them"),
    ("src/problem/sampling/say.rs", "what stands before a placeholder in an author's text; printed numbers"),
    ("src/problem/reading/shape.rs", "JSON Schema"),
    ("src/problem/language/text.rs", "placeholders in authors' texts"),
    ("src/explain/terms/display.rs", "printed numbers"),
    ("src/explain/lines.rs", "printed numbers, as they are typed"),
    ("src/explain/terms/numbers.rs", "printed numbers"),
];

/// More kinds of stage than this are named only by files that know every kind, as `CONTRIBUTING.md` lists them.
const KNOW_EVERY_STAGE: usize = 20;

#[test]
fn logic_reads_no_names_and_no_sentences() {
    let sources = sources(ROOMS);
    let readers: Vec<&str> = READERS.iter().map(|(file, _)| *file).collect();
    let found: Vec<Violation> =
        sources.iter().filter(|source| !readers.contains(&source.file.as_str())).flat_map(looks).collect();
    assert!(found.is_empty(), "\n{}\nMatch an enum, or read it where authors' text is parsed.\n", listed(&found));
    for (file, what) in READERS {
        let is_used = sources.iter().any(|source| source.file == *file && !looks(source).is_empty());
        assert!(is_used, "{file} does not read {what}: take it from the list");
    }
}

#[test]
fn no_match_over_stages_has_a_wildcard() {
    let found: Vec<Violation> = sources(&["src"]).iter().flat_map(wildcards).collect();
    assert!(found.is_empty(), "\n{}\n", listed(&found));
}

#[test]
fn the_guide_lists_what_a_kind_of_stage_touches() {
    let guide = guide("## Adding a kind of stage");
    for source in sources(&["src"]) {
        let knows_every = stages_of(&source.text).len() > KNOW_EVERY_STAGE;
        assert_eq!(knows_every, lists(&guide, &source), "CONTRIBUTING.md and {}", source.file);
    }
}

#[test]
fn the_guide_lists_what_a_type_of_answer_touches() {
    let guide = guide("## Adding a type of answer");
    let asked = ["PartKind::Number", "PartKind::Vector", "PartKind::Formula", "PartKind::Range", "PartKind::Choice"];
    let expected = ["Number", "Vector", "Formula", "Interval", "Choice"].map(|kind| format!("ExpectedKind::{kind}"));
    for source in sources(&["src"]) {
        let knows_every = asked.iter().all(|name| source.text.contains(name))
            || expected.iter().all(|name| source.text.contains(name));
        assert_eq!(knows_every, lists(&guide, &source), "CONTRIBUTING.md and {}", source.file);
    }
}

/// A section of CONTRIBUTING.md.
fn guide(heading: &str) -> String {
    let page = fs::read_to_string(package().join("CONTRIBUTING.md"))
        .unwrap_or_else(|error| panic!("CONTRIBUTING.md: {error}"));
    let (_, section) = page.split_once(heading).unwrap_or_else(|| panic!("CONTRIBUTING.md has no section {heading}"));
    section.split("\n## ").next().unwrap_or_default().to_owned()
}

fn lists(guide: &str, source: &Source) -> bool {
    guide.contains(&format!("\n- `{}`", source.file))
}

#[test]
fn the_guides_name_files_that_exist() {
    let of_the_tree =
        |word: &&str| ["src/", "tests/", "templates/", "benches/"].iter().any(|top| word.starts_with(top));
    for page in ["CONTRIBUTING.md", "docs/architecture.md"] {
        let text = fs::read_to_string(package().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"));
        let named: Vec<&str> = text.split('`').skip(1).step_by(2).filter(of_the_tree).collect();
        assert!(!named.is_empty(), "{page} names no files");
        for file in named.into_iter().filter(|file| !file.contains(['<', '*', ' '])) {
            assert!(package().join(file).exists(), "{page} names {file}, which is not there");
        }
    }
}

/// The kinds of stage that a file names.
fn stages_of(text: &str) -> BTreeSet<&str> {
    let mentioned = text.split("Stage::").skip(1).filter_map(|rest| rest.split_once('(')).map(|(name, _)| name);
    mentioned.filter(|name| name.chars().all(char::is_alphanumeric)).collect()
}

/// Where a file looks into a text, its tests left out.
fn looks(source: &Source) -> Vec<Violation> {
    let code = source.text.split("#[cfg(test)]").next().unwrap_or_default();
    let is_on_text = |line: &str, look: &str| {
        let mut calls = line.match_indices(look).map(|(at, _)| &line[at + look.len()..]);
        calls.any(|argument| match look {
            ".contains(" => argument.starts_with('"'),
            _ => argument.starts_with(['"', '\'', '|', '[']) || argument.starts_with("char::"),
        })
    };
    let lines = code.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"));
    let reads = lines.filter(|(_, line)| LOOKS.iter().any(|look| is_on_text(line, look)));
    let violation = |(at, line): (usize, &str)| Violation {
        file: source.file.clone(),
        line: at + 1,
        rule: format!("looks into a text: {}", line.trim()),
    };
    reads.map(violation).collect()
}

/// Wildcards of matches over stages, as `rustfmt` indents them.
fn wildcards(source: &Source) -> Vec<Violation> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let lines: Vec<&str> = source.text.lines().collect();
    let mut found = Vec::new();
    for (at, line) in lines.iter().enumerate().filter(|(_, line)| line.contains("match ") && line.ends_with('{')) {
        let body = lines[at + 1..].iter().take_while(|below| below.is_empty() || indent(below) > indent(line));
        let arms = body.enumerate().filter(|(_, line_below)| indent(line_below) == indent(line) + 4);
        let arms: Vec<(usize, &str)> = arms.map(|(below, arm)| (at + 2 + below, arm.trim_start())).collect();
        let of_stage = |(_, arm): &(usize, &str)| arm.starts_with("Stage::") || arm.starts_with("Some(Stage::");
        // A name alone takes everything, too.
        let takes_all = |arm: &str| {
            let pattern = arm.split(" =>").next().unwrap_or_default();
            let inner = pattern.strip_prefix("Some(").map_or(pattern, |inner| inner.trim_end_matches(')'));
            inner.chars().all(|c| c.is_ascii_lowercase() || c == '_')
        };
        let wild = arms.iter().find(|(_, arm)| arm.contains(" =>") && takes_all(arm));
        if let (true, Some((line, _))) = (arms.iter().any(of_stage), wild) {
            let rule = "a match over stages has a wildcard: list the others, or ask with `if let`".to_owned();
            found.push(Violation { file: source.file.clone(), line: *line, rule });
        }
    }
    found
}

#[test]
fn breaking_the_rules_is_noticed() {
    let source = |text: &str| Source { file: "src/model/a.rs".into(), text: text.into() };
    let read = looks(&source(
        "fn f() {\n    name.starts_with(\"v_\");\n    names.starts_with(&[a]);\n    map.contains(key);\n}",
    ));
    assert_eq!(read.iter().map(|wildcard| wildcard.line).collect::<Vec<_>>(), [2]);
    let lines = |text: &str| wildcards(&source(text)).iter().map(|wildcard| wildcard.line).collect::<Vec<_>>();
    assert_eq!(lines("match stage {\n    Stage::Fall(_) => 1,\n    _ => 2,\n}\nmatch a {\n    _ => 3,\n}"), [3]);
    assert_eq!(lines("match stage {\n    Stage::Fall(_) => 1,\n    stage => 2,\n}"), [3]);
}
