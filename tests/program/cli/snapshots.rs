//! `momentous snapshot`: what a course repository keeps and compares.

use std::fs;

use crate::room::Room;

#[test]
fn snapshots_are_accepted_compared_and_shown() {
    let room = Room::empty();
    room.fine(&["new", "homework/carts.yaml"]);
    let missing = room.run(&["snapshot", "homework"]);
    assert!(missing.code == 1 && missing.out.contains("new, not accepted yet"), "{}", missing.out);
    room.fine(&["snapshot", "homework", "--accept"]);
    assert_eq!(room.names("snapshots").len(), 2 * 3 * 2);
    room.fine(&["snapshot", "homework", "--check"]);
    let problem = room.read("homework/carts.yaml");
    fs::write(room.path("homework/carts.yaml"), problem.replace("They collide.", "They crash.")).unwrap();
    let changed = room.run(&["snapshot", "homework"]);
    assert_eq!(changed.code, 1);
    assert!(changed.out.lines().any(|line| line.starts_with('-') && line.contains("They collide.")), "{}", changed.out);
    assert!(changed.out.lines().any(|line| line.starts_with('+') && line.contains("They crash.")), "{}", changed.out);
    room.fine(&["snapshot", "homework", "--accept"]);
    room.fine(&["snapshot", "homework"]);
}

#[test]
fn a_snapshot_without_a_problem_is_told_and_removed_and_other_files_stay() {
    let room = Room::with(&[("problem_bank/.keep", ""), ("golden/old.seed-1.md", "old"), ("golden/notes.md", "notes")]);
    room.fine(&["new", "a/b"]);
    let arguments = ["snapshot", "--folder", "golden"];
    assert!(room.run(&arguments).out.contains("no problem produces it any more: old.seed-1.md"));
    room.fine(&["snapshot", "--folder", "golden", "--accept"]);
    assert!(!room.path("golden/old.seed-1.md").exists() && room.path("golden/notes.md").exists());
    room.fine(&arguments);
}
