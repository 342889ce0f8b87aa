//! Rosters, submissions and responses as other systems and people's programs write them: cases by kind, each with what is made of it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Exercise, Item, ItemAnswers, Listed, SheetSeed, Sheets, SpoiltSeed, Student, Table};
use momentous::problem::{compile, load};

use crate::room::{Room, lines};

/// Each kind has at least so many cases.
const LEAST: usize = 10;

/// Before a part of what is said of responses.
const SAID: &str = "says: ";

/// A table, what follows `=>`, and the lines below it.
struct Case {
    kind: String,
    table: String,
    asked: String,
    expected: Vec<String>,
}

/// The cases of a file; blank lines part them, and `==` begins a kind.
fn cases(name: &str) -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/tables").join(name);
    let text = fs::read_to_string(path).unwrap();
    let mut cases: Vec<Case> = Vec::new();
    let mut kind = String::new();
    for block in text.split("\n\n").filter(|block| !block.starts_with('#')) {
        if let Some(title) = block.trim().strip_prefix("== ") {
            title.clone_into(&mut kind);
            continue;
        }
        let (table, found) = block.split_once("=>").unwrap_or_else(|| panic!("{block}"));
        let mut found = found.lines();
        let asked = found.next().unwrap().trim().to_owned();
        let table = table.replace('→', "\t").replace('□', "\u{200b}");
        cases.push(Case { kind: kind.clone(), table, asked, expected: found.map(str::to_owned).collect() });
    }
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for case in &cases {
        *kinds.entry(&case.kind).or_default() += 1;
    }
    assert!(kinds.len() >= 3 && kinds.values().all(|count| *count >= LEAST), "{kinds:?}");
    cases
}

#[test]
fn rosters_are_known_by_their_headings() {
    let mut differ = Vec::new();
    for case in cases("rosters.txt") {
        let read = Table::read(case.table.as_bytes()).map_err(|fault| vec![fault]).and_then(Student::listed);
        let (asked, found) = match read {
            Ok((students, known_by)) => {
                let name = if known_by.is_name { ", a name" } else { "" };
                let several = if known_by.is_one_of_several { ", one of several" } else { "" };
                (known_by.heading + several + name, students.iter().map(Student::shown).collect())
            }
            Err(faults) => ("refused".to_owned(), faults),
        };
        if (&asked, &found) != (&case.asked, &case.expected) {
            differ.push(format!("{}\n{}=> {asked}\n{}\n", case.kind, case.table, found.join("\n")));
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}

#[test]
fn tables_of_submissions_are_read_with_the_columns_that_others_add() {
    let room = Room::empty();
    let mut differ = Vec::new();
    for case in cases("submissions.txt") {
        fs::write(room.path("class.csv"), &case.table).unwrap();
        let decimal = if case.table.contains("-0,") { "comma" } else { "point" };
        let ran = room.run(&["grade", "class.csv", "--decimal", decimal, "-o", "marks.csv"]);
        let [marked, refused] = [case.asked.split(' ').next(), case.asked.split(' ').nth(2)].map(Option::unwrap);
        let right = room.read("marks.csv").matches(",right,").count();
        let is_told =
            ran.err.contains(&format!("{marked} marked (")) && ran.err.contains(&format!(", {refused} refused"));
        if !is_told || (right == 0) != (marked == "0") || !case.expected.iter().all(|part| ran.err.contains(part)) {
            differ.push(format!("{}\n{}=> {} right, {}", case.kind, case.table, right, ran.err));
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}

/// The variants whose codes stand for `[1]`, `[2]` and `[3]`.
fn variants() -> [Item; 3] {
    let source = Bank::built_in().find("impact/two-carts").unwrap().clone();
    let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
    [1, 2, 3].map(|seed| Exercise::draw(&problem, 0, seed).unwrap().item())
}

fn right(item: &Item, part: usize) -> String {
    let ItemAnswers::Number(number) = &item.parts[part].answers else { panic!("part {part} is no number") };
    format!("{:.*e}", number.figures - 1, number.right)
}

/// A table with the codes and the responses in the place of what stands for them.
fn filled(table: &str, items: &[Item]) -> String {
    let mut text = table.to_owned();
    for (number, item) in (1..).zip(items) {
        let [first, second, third] = [0, 1, 2].map(|part| right(item, part));
        for (part, value) in [(1, &first), (2, &second), (3, &third)] {
            text = text.replace(&format!("R{number}.{part}"), value);
        }
        let whole = |parts: [&str; 3]| format!("part 1: {}; part 2: {}; part 3: {}", parts[0], parts[1], parts[2]);
        text = text.replace(&format!("R{number}"), &whole([&first, &second, &third]));
        text = text.replace(&format!("H{number}"), &whole([&first, "3e3", "7e7"]));
        text = text.replace(&format!("Z{number}"), &whole(["9e9", "3e3", "7e7"]));
        text = text.replace(&format!("[{number}]"), &format!("[{}]", item.code));
        text = text.replace(&format!("[{number}-"), &format!("[{}-", item.code));
    }
    text
}

/// Words as a shell parts them.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    let words = parts.flat_map(|(place, part)| match place % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    words.collect()
}

#[test]
fn responses_make_the_gradebook_that_the_system_imports() {
    let room = Room::empty();
    let items = variants();
    room.fine(&["export", "moodle", "impact/two-carts", "--count", "3", "--codes", "codes.jsonl", "-o", "quiz.xml"]);
    let codes = lines(&room.read("codes.jsonl"));
    assert!(items.iter().all(|item| codes.iter().any(|coded| coded["code"] == item.code.as_str())));
    let mut differ = Vec::new();
    for case in cases("responses.txt") {
        fs::write(room.path("responses.csv"), filled(&case.table, &items)).unwrap();
        let _ = fs::remove_file(room.path("grades.csv"));
        let more = words(&case.asked);
        let more: Vec<&str> = more.iter().map(String::as_str).collect();
        let grade =
            ["grade", "responses.csv", "--codes", "codes.jsonl", "-o", "marks.csv", "--gradebook", "grades.csv"];
        let ran = room.run(&[&grade[..], &more].concat());
        let gradebook = fs::read_to_string(room.path("grades.csv")).unwrap_or_default();
        let (said, table): (Vec<&String>, Vec<&String>) = case.expected.iter().partition(|line| line.starts_with(SAID));
        let is_said = said.iter().all(|line| ran.err.contains(&line[SAID.len()..]));
        if gradebook.lines().collect::<Vec<_>>() != table || !is_said {
            differ.push(format!("{}\n{}=> {}\n{}{gradebook}", case.kind, case.table, case.asked, ran.err));
        }
    }
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}

#[test]
fn what_a_spreadsheet_leaves_of_a_seed_is_found() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/tables/seeds.csv");
    let mut rows = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    for row in rows.records().map(Result::unwrap) {
        let [kind, written, now, is] = [0, 1, 2, 3].map(|column| row[column].to_owned());
        let seed = written.parse::<SheetSeed>().unwrap().number;
        let table = format!("student,problem,seed\ns1,a/b,\"{now}\"\n");
        let listed = Listed::read(Table::read(table.as_bytes()).unwrap());
        match is.as_str() {
            "spoilt" => {
                let message = listed.unwrap_err().remove(0);
                assert!(message.contains("is what a spreadsheet leaves of a seed"), "{now}: {message}");
                assert!(SpoiltSeed::read(&now).unwrap().is_of(seed), "{now} of {written}");
            }
            _ => assert_eq!(Sheets::Listed(listed.unwrap()).seed("s1", "a/b", ""), Some(seed), "{now}"),
        }
        *kinds.entry(kind).or_default() += 1;
    }
    assert!(kinds.len() == 3 && kinds.values().all(|count| *count >= LEAST), "{kinds:?}");
}
