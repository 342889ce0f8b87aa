//! What was issued is marked as issued: sheets keep their numbers whatever happens to their problem's file.

use std::fs;

use crate::room::{Room, lines};

const CLASS: &str = "id,name\ns1,Ada\ns2,Ben\ns3,Cy\ns4,Dee\n";

/// A problem of the bank in a file of the teacher's own.
fn carts() -> String {
    include_str!("../../problem_bank/impact/two-carts.yaml").replacen("id: impact/two-carts", "id: own/carts", 1)
}

/// Sheets for the class, and a table of right answers to them; with it what every row says besides.
fn issued(besides: &str) -> (Room, String) {
    let room = Room::with(&[("class.csv", CLASS), ("carts.yaml", &carts())]);
    room.fine(&["generate", "carts.yaml", "--roster", "class.csv", "--format", "json", "-o", "sheets.jsonl"]);
    let row = |record: &serde_json::Value| {
        let parts = record["ask"].as_array().unwrap().iter().map(|part| part["printed"].as_str().unwrap());
        let student = record["student"]["id"].as_str().unwrap();
        let besides = match besides {
            "digest" => record["digest"].as_str().unwrap(),
            _ => "",
        };
        format!("{student},own/carts,{},forward,{besides},{}\n", record["seed"], parts.collect::<Vec<_>>().join(","))
    };
    let rows: String = lines(&room.read("sheets.jsonl")).iter().map(row).collect();
    let table = format!("student,problem,seed,form,digest,v_A2,v_B2,T_lost\n{rows}");
    fs::write(room.path("submissions.csv"), &table).unwrap();
    (room, table)
}

/// How many of the twelve answers are right, and what is said.
fn right(room: &Room, more: &[&str]) -> (usize, String) {
    let arguments = ["grade", "submissions.csv", "--problem", "carts.yaml", "-o", "marks.csv"];
    let ran = room.run(&[&arguments, more].concat());
    (room.read("marks.csv").matches(",right,").count(), ran.err)
}

fn change(room: &Room, old: &str, new: &str) {
    let text = room.read("carts.yaml");
    assert!(text.contains(old), "{old}");
    fs::write(room.path("carts.yaml"), text.replace(old, new)).unwrap();
}

#[test]
fn sheets_are_marked_by_their_own_numbers_after_a_range_has_changed() {
    let (room, _) = issued("");
    assert_eq!(right(&room, &["--sheets", "sheets-teacher/seeds.csv"]).0, 12);
    change(&room, "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9");
    assert!(right(&room, &[]).0 < 12, "the seeds give other numbers now");
    let (count, said) = right(&room, &["--sheets", "sheets-teacher/seeds.csv"]);
    assert_eq!(count, 12, "{said}");
    assert!(said.contains("which may draw other numbers"), "{said}");
}

#[test]
fn rows_with_a_digest_are_refused_only_where_their_numbers_are_unknown() {
    let (room, _) = issued("digest");
    change(&room, "They collide.", "They meet. # no comment");
    change(&room, "tags: [impact, direct, restitution, energy]", "tags: [impact]");
    change(&room, "points: 2 }", "points: 3 }");
    assert_eq!(right(&room, &[]).0, 12);
    change(&room, "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9");
    let (count, said) = right(&room, &[]);
    assert_eq!((count, said.matches("the sheet was made from another version of own/carts").count()), (0, 4), "{said}");
    assert!(said.contains("help: give --sheets"), "{said}");
    assert_eq!(right(&room, &["--sheets", "sheets-teacher/seeds.csv"]).0, 12);
}

#[test]
fn a_sheet_whose_quantities_are_told_otherwise_now_is_refused_by_name() {
    let (room, _) = issued("");
    change(&room, "m_B: { min: 1, max: 6, step: 0.5, unit: kg }", "m_B: 77 kg");
    let (count, said) = right(&room, &["--sheets", "sheets-teacher/seeds.csv"]);
    assert_eq!(count, 0);
    assert_eq!(said.matches("another version of the problem, which tells `m_B` otherwise").count(), 4, "{said}");
}

#[test]
fn a_renamed_problem_keeps_its_draws_and_its_sheets() {
    let (room, _) = issued("digest");
    change(&room, "id: own/carts", "id: own/wagons\nwas: own/carts");
    assert_eq!(right(&room, &[]).0, 12);
    assert_eq!(right(&room, &["--sheets", "sheets-teacher/seeds.csv"]).0, 12);
    assert_eq!(right(&room, &["--roster", "class.csv"]).0, 12);
    let renamed = room.read("submissions.csv").replace("own/carts", "own/wagons");
    fs::write(room.path("submissions.csv"), renamed).unwrap();
    assert_eq!(right(&room, &["--sheets", "sheets-teacher/seeds.csv"]).0, 12);
    assert_eq!(right(&room, &["--roster", "class.csv"]).0, 12);
}

#[test]
fn a_row_may_say_the_numbers_of_its_sheet() {
    let (room, table) = issued("");
    change(&room, "m_B: { min: 1, max: 6", "m_B: { min: 1, max: 9");
    let seeds = room.read("sheets-teacher/seeds.csv");
    let mut seeds = csv::Reader::from_reader(seeds.as_bytes());
    let column = seeds.headers().unwrap().iter().position(|heading| heading == "given").unwrap();
    let given: Vec<String> = seeds.records().map(|row| row.unwrap()[column].to_owned()).collect();
    let mut lines = table.lines();
    let head = format!("{},given", lines.next().unwrap());
    let rows = lines.zip(&given).map(|(line, given)| format!("{line},{given}"));
    let table: Vec<String> = [head].into_iter().chain(rows).collect();
    fs::write(room.path("submissions.csv"), table.join("\n")).unwrap();
    let (count, said) = right(&room, &[]);
    assert_eq!(count, 12, "{said}");
}
