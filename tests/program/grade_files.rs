//! `momentous grade` on files of submissions: every kind of input gives the same marks, and every report says the same.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use momentous::exercise::Table;
use serde_json::Value;
use tempfile::{TempDir, tempdir};

/// The collision of the first problem, seed 1: -0.5 m/s, 4 m/s, 33.75 J.
const TABLE: &str = "\
student,problem,seed,form,attempt,v_A2,v_B2,T_lost
s1,impact/two-carts,1,forward,1,-0.5 m/s,4 m/s,33.8 J
s2,impact/two-carts,1,forward,1,0.5 m/s,4,
s3,impact/two-carts,one,forward,1,-0.5 m/s,,
s4,impact/two-carts,1,forward,1,-0.5 m/s,4 m/s,3 apples
";

fn momentous(folder: &Path, arguments: &str) -> (i32, String, String) {
    let mut command = Command::cargo_bin("momentous").unwrap();
    let output = command.current_dir(folder).args(arguments.split(' ')).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (output.status.code().unwrap(), text(&output.stdout), text(&output.stderr))
}

fn folder() -> TempDir {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("class.csv"), TABLE).unwrap();
    folder
}

/// The marks without the line, which says where each kind of input has the submission, as the program reads them.
fn rows(folder: &Path, name: &str) -> Vec<Vec<String>> {
    let text = fs::read(folder.join(name)).unwrap();
    let mut table = Table::read(text.as_slice()).unwrap();
    let mut rows = Vec::new();
    while let Some((_, row)) = table.next_row() {
        rows.push(row.unwrap().cells().skip(1).map(str::to_owned).collect());
    }
    rows
}

#[test]
fn a_table_json_lines_and_a_folder_get_the_same_marks() {
    let folder = folder();
    let mut lines = String::new();
    fs::create_dir(folder.path().join("handed-in")).unwrap();
    for row in csv::Reader::from_reader(TABLE.as_bytes()).records() {
        let row = row.unwrap();
        let answers = [("v_A2", &row[5]), ("v_B2", &row[6]), ("T_lost", &row[7])];
        let answers: Value = answers.into_iter().map(|(part, text)| (part.to_owned(), Value::from(text))).collect();
        let seed = row[2].parse::<u64>().map_or_else(|_| Value::from(&row[2]), Value::from);
        let object = serde_json::json!({
            "student": row[0], "problem": row[1], "seed": seed, "form": row[3], "attempt": 1, "answers": answers
        });
        lines.extend([object.to_string(), "\n".to_owned()]);
        let yaml = serde_yaml::to_string(&object).unwrap();
        fs::write(folder.path().join(format!("handed-in/{}.yaml", &row[0])), yaml).unwrap();
    }
    fs::write(folder.path().join("class.jsonl"), lines).unwrap();
    for (source, place) in [("class.csv", "class.csv:4"), ("class.jsonl", "class.jsonl:3"), ("handed-in", "s3.yaml")] {
        let (code, _, errors) = momentous(folder.path(), &format!("grade {source} -o {source}.out.csv"));
        assert_eq!(code, 2, "{errors}");
        assert!(errors.contains(place) && errors.contains("`one` is not a seed"), "{errors}");
    }
    let marks = rows(folder.path(), "class.csv.out.csv");
    assert_eq!(marks.len(), 9);
    assert_eq!(rows(folder.path(), "class.jsonl.out.csv"), marks);
    assert_eq!(rows(folder.path(), "handed-in.out.csv"), marks);
    let verdicts: Vec<&str> = marks.iter().map(|row| row[8].as_str()).collect();
    let expected = ["right", "right", "right", "sense", "unit_missing", "unanswered", "right", "right", "unreadable"];
    assert_eq!(verdicts, expected);
}

#[test]
fn marks_as_json_lines_have_the_columns_of_the_table() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv");
    momentous(folder.path(), "grade class.csv -o marks.jsonl");
    let (_, printed, _) = momentous(folder.path(), "grade class.csv --marks json");
    assert_eq!(fs::read_to_string(folder.path().join("marks.jsonl")).unwrap(), printed);
    let text = fs::read(folder.path().join("marks.csv")).unwrap();
    let mut table = Table::read(text.as_slice()).unwrap();
    let headings = table.headings().to_vec();
    for line in printed.lines() {
        let row = table.next_row().unwrap().1.unwrap();
        let line = serde_json::from_str::<Value>(line).unwrap();
        assert_eq!(line.as_object().unwrap().len(), headings.len());
        for (heading, cell) in headings.iter().zip(row.cells()) {
            let value = match &line[heading] {
                Value::String(text) => text.clone(),
                Value::Null => String::new(),
                other => other.to_string(),
            };
            assert_eq!(value, cell, "{heading}");
        }
    }
}

#[test]
fn a_changed_mark_is_listed() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv");
    let (code, same, _) = momentous(folder.path(), "grade class.csv -o again.csv --changes marks.csv");
    assert_eq!((code, same.as_str()), (0, "0 of 9 marks changed\n"));
    let marks = fs::read_to_string(folder.path().join("marks.csv")).unwrap();
    let old = marks.replacen("v_A2,1,2,sense", "v_A2,0,2,wrong", 1);
    assert_ne!(old, marks);
    fs::write(folder.path().join("old.csv"), old).unwrap();
    let (code, moved, _) =
        momentous(folder.path(), "grade class.csv -o again.csv --changes old.csv --changes-table changed.csv");
    let line = "line 3: s2, impact/two-carts `v_A2`: 0/2 [wrong] -> 1/2 [sense]\n";
    assert_eq!((code, moved), (1, format!("{line}1 of 9 marks changed\n")));
    let table = fs::read_to_string(folder.path().join("changed.csv")).unwrap();
    assert!(table.ends_with("v_A2,0,2,wrong,1,2,sense\n") && table.lines().count() == 2, "{table}");
}

/// A correction may refuse rows that were marked before, and mark rows that were refused.
#[test]
fn a_row_that_is_refused_now_is_a_change() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv");
    let refused = fs::read_to_string(folder.path().join("class.csv")).unwrap().replacen(
        "\ns2,impact/two-carts",
        "\ns2,impact/no-carts",
        1,
    );
    fs::write(folder.path().join("refused.csv"), refused).unwrap();
    let (code, gone, _) = momentous(folder.path(), "grade refused.csv -o fewer.csv --changes marks.csv");
    assert_eq!((code, gone.matches("[sense] -> not marked").count()), (1, 1), "{gone}");
    let (code, come, _) = momentous(folder.path(), "grade class.csv -o again.csv --changes fewer.csv");
    assert_eq!((code, come.matches("not marked -> 1/2 [sense]").count()), (1, 1), "{come}");
    let (code, none, _) = momentous(folder.path(), "grade refused.csv -o again.csv --changes fewer.csv");
    assert_eq!(code, 0, "{none}");
}

#[test]
fn marks_of_other_submissions_are_refused() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv");
    let other = TABLE.replace("s2,", "s9,");
    fs::write(folder.path().join("other.csv"), other).unwrap();
    let (code, _, errors) = momentous(folder.path(), "grade other.csv -o new.csv --changes marks.csv");
    assert_eq!(code, 2);
    assert!(errors.contains("marks.csv does not belong to these submissions: at line 5"), "{errors}");
    assert!(!folder.path().join("new.csv").exists(), "the output appears whole or not at all");
}

#[test]
fn the_junit_report_has_a_case_for_each_answer() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv --junit junit.xml");
    let report = fs::read_to_string(folder.path().join("junit.xml")).unwrap();
    let report = quick_junit::Report::deserialize_from_str(&report).unwrap();
    assert_eq!((report.tests, report.failures, report.errors), (10, 3, 2));
}

#[test]
fn the_summary_counts_what_was_found() {
    let folder = folder();
    momentous(folder.path(), "grade class.csv -o marks.csv --summary class");
    let summary = fs::read_to_string(folder.path().join("class.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    assert_eq!((&summary["answers"], &summary["students"]), (&Value::from(9), &Value::from(3)));
    let item = summary["items"].as_array().unwrap().iter().find(|item| item["part"] == "v_A2").unwrap();
    assert_eq!(item["verdicts"][0]["count"], 2);
    assert!((item["facility"].as_f64().unwrap() - 5.0 / 6.0).abs() < 1e-12);
    let page = fs::read_to_string(folder.path().join("class.html")).unwrap();
    assert!(page.contains("<code>T_lost</code>") && !page.contains("<script"));
}

/// Three attempts count, each before costs a quarter, each hint a tenth and each further one a twentieth: of `v_A2` by hand, worth
/// two points.
const ATTEMPTS: &str = "\
student,problem,seed,attempt,hints,further_hints,v_A2,v_B2
s1,ID,1,1,,,9 m/s,8 m/s
s1,ID,1,2,1,,RIGHT,8..1 m/s
s1,ID,1,3,1,,9 m/s,8 m/s
s1,ID,1,4,1,,RIGHT,8 m/s
s2,ID,1,3,,1,RIGHT,8 m/s
,ID,1,,,,RIGHT,8 m/s
,ID,1,,,,RIGHT,8 m/s
";

fn attempts(keep: &str) -> Vec<String> {
    let folder = tempdir().unwrap();
    let fixture = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/problems/two_carts.yaml");
    let prices = "attempt_penalty: 1/4, hint_penalty: 10 %, further_hint_penalty: 5 %";
    let rubric = format!("rubric: {{ attempts: 3, {prices}, keep: {keep} }}\n");
    fs::write(folder.path().join("carts.yaml"), rubric + &fs::read_to_string(fixture).unwrap()).unwrap();
    let (_, printed, _) = momentous(folder.path(), "generate carts.yaml --seed 1 --format json");
    let variant: Value = serde_json::from_str(&printed).unwrap();
    let right = variant["ask"][0]["printed"].as_str().unwrap();
    fs::write(
        folder.path().join("class.csv"),
        ATTEMPTS.replace("RIGHT", right).replace("ID", variant["problem"].as_str().unwrap()),
    )
    .unwrap();
    momentous(folder.path(), "grade class.csv --problem carts.yaml -o marks.csv --summary class");
    let rows = rows(folder.path(), "marks.csv").into_iter().filter(|row| row[5] == "v_A2");
    rows.map(|row| format!("{} {} {}", row[6], row[8], row[11])).collect()
}

#[test]
fn rows_that_stand_together_are_attempts() {
    let best = attempts("best");
    // The right answer is locked: what comes after it changes nothing.
    let expected =
        ["0 wrong no", "1.3 right yes", "1.3 right no", "1.3 right no", "0.9 right yes", "2 right yes", "2 right yes"];
    assert_eq!(best, expected);
    assert_eq!(attempts("last")[..4], ["0 wrong no", "1.3 right no", "1.3 right no", "1.3 right yes"]);
}

/// By hand: with `v_A2` = +0.5 m/s momentum leaves (13.75 - 7 - 1.25)/2 = 2.75 m/s for B; 67.5 J is twice the loss of 33.75 J.
#[test]
fn the_marks_and_the_summary_name_the_mistake_and_what_follows() {
    let folder = tempdir().unwrap();
    let row = |student: &str| format!("{student},impact/two-carts,1,0.5 m/s,2.75 m/s,67.5 J\n");
    let class = format!("student,problem,seed,v_A2,v_B2,T_lost\n{}{}", row("a"), row("b"));
    fs::write(folder.path().join("class.csv"), class).unwrap();
    momentous(folder.path(), "grade class.csv -o marks.csv --summary class");
    let marks = rows(folder.path(), "marks.csv");
    assert_eq!((&*marks[1][8], &*marks[1][13]), ("follow_through", "v_A2"));
    assert!(marks[2][12].split(' ').any(|code| code == "half-forgotten"), "{marks:?}");
    let summary: Value = serde_json::from_str(&fs::read_to_string(folder.path().join("class.json")).unwrap()).unwrap();
    let item = |part: &str| summary["items"].as_array().unwrap().iter().find(|item| item["part"] == part).unwrap();
    assert_eq!(item("v_B2")["followed"], 2);
    let lost = item("T_lost");
    assert_eq!((&lost["mistakes"][0]["mistake"], &lost["mistakes"][0]["count"]), (&"half-forgotten".into(), &2.into()));
    assert_eq!((&lost["wrong"][0]["answer"], &lost["wrong"][0]["count"]), (&"67.5 joules".into(), &2.into()));
    let page = fs::read_to_string(folder.path().join("class.html")).unwrap();
    assert!(page.contains("<code>half-forgotten</code>") && page.contains("67.5 joules"), "{page}");
}
