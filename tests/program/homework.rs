//! Homework as a file: one sheet a student, one key, one table of answers, and the marks of its problems one by one.

use std::collections::BTreeMap;
use std::fs;

use serde_json::Value;

use crate::blocks::blocks;
use crate::room::{Room, lines};

const CLASS: &str = "id,name\ns1,Ada\ns2,Ben\ns3,Cy\n";

/// A problem in two forms, one of them twice, and another with points and weights of its own.
const WEEK: &str = "\
title: \"Week 3: impact\"
date: due 14 October
problems:
  - { problem: impact/two-carts, form: find-e, points: 4 }
  - { problem: impact/two-carts, form: forward }
  - { problem: impact/two-carts, form: forward, points: 10, weights: { v_A2: 1, v_B2: 1, T_lost: 1 } }
";

fn room() -> Room {
    Room::with(&[("class.csv", CLASS), ("homework/week-3.yaml", WEEK)])
}

fn generate<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["generate", "homework/week-3.yaml", "--roster", "class.csv"], more].concat()
}

/// The sheets of the class as data.
fn sheets(room: &Room) -> Vec<Value> {
    room.fine(&generate(&["--format", "json", "-o", "sheets.jsonl"]));
    lines(&room.read("sheets.jsonl"))
}

/// A table of answers, one row a student; what is typed for a part is made of its printed answer.
fn write_answers(room: &Room, sheets: &[Value], typed: impl Fn(&str, usize, &str) -> String) {
    let mut heads = vec!["student".to_owned()];
    let mut rows = Vec::new();
    for sheet in sheets {
        let student = sheet["student"]["id"].as_str().unwrap();
        let mut row = vec![student.to_owned()];
        for problem in sheet["problems"].as_array().unwrap() {
            for part in problem["ask"].as_array().unwrap() {
                let head = format!("{}.{}", problem["number"], part["id"].as_str().unwrap());
                if rows.is_empty() {
                    heads.push(head.clone());
                }
                row.push(typed(
                    student,
                    heads.iter().position(|listed| *listed == head).unwrap(),
                    part["printed"].as_str().unwrap(),
                ));
            }
        }
        rows.push(row.join(","));
    }
    fs::write(room.path("answers.csv"), format!("{}\n{}\n", heads.join(","), rows.join("\n"))).unwrap();
}

/// Marks by the student, the problem, the seed, the form and the part.
fn marks(room: &Room, file: &str) -> BTreeMap<[String; 5], [String; 3]> {
    let text = room.read(file);
    let mut table = csv::Reader::from_reader(text.as_bytes());
    let heads = table.headers().unwrap().clone();
    let cell =
        |row: &csv::StringRecord, head: &str| row[heads.iter().position(|listed| listed == head).unwrap()].to_owned();
    let all = table.records().map(|row| {
        let row = row.unwrap();
        let key = ["student", "problem", "seed", "form", "part"].map(|head| cell(&row, head));
        (key, ["marks", "out_of", "verdict"].map(|head| cell(&row, head)))
    });
    all.collect()
}

#[test]
fn a_student_has_one_sheet_with_every_problem_and_the_numbers_of_the_problems_alone() {
    let room = room();
    room.fine(&generate(&["--key", "--solution", "-o", "sheets/"]));
    assert_eq!(
        room.names("sheets").into_iter().filter(|name| !name.contains(".svg")).collect::<Vec<_>>(),
        ["s1-week-3.md", "s2-week-3.md", "s3-week-3.md"]
    );
    let sheet = room.read("sheets/s1-week-3.md");
    assert!(sheet.starts_with("# Week 3: impact\n\n*For Ada (s1)*\n\n*due 14 October*\n\n*"), "{sheet}");
    assert_eq!(sheet.matches("\n## ").count(), 3, "{sheet}");
    assert!(!sheet.contains("\n---\n") && sheet.contains("\n## 3. ") && sheet.contains("*[3.33 points]*"), "{sheet}");
    let key = room.read("sheets-teacher/key.md");
    assert!(key.contains("(1a)") && key.contains("(3c)"), "{key}");
    let solution = room.read("sheets-teacher/s1-week-3-solution.md");
    assert_eq!(solution.matches("\n# ").count() + 1, 3, "{solution}");
    // A draw alone, and the same problem twice.
    let [alone, together] = ["forward", "find-e"].map(|form| {
        let file = format!("{form}.jsonl");
        let named = ["generate", "impact/two-carts", "--form", form, "--roster", "class.csv", "--format", "json"];
        room.fine(&[&named[..], &["-o", &file]].concat());
        lines(&room.read(&file))[0]["given"].clone()
    });
    let problems = sheets(&room)[0]["problems"].as_array().unwrap().clone();
    assert_eq!((&problems[1]["given"], &problems[0]["given"]), (&alone, &together));
    assert_ne!(problems[1]["given"], problems[2]["given"]);
}

#[test]
fn every_format_has_one_sheet() {
    let room = room();
    for (format, problem) in
        [("html", "<h2>2. "), ("latex", "\\large\\bfseries 2. "), ("typst", "#heading(level: 2)[2\\. ")]
    {
        let one = room.fine(&["generate", "homework/week-3.yaml", "--seed", "7", "--format", format]);
        assert!(one.contains(problem) && one.contains("Week 3: impact") && one.contains("due 14 October"), "{one}");
        let breaks = ["\\clearpage", "#pagebreak"].map(|command| one.matches(command).count());
        assert_eq!(breaks, [0, 0], "{format}");
    }
    #[cfg(feature = "pdf")]
    {
        room.fine(&generate(&["--format", "pdf", "-o", "sheets/"]));
        assert!(fs::read(room.path("sheets/s1-week-3.pdf")).unwrap().starts_with(b"%PDF"));
    }
}

/// The problems of a student in one file follow each other on a page, and the next student begins another; where a solution stands
/// between them they do not.
#[test]
fn problems_of_one_student_share_pages_in_one_file() {
    let room = room();
    let several = ["generate", "impact/two-carts", "conservation/coupling-wagons", "--roster", "class.csv"];
    let file = |more: &[&str]| {
        room.fine(&[&several[..], more].concat());
        room.read("all.tex")
    };
    let whole = file(&["--key", "--format", "latex", "-o", "all.tex"]);
    let students = room.read("class.csv").lines().count() - 1;
    assert_eq!(whole.matches("\\pagetitle{Problems}").count(), students, "{whole}");
    // Between students, and before the key.
    assert_eq!(whole.matches("\\clearpage").count(), students, "{whole}");
    let apart = file(&["--solution", "--format", "latex", "-o", "all.tex"]);
    assert_eq!(apart.matches("\\clearpage").count(), 4 * students - 1);
}

/// A homework says at its head whose it is and for which course, and leaves room for answers where it is told to.
#[test]
fn a_homework_has_a_head_and_room_for_answers() {
    let room = room();
    let text = room.read("homework/week-3.yaml");
    fs::write(room.path("homework/week-4.yaml"), format!("course: Mechanics 2\nroom: 3\n{text}")).unwrap();
    let parts = |sheet: &str, line: &str| sheet.matches(line).count();
    let sheet = room.fine(&["generate", "homework/week-4.yaml", "--seed", "7", "--format", "latex"]);
    assert!(sheet.contains("Mechanics 2") && sheet.contains("Name: \\blank"), "{sheet}");
    assert_eq!(parts(&sheet, "\n\\writingline"), 3 * parts(&sheet, "\n\\item[{("), "{sheet}");
    let sheet = room.fine(&["generate", "homework/week-4.yaml", "--seed", "7", "--format", "typst"]);
    assert!(sheet.contains("Mechanics 2") && sheet.contains("Name: #blank"), "{sheet}");
    let plain = room.fine(&["generate", "homework/week-3.yaml", "--seed", "7", "--format", "latex"]);
    assert_eq!(parts(&plain, "\n\\writingline"), 0);
}

#[test]
fn marks_are_those_of_the_problems_one_by_one_in_the_points_of_the_homework() {
    let room = room();
    let sheets = sheets(&room);
    // Right, wrong, and the wrong sense.
    write_answers(&room, &sheets, |student, column, printed| match (student, column % 3) {
        ("s2", 1) => "77 m/s".to_owned(),
        ("s3", 2) => String::new(),
        _ => printed.to_owned(),
    });
    let ran = room.run(&[
        "grade",
        "homework/week-3.yaml",
        "answers.csv",
        "--sheets",
        "sheets-teacher/seeds.csv",
        "-o",
        "marks.csv",
    ]);
    assert_eq!(ran.code, 1, "{}", ran.err);
    // The same answers to the problems alone, by the seeds of the table.
    let mut table = String::new();
    let answers = room.read("answers.csv");
    let rows: Vec<Vec<&str>> = answers.lines().map(|line| line.split(',').collect()).collect();
    for (sheet, row) in sheets.iter().zip(&rows[1..]) {
        for problem in sheet["problems"].as_array().unwrap() {
            let prefix = format!("{}.", problem["number"]);
            let cells = rows[0].iter().zip(row).filter_map(|(head, cell)| Some((head.strip_prefix(&prefix)?, cell)));
            let typed: serde_json::Map<String, Value> =
                cells.map(|(part, cell)| (part.to_owned(), (*cell).into())).collect();
            let line = serde_json::json!({ "student": row[0], "problem": "impact/two-carts", "form": problem["form"],
                "seed": format!("s{}", problem["seed"]), "answers": typed });
            table.extend([line.to_string(), "\n".to_owned()]);
        }
    }
    fs::write(room.path("alone.jsonl"), table).unwrap();
    room.run(&["grade", "alone.jsonl", "--sheets", "sheets-teacher/seeds.csv", "-o", "alone.csv"]);
    let (together, alone) = (marks(&room, "marks.csv"), marks(&room, "alone.csv"));
    assert_eq!(together.len(), alone.len());
    let share = |mark: &[String; 3]| mark[0].parse::<f64>().unwrap() / mark[1].parse::<f64>().unwrap();
    for (key, mark) in &together {
        let alone_mark = &alone[key];
        assert_eq!(mark[2], alone_mark[2], "{key:?}");
        assert!((share(mark) - share(alone_mark)).abs() < 0.01, "{key:?}: {mark:?} {alone_mark:?}");
    }
    let second = |mark: &&[String; 3]| mark[1] == "3.33";
    assert_eq!(together.values().filter(second).count(), 9);
    // Two students by the roster: nothing but the way in which the sheets are known differs.
    let by_roster = ["grade", "homework/week-3.yaml", "answers.csv", "--roster", "class.csv", "-o", "again.csv"];
    room.run(&[&by_roster[..], &["--changes", "marks.csv"]].concat());
    assert_eq!(marks(&room, "again.csv"), together);
}

#[test]
fn the_gradebook_has_the_points_of_the_homework_and_letters_name_parts_too() {
    let room = room();
    let sheets = sheets(&room);
    write_answers(&room, &sheets, |_, _, printed| printed.to_owned());
    let text = room.read("answers.csv").replacen("2.v_A2", "2a", 1);
    // The table that is written to be filled in lies beside the seeds.
    assert!(room.read("sheets-teacher/answers.csv").starts_with("student,name,1."));
    fs::write(room.path("sheets-teacher/answers.csv"), text).unwrap();
    let named = ["grade", "homework/week-3.yaml", "sheets-teacher/answers.csv", "-o", "marks.csv"];
    let ran = room.run(&[&named[..], &["--gradebook", "points.csv"]].concat());
    assert!(ran.code == 0 && ran.err.contains("seeds.csv says whose sheet is whose"), "{}", ran.err);
    let points = room.read("points.csv");
    let sum: f64 =
        sheets[0]["problems"][1]["ask"].as_array().unwrap().iter().map(|part| part["points"].as_f64().unwrap()).sum();
    assert_eq!(points.lines().nth(1).unwrap(), format!("s1,{}", 14.0 + sum));
    // It is not written over once it is filled in.
    let said = room.run(&generate(&["--format", "json", "-o", "sheets.jsonl"]));
    assert!(said.err.contains("answers.csv exists; it was not changed"), "{}", said.err);
}

#[test]
fn what_cannot_be_marked_is_told_with_the_way_out() {
    let room = room();
    let sheets = sheets(&room);
    write_answers(&room, &sheets, |_, _, printed| printed.to_owned());
    let grade = |more: &[&str]| room.run(&[&["grade", "homework/week-3.yaml", "answers.csv"], more].concat());
    let nobody = grade(&[]);
    assert!(nobody.code == 2 && nobody.err.contains("help: give --sheets"), "{}", nobody.err);
    let table = room.read("answers.csv");
    fs::write(room.path("answers.csv"), table.replacen("2.v_A2", "2.v_A22", 1)).unwrap();
    let part = grade(&["--roster", "class.csv"]);
    assert!(part.code == 2 && part.err.contains("`2.v_A22` is no part of this homework"), "{}", part.err);
    fs::write(room.path("answers.csv"), table.replacen("s2,", "s9,", 1)).unwrap();
    let stranger = grade(&["--roster", "class.csv"]);
    assert!(
        stranger.code == 2 && stranger.err.contains("no sheet of this homework was made for `s9`"),
        "{}",
        stranger.err
    );
    fs::write(room.path("homework/week-3.yaml"), WEEK.replacen("form: find-e", "form: forward", 1)).unwrap();
    fs::write(room.path("answers.csv"), table).unwrap();
    let other = grade(&["--sheets", "sheets-teacher/seeds.csv"]);
    assert!(
        other.code == 2 && other.err.contains("help: mark these sheets by the homework as it was"),
        "{}",
        other.err
    );
}

#[test]
fn a_homework_is_checked_with_the_problems_and_exported() {
    let room = room();
    fs::create_dir(room.path("problem_bank")).unwrap();
    let carts = include_str!("../../problem_bank/impact/two-carts.yaml");
    fs::write(room.path("problem_bank/carts.yaml"), carts).unwrap();
    let check = |more: &[&str]| room.run(&[&["check", "--seeds", "5"], more].concat());
    let whole = check(&[]);
    assert!(whole.code == 0 && whole.out.contains("week-3.yaml  Week 3: impact: 3 problems, "), "{}", whole.out);
    assert_eq!(check(&["homework/week-3.yaml"]).code, 0);
    let exported = room.fine(&["export", "moodle", "homework/week-3.yaml", "--count", "2"]);
    assert_eq!(exported.matches("<idnumber>impact/two-carts:").count(), 6);
    fs::write(room.path("homework/week-3.yaml"), WEEK.replacen("find-e", "find-f", 1)).unwrap();
    let broken = check(&["-q"]);
    assert!(
        broken.code == 2
            && broken.out.contains("failed: homework/week-3.yaml:4:40: impact/two-carts has no form `find-f`"),
        "{}",
        broken.out
    );
}

#[cfg(unix)]
#[test]
fn the_example_of_the_documentation_runs() {
    let all = blocks(include_str!("../../docs/repository.md"));
    let place = all.iter().position(|block| block.text.starts_with("# homework/week-3.yaml")).unwrap();
    let room = Room::with(&[("class.csv", CLASS), ("homework/week-3.yaml", &all[place].text)]);
    let commands = &all[place + 1];
    assert_eq!((commands.language.as_str(), commands.text.lines().count()), ("sh", 3));
    for line in commands.text.lines() {
        let expected = i32::from(line.ends_with("# exits with 1"));
        let words: Vec<&str> = line.split(" #").next().unwrap().split_whitespace().skip(1).collect();
        let ran = room.run(&words);
        assert_eq!(ran.code, expected, "{line}\n{}", ran.err);
    }
    assert_eq!(room.read("grades.csv").lines().count(), 4);
}
