//! A term of a course's repository, with git: a class of sixty, and changes of every kind after their sheets were handed out.

use std::fmt::Write;
use std::fs;
use std::process::{Command, Output};

use crate::room::{Room, lines};

/// The problems of the course: the built-in ones of these names.
const PROBLEMS: [&str; 4] =
    ["impact/two-carts", "impact/curling-stones", "impulse/softball-hit", "impact/clay-on-trolley"];

const WEEK: &str = "\
title: Week 1
problems:
  - { problem: impact/two-carts, form: forward, points: 6 }
  - { problem: impact/two-carts, form: find-e }
  - { problem: impact/curling-stones, weights: {} }
  - problem: impulse/softball-hit
";

/// How many students there are.
const CLASS: usize = 60;

/// What a change does to the snapshots of its problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Seen {
    Nothing,
    Words,
    Numbers,
}

/// Changes that must not matter to sheets that were handed out: of which file, what becomes what, what a reviewer sees, and how many
/// problems are checked for it.
const HARMLESS: [(&str, &str, &str, Seen, usize); 10] = [
    ("problem_bank/impact/two-carts.yaml", "id: impact", "# A comment.\nid: impact", Seen::Nothing, 1),
    ("problem_bank/impact/two-carts.yaml", "tags: [impact", "tags: [collision, impact", Seen::Nothing, 1),
    ("problem_bank/impact/two-carts.yaml", "They collide.", "They meet.", Seen::Words, 1),
    ("problem_bank/impact/two-carts.yaml", "title: ", "title: Again, ", Seen::Words, 1),
    ("problem_bank/impact/two-carts.yaml", "hints:", "hints:\n  - Draw both carts.", Seen::Words, 1),
    ("problem_bank/impact/two-carts.yaml", "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9", Seen::Numbers, 1),
    (
        "problem_bank/impact/two-carts.yaml",
        "id: impact/two-carts",
        "id: impact/wagons\nwas: impact/two-carts",
        Seen::Numbers,
        1,
    ),
    ("problem_bank/course.yaml", "symbols: {}", "symbols: { momentum: L }", Seen::Nothing, 4),
    ("templates/markdown/blocks.tera", "", "\n", Seen::Nothing, 4),
    ("README.md", "Problems", "Our problems", Seen::Nothing, 0),
];

fn git(room: &Room, arguments: &[&str]) -> Output {
    let identity = ["-c", "user.name=a", "-c", "user.email=a@b.example"];
    Command::new("git").current_dir(room.path(".")).args(identity).args(arguments).output().unwrap()
}

fn commit(room: &Room) {
    for arguments in [&["add", "-A"][..], &["commit", "-q", "--allow-empty", "-m", "a state"]] {
        let ran = git(room, arguments);
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    }
}

fn change(room: &Room, path: &str, old: &str, new: &str) {
    let text = room.read(path);
    assert!(text.contains(old), "{path}: {old}");
    fs::write(room.path(path), text.replacen(old, new, 1)).unwrap();
}

/// The repository on the day when the sheets were handed out, with the answers of the class.
fn course() -> Room {
    let room = Room::empty();
    room.fine(&["init"]);
    for id in PROBLEMS {
        let path = format!("problem_bank/{id}.yaml");
        fs::create_dir_all(room.path(&path).parent().unwrap()).unwrap();
        fs::write(room.path(&path), Room::empty().fine(&["show", id])).unwrap();
    }
    room.fine(&["templates", "markdown/blocks.tera", "--write"]);
    let students: String = (1..=CLASS).fold(String::from("id,name\n"), |mut table, number| {
        writeln!(table, "s{number},Student {number}").unwrap();
        table
    });
    for (path, text) in [
        ("class.csv", students.as_str()),
        ("homework/week-1.yaml", WEEK),
        ("secret.txt", "a long secret of the course"),
    ] {
        fs::write(room.path(path), text).unwrap();
    }
    assert!(git(&room, &["init", "-q", "-b", "main"]).status.success());
    let sheets = ["generate", "homework/week-1.yaml", "--roster", "class.csv", "--secret", "secret.txt"];
    room.fine(&[&sheets[..], &["--format", "json", "-o", "sheets.jsonl"]].concat());
    fs::write(room.path("answers.csv"), answers(&room)).unwrap();
    room.fine(&["snapshot", "--accept"]);
    commit(&room);
    room
}

/// What the class answers: most is right; some have the other sign, some nothing, some a number of their own.
fn answers(room: &Room) -> String {
    let mut table = String::new();
    for (place, sheet) in lines(&room.read("sheets.jsonl")).iter().enumerate() {
        let (mut heads, mut cells) =
            (vec!["student".to_owned()], vec![sheet["student"]["id"].as_str().unwrap().to_owned()]);
        for problem in sheet["problems"].as_array().unwrap() {
            for part in problem["ask"].as_array().unwrap() {
                let right = part["printed"].as_str().unwrap();
                heads.push(format!("{}.{}", problem["number"], part["id"].as_str().unwrap()));
                cells.push(match (place + heads.len()) % 7 {
                    1 => right.strip_prefix('-').map_or_else(|| format!("-{right}"), str::to_owned),
                    2 => String::new(),
                    3 => "17.5 m/s".to_owned(),
                    _ => right.to_owned(),
                });
            }
        }
        if place == 0 {
            writeln!(table, "{}", heads.join(",")).unwrap();
        }
        writeln!(table, "\"{}\"", cells.join("\",\"")).unwrap();
    }
    table
}

fn grade<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let named = ["grade", "homework/week-1.yaml", "answers.csv", "--sheets", "sheets-teacher/seeds.csv"];
    [&named[..], &["--secret", "secret.txt"], more].concat()
}

#[test]
fn a_class_is_marked_the_same_before_and_after_each_change_that_must_not_matter() {
    let room = course();
    assert_eq!(room.run(&grade(&["-o", "marks.csv"])).code, 1);
    let marks = room.read("marks.csv");
    let verdicts = |verdict: &str| marks.matches(&format!(",{verdict},")).count();
    let all = marks.lines().count() - 1;
    assert!(verdicts("right") > all / 3 && verdicts("right") < all && verdicts("unanswered") > CLASS, "{marks}");
    for (path, old, new, seen, checked) in HARMLESS {
        change(&room, path, old, new);
        let again = room.run(&grade(&["-o", "again.csv", "--changes", "marks.csv"]));
        assert!(
            again.code == 0 && again.out.contains(&format!("0 of {all} marks changed")),
            "{new}: {}{}",
            again.out,
            again.err
        );
        let check = room.run(&["check", "-q", "--seeds", "4", "--simulated", "1", "--changed-since", "HEAD"]);
        let counted = check.out.lines().last().unwrap_or_default();
        assert!(
            check.code == 0 && counted.starts_with(&format!("{checked} problem")),
            "{new}: {}{}",
            check.out,
            check.err
        );
        let snapshot = room.run(&["snapshot"]).out;
        let said = snapshot.lines().next().unwrap();
        let is_said = match seen {
            Seen::Nothing => said.ends_with("all unchanged"),
            Seen::Words => said.ends_with("in words only"),
            // A problem with another name is another one to a reviewer.
            Seen::Numbers => said.contains("in numbers (") || said.contains("1 new"),
        };
        assert!(is_said, "{new}: {said}");
        room.fine(&["snapshot", "--accept"]);
        commit(&room);
    }
}

#[test]
fn a_change_that_matters_is_told_and_undone_by_git() {
    let room = course();
    room.run(&grade(&["-o", "marks.csv"]));
    change(&room, "problem_bank/impact/two-carts.yaml", "\ntext: >", "\nrubric: { sense: 0 % }\ntext: >");
    let again = room.run(&grade(&["-o", "again.csv", "--changes", "marks.csv", "--changes-table", "changed.csv"]));
    assert_eq!(again.code, 1);
    let changed = room.read("changed.csv");
    assert!(
        changed.lines().count() > 1 && changed.lines().skip(1).all(|line| line.contains("impact/two-carts")),
        "{changed}"
    );
    assert!(room.run(&["snapshot"]).out.starts_with("1 problem changed: 1 in marks ("));
    assert!(git(&room, &["checkout", "-q", "--", "."]).status.success());
    assert_eq!(room.run(&grade(&["-o", "again.csv", "--changes", "marks.csv"])).code, 0);
}

#[test]
fn two_authors_changes_of_one_problem_merge_without_a_conflict_in_snapshots() {
    let room = course();
    let path = "problem_bank/impact/two-carts.yaml";
    for (branch, old, new) in
        [("ana", "hints:", "hints:\n  - Draw both carts."), ("ben", "tags: [impact", "tags: [collision, impact")]
    {
        assert!(git(&room, &["checkout", "-q", "-b", branch, "main"]).status.success());
        change(&room, path, old, new);
        room.fine(&["snapshot", "--accept"]);
        commit(&room);
    }
    let merged = git(&room, &["merge", "-q", "--no-edit", "ana"]);
    assert!(merged.status.success(), "{}", String::from_utf8_lossy(&merged.stdout));
    room.fine(&["snapshot"]);
}
