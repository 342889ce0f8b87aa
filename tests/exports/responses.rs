//! The way back: variants go to another program, responses come back, are found by their codes, marked, and make a gradebook.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use assert_cmd::Command;
use momentous::bank::Bank;
use momentous::exercise::{Exercise, Item, ItemAnswers, ItemPart, NumberItem};
use momentous::export::{Coded, Question, Responses, Target};
use momentous::grade::{DecimalMark, Verdict};
use momentous::problem::{compile, load};
use momentous::render::Markup;

fn item(problem: &str, seed: u64) -> Item {
    let source = Bank::built_in().find(problem).unwrap().clone();
    let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
    Exercise::draw(&problem, 0, seed).unwrap().item()
}

/// What a student types into a field for a number.
fn number(item: &Item, part: usize) -> String {
    let ItemAnswers::Number(number) = &item.parts[part].answers else { panic!("part {part} is no number") };
    format!("{:.*e}", number.figures - 1, number.right)
}

/// What a usual mistake leads to, where it is worth nothing.
fn mistake(item: &Item, part: usize, code: &str) -> String {
    let ItemAnswers::Number(number) = &item.parts[part].answers else { panic!("part {part} is no number") };
    let is_worthless = |window: &&momentous::exercise::Window| {
        window.mistakes.contains(&code) && window.points.0 == momentous::quantity::Rational::ZERO
    };
    let window = number.windows.iter().find(is_worthless).unwrap();
    (window.low + (window.high - window.low) / 2.0).to_string()
}

fn exported(folder: &Path, target: &str) -> Vec<Coded> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
    command.args(["export", target, "impact/two-carts", "--count", "2", "--codes"]).arg(folder.join("codes.jsonl"));
    command.arg("-o").arg(folder.join("quiz")).assert().success();
    let codes = fs::read_to_string(folder.join("codes.jsonl")).unwrap();
    codes.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Marks responses; gives the marks and the gradebook.
fn graded(folder: &Path, responses: &str) -> [String; 2] {
    fs::write(folder.join("responses.csv"), responses).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
    command.current_dir(folder).args(["grade", "responses.csv", "--codes", "codes.jsonl"]);
    command.args(["-o", "marks.csv", "--gradebook", "grades.csv"]).assert().code(1);
    ["marks.csv", "grades.csv"].map(|name| fs::read_to_string(folder.join(name)).unwrap())
}

/// The cells of a student's row for a part.
fn row<'m>(marks: &'m str, student: &str, part: &str) -> Vec<&'m str> {
    let rows = marks.lines().map(|line| line.split(',').collect::<Vec<_>>());
    rows.into_iter().find(|row| row[1] == student && row[6] == part).unwrap()
}

#[test]
fn responses_of_moodle_are_marked_and_make_a_gradebook() {
    let folder = tempfile::tempdir().unwrap();
    let codes = exported(folder.path(), "moodle");
    let file = fs::read_to_string(folder.path().join("quiz")).unwrap();
    assert!(codes.iter().all(|code| file.contains(&format!("[{}]", code.code))));
    let [first, second] = [1, 2].map(|seed| item("impact/two-carts", seed));
    assert_eq!([&first.code, &second.code], [&codes[0].code, &codes[1].code]);
    let response = |of: [String; 3]| format!("part 1: {}; part 2: {}; part 3: {}", of[0], of[1], of[2]);
    let right = response([0, 1, 2].map(|part| number(&first, part)));
    let wrong = response([number(&second, 0), number(&second, 1), mistake(&second, 2, "half-forgotten")]);
    let responses = format!(
        "\u{feff}Last name,Email address,Question 1,Response 1,Right answer 1\n\
         One,one@x,\"Two carts\n[{}] (a) ...\",{right},x\nTwo,two@x,[{}],{wrong},x\nThree,three@x,[{}],-,x\n",
        first.code, second.code, first.code
    );
    let [marks, gradebook] = graded(folder.path(), &responses);
    assert_eq!(gradebook.lines().collect::<Vec<_>>()[0], "Email address,responses");
    let points = |student: &str| {
        let row = gradebook.lines().find(|line| line.starts_with(student)).unwrap();
        row.split(',').nth(1).unwrap().parse::<f64>().unwrap()
    };
    let total: u32 = first.parts.iter().map(|part| part.field.points).sum();
    assert!((points("one@x") - f64::from(total)).abs() < 1e-9 && points("three@x") == 0.0, "{gradebook}");
    assert!(points("two@x") < f64::from(total) && points("two@x") > 0.0, "{gradebook}");
    assert!(!row(&marks, "two@x", &first.parts[2].field.id)[13].is_empty(), "the mistake is named: {marks}");
}

#[test]
fn responses_of_canvas_are_marked_and_make_a_gradebook() {
    let folder = tempfile::tempdir().unwrap();
    let codes = exported(folder.path(), "canvas");
    let [first, second] = [1, 2].map(|seed| item("impact/two-carts", seed));
    let responses = format!(
        "name,id,11: Carts [{}-a] Find v,2.0,12: Carts [{}-b] Find v,2.0\nOne,17,{},2.0,{},2.0\nTwo,18,,,7e9,0.0\n",
        codes[0].code,
        codes[1].code,
        number(&first, 0),
        number(&second, 1)
    );
    let [marks, gradebook] = graded(folder.path(), &responses);
    let points = first.parts[0].field.points + first.parts[1].field.points;
    assert_eq!(gradebook, format!("Student,ID,Section,responses\n17,17,,{points}\n18,18,,0\n"));
    // Each field has a variant of its own, of which the other parts were not asked.
    let verdicts: Vec<&str> = marks.lines().skip(1).filter_map(|line| line.split(',').nth(9)).collect();
    let count = |verdict: &str| verdicts.iter().filter(|one| **one == verdict).count();
    assert_eq!([count("right"), count("unanswered")], [2, verdicts.len() - 3], "{marks}");
}

/// What is typed into the fields of a part, or chosen there, when it is right.
fn right(part: &ItemPart) -> Vec<String> {
    let number = |number: &NumberItem| {
        if number.whole { format!("{:.0}", number.right) } else { format!("{:.*e}", number.figures - 1, number.right) }
    };
    match &part.answers {
        ItemAnswers::Number(right) => vec![number(right)],
        ItemAnswers::Roots(all) | ItemAnswers::Vector { components: all, .. } => all.iter().map(number).collect(),
        ItemAnswers::Interval { low, high } => [low, high].into_iter().flatten().map(|bound| number(bound)).collect(),
        ItemAnswers::Choice { options, right, .. } => vec![options[*right].clone()],
        ItemAnswers::Formula { right, .. } => {
            vec![right.math.as_ref().map_or_else(String::new, |math| Markup::Tex.math(math))]
        }
    }
}

#[test]
fn right_numbers_in_fields_are_right_with_the_units_printed_behind_them() {
    let mut typed = 0;
    for source in Bank::built_in().sources().cloned() {
        let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let exercise = Exercise::draw(&problem, form, 1).unwrap();
            let item = exercise.item();
            let coded = Coded::of(&Question::new(&item), Target::named("qti3").unwrap());
            let mut fields: Vec<(String, String)> = Vec::new();
            for coded_part in &coded.parts {
                let part = item.parts.iter().find(|part| part.field.id == coded_part.id).unwrap();
                fields.extend(coded_part.fields.iter().cloned().zip(right(part)));
            }
            let answers: BTreeMap<String, String> = coded.answers(&fields).into_iter().collect();
            let report = exercise.grade(&answers, DecimalMark::Point);
            for coded_part in &coded.parts {
                let marked = report.parts.iter().find(|part| part.id == coded_part.id).unwrap();
                assert_eq!(marked.verdict, Verdict::Right, "{} {answers:?}", item.identity.problem);
                typed += 1;
            }
        }
    }
    assert!(typed > 300, "{typed}");
}

#[test]
fn a_table_that_moodle_wrote_is_read() {
    let codes = include_str!("../fixtures/moodle-codes.jsonl").lines();
    let codes: Vec<Coded> = codes.map(|line| serde_json::from_str(line).unwrap()).collect();
    let table = include_str!("../fixtures/moodle-responses.csv").trim_start_matches('\u{feff}');
    let mut table = csv::Reader::from_reader(table.as_bytes());
    let headings: Vec<String> = table.headers().unwrap().iter().map(str::to_owned).collect();
    let responses = Responses::new(&codes, &headings, None).unwrap();
    let read = table.records().map(|row| {
        let row = row.unwrap();
        let found = responses.of_row(&row.iter().collect::<Vec<_>>());
        let students: Vec<String> = found.iter().map(|response| response.student.clone()).collect();
        let answers =
            found.iter().flat_map(|response| response.coded.answers(&response.typed)).map(|(_, answer)| answer);
        (students, answers.collect::<Vec<_>>())
    });
    let expected = [
        ("s-ann", vec!["3.88 m/s", "6.58°", "m_B*E/(m_A + m_B)", "29.0 mph"]),
        ("s-bob", vec!["1,40 m/s", "6.58°", "-m_B*sqrt(m_A*E/(2*m_B*(m_A + m_B)))", "29.0"]),
        ("s-eve", vec!["3.88 m/s"]),
    ];
    let expected = expected.map(|(student, answers)| {
        (vec![student.to_owned(); 3], answers.into_iter().map(str::to_owned).collect::<Vec<_>>())
    });
    assert_eq!(read.collect::<Vec<_>>(), expected);
}

#[test]
fn a_table_without_codes_is_refused_with_the_way_out() {
    let folder = tempfile::tempdir().unwrap();
    exported(folder.path(), "moodle");
    fs::write(folder.path().join("responses.csv"), "Email address,Response 1\na@x,3\n").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
    command.current_dir(folder.path()).args(["grade", "responses.csv", "--codes", "codes.jsonl"]);
    let output = command.assert().code(2).get_output().clone();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("help: let Moodle download the text of the questions"), "{said}");
}

/// The right answers to the two carts, as Moodle writes the parts of a response.
fn right_response(item: &Item) -> String {
    format!("part 1: {}; part 2: {}; part 3: {}", number(item, 0), number(item, 1), number(item, 2))
}

#[test]
fn rows_are_attempts_of_which_one_counts_and_a_row_of_nobody_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    exported(folder.path(), "moodle");
    let [first, second] = [1, 2].map(|seed| item("impact/two-carts", seed));
    let (one, other) = (&first.code, &second.code);
    let responses = format!(
        "Email address,Question 1,Response 1\none@x,[{one}],{}\none@x,[{other}],-\none@x,[{other}],{}\n,[{one}],-\n",
        right_response(&first),
        right_response(&second),
    );
    fs::write(folder.path().join("responses.csv"), responses).unwrap();
    let total: u32 = first.parts.iter().map(|part| part.field.points).sum();
    let [all, mean] = [f64::from(total), 2.0 * f64::from(total) / 3.0];
    for (rule, points) in
        [(None, all), (Some("best"), all), (Some("last"), all), (Some("first"), all), (Some("mean"), mean)]
    {
        let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
        command.current_dir(folder.path()).args(["grade", "responses.csv", "--codes", "codes.jsonl"]);
        command
            .args(["-o", "marks.csv", "--gradebook", "grades.csv"])
            .args(rule.map(|rule| format!("--attempts={rule}")));
        let output = command.assert().code(2).get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        for part in [
            "students are known by `Email address`",
            "responses.csv:5: nothing stands under `Email address`",
            "1 refused",
        ] {
            assert!(said.contains(part), "{part}: {said}");
        }
        let gradebook = fs::read_to_string(folder.path().join("grades.csv")).unwrap();
        let found: f64 = gradebook.lines().nth(1).unwrap().split(',').nth(1).unwrap().parse().unwrap();
        // Points are written to five decimal places.
        assert!((found - points).abs() <= 0.5e-5, "{rule:?}: {gradebook}");
    }
}

#[test]
fn attempts_are_in_the_order_of_their_numbers_and_two_slots_of_one_problem_stay_two() {
    let folder = tempfile::tempdir().unwrap();
    exported(folder.path(), "moodle");
    let [first, second] = [1, 2].map(|seed| item("impact/two-carts", seed));
    let (one, other) = (&first.code, &second.code);
    // The second attempt stands first; it is right in both slots, the first in one.
    let responses = format!(
        "OrgDefinedId,Attempt #,Question 1,Response 1,Question 2,Response 2\n17,2,[{one}],{},[{other}],{}\n17,1,[{other}],{},[{one}],-\n",
        right_response(&first),
        right_response(&second),
        right_response(&second),
    );
    fs::write(folder.path().join("responses.csv"), responses).unwrap();
    let total: u32 = first.parts.iter().map(|part| part.field.points).sum();
    for (rule, points) in [("last", 2 * total), ("first", total), ("best", 2 * total)] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
        command.current_dir(folder.path()).args(["grade", "responses.csv", "--codes", "codes.jsonl"]);
        command.args(["--student", "OrgDefinedId", "--title", "Quiz 3", "--attempts", rule]);
        // Nothing is carried from one attempt to the other, so that the empty slot stays wrong.
        command.args(["-o", "marks.csv", "--gradebook", "grades.csv"]).assert().code(1);
        let gradebook = fs::read_to_string(folder.path().join("grades.csv")).unwrap();
        let expected = format!("OrgDefinedId,Quiz 3 Points Grade,End-of-Line Indicator\n17,{points},#\n");
        assert_eq!(gradebook, expected, "{rule}");
    }
}
