//! `momentous snapshot`: what a course repository keeps and compares.

use std::fs;

use assert_cmd::Command;

use crate::room::Room;

const CARTS: &str = include_str!("../../../problem_bank/impact/two-carts.yaml");
const STONES: &str = include_str!("../../../problem_bank/impact/curling-stones.yaml");
const HIT: &str = include_str!("../../../problem_bank/impulse/softball-hit.yaml");

/// A bank of three problems whose snapshots are accepted.
fn kept() -> Room {
    let room = Room::with(&[
        ("problem_bank/impact/two-carts.yaml", CARTS),
        ("problem_bank/impact/curling-stones.yaml", STONES),
        ("problem_bank/impulse/softball-hit.yaml", HIT),
    ]);
    room.fine(&["snapshot", "--accept"]);
    assert!(room.fine(&["snapshot"]).ends_with("all unchanged\n"));
    room
}

fn change(room: &Room, path: &str, old: &str, new: &str) {
    let path = format!("problem_bank/{path}.yaml");
    let text = room.read(&path);
    assert!(text.contains(old), "{old}");
    fs::write(room.path(&path), text.replacen(old, new, 1)).unwrap();
}

#[test]
fn snapshots_lie_by_topic_and_hold_no_digest() {
    let room = kept();
    assert_eq!(room.names("snapshots"), ["impact", "impulse"]);
    let names = room.names("snapshots/impact");
    let of_carts: Vec<&String> = names.iter().filter(|name| name.starts_with("two-carts.")).collect();
    let endings = ["figures.svg", "marks.csv", "numbers.csv", "words.md"];
    assert_eq!(of_carts, endings.map(|ending| format!("two-carts.{ending}")).iter().collect::<Vec<_>>());
    for name in &names {
        assert!(!room.read(&format!("snapshots/impact/{name}")).contains("digest"), "{name}");
    }
    let words = room.read("snapshots/impact/two-carts.words.md");
    assert!(!words.contains("<svg") && words.contains("(two-carts.figures.svg#forward-1)"), "{words}");
    let figures = room.read("snapshots/impact/two-carts.figures.svg");
    assert!(figures.contains("<view id=\"forward-1\"") && figures.matches("<style>").count() == 1);
    assert_eq!(room.read("snapshots/impact/two-carts.numbers.csv").lines().count(), 1 + 2 * 40);
}

#[test]
fn a_summary_says_first_what_kind_of_change_it_is() {
    let room = kept();
    // What nobody reads from a sheet is no change.
    change(&room, "impact/two-carts", "tags: [impact", "tags: [collision, impact");
    change(&room, "impact/two-carts", "id:", "# A comment.\nid:");
    room.fine(&["snapshot", "--check"]);
    change(&room, "impact/curling-stones", "title: ", "title: Once more, ");
    change(&room, "impact/two-carts", "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9");
    let ran = room.run(&["snapshot"]);
    assert_eq!(ran.code, 1);
    let first: Vec<&str> = ran.out.lines().take(3).collect();
    assert!(
        first[0].starts_with("2 problems changed: 1 in numbers (")
            && first[0].ends_with(" of 80 sheets), 1 in words only"),
        "{first:?}"
    );
    assert_eq!(first[1], "  impact/curling-stones: in words only");
    assert!(ran.out.lines().any(|line| line.starts_with("+# ") && line.contains("Once more")), "{}", ran.out);
    // Each alone.
    let only = room.run(&["snapshot", "impact/curling-stones"]);
    assert!(only.out.starts_with("1 problem changed: 1 in words only\n"), "{}", only.out);
}

#[test]
fn a_change_of_marking_is_seen() {
    let room = kept();
    change(&room, "impact/two-carts", "{ find: v_A2,", "{ find: v_A2, tolerance: 20 %,");
    let ran = room.run(&["snapshot"]);
    assert!(ran.out.starts_with("1 problem changed: 1 in marks ("), "{}", ran.out);
    let line = |sign: char, verdict: &str| {
        ran.out.lines().any(|line| line.starts_with(sign) && line.contains("off by 10 %") && line.contains(verdict))
    };
    assert!(line('-', ",wrong,0/") && line('+', ",right,"), "{}", ran.out);
}

#[test]
fn figures_are_apart_and_shown_on_a_page() {
    let room = kept();
    change(&room, "impact/two-carts", "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9");
    let ran = room.run(&["snapshot", "--page", "changes.html"]);
    assert!(!ran.out.contains("<svg") && !ran.out.contains("<polygon"), "{}", ran.out);
    let page = room.read("changes.html");
    assert!(page.contains("<h2>impact/two-carts: in numbers: "), "{page}");
    if ran.out.contains("two-carts.figures.svg") {
        assert_eq!(page.matches("data:image/svg+xml;base64,").count(), 2);
    }
}

#[test]
fn changes_are_accepted_and_rejected_one_by_one() {
    let room = kept();
    for problem in ["impact/curling-stones", "impact/two-carts", "impulse/softball-hit"] {
        change(&room, problem, "title: ", "title: Once more, ");
    }
    let review = |answers: &str| {
        let mut command = Command::cargo_bin("momentous").unwrap();
        let ran =
            command.current_dir(room.path(".")).args(["snapshot", "--review"]).write_stdin(answers).output().unwrap();
        (ran.status.code().unwrap(), String::from_utf8(ran.stdout).unwrap())
    };
    let (code, said) = review("a\nhm\nr\n");
    assert_eq!(code, 1);
    assert!(said.contains("\n1 accepted, 1 rejected, 1 left\nrejected: impact/two-carts; "), "{said}");
    assert!(room.run(&["snapshot"]).out.starts_with("2 problems changed: 2 in words only\n"));
    assert_eq!(review("accept\naccept\n").0, 0);
    room.fine(&["snapshot"]);
    assert_eq!(review("").0, 0);
}

#[test]
fn a_snapshot_without_a_problem_is_told_and_removed_and_other_files_stay() {
    let room = Room::with(&[
        ("problem_bank/.keep", ""),
        ("golden/a/old.words.md", "old"),
        ("golden/impact.old.seed-1.md", "old"),
        ("golden/notes.md", "notes"),
    ]);
    room.fine(&["new", "a/b"]);
    let arguments = ["snapshot", "--folder", "golden"];
    let said = room.run(&arguments).out;
    assert!(said.contains("no problem produces it any more: a/old.words.md"), "{said}");
    assert!(said.contains("1 files are of an earlier version of the program"), "{said}");
    room.fine(&["snapshot", "--folder", "golden", "--accept"]);
    assert!(!room.path("golden/a/old.words.md").exists() && !room.path("golden/impact.old.seed-1.md").exists());
    assert!(room.path("golden/notes.md").exists());
    room.fine(&arguments);
}

#[test]
fn one_broken_file_stops_no_other_and_loses_no_snapshot() {
    let room = kept();
    change(&room, "impact/two-carts", "unit: kg }", "unit: kgg }");
    change(&room, "impulse/softball-hit", "title: ", "title: Once more, ");
    let ran = room.run(&["snapshot", "--accept"]);
    assert!(ran.code == 2 && ran.err.contains("the unit `kgg` is not known"), "{}", ran.err);
    assert!(room.path("snapshots/impact/two-carts.words.md").exists());
    assert!(room.read("snapshots/impulse/softball-hit.words.md").contains("Once more"));
}
