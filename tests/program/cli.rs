//! The program end to end: every subcommand, its exit codes, and what it says of input that it cannot use.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

use crate::room::Room;
use crate::room::lines;

mod chart;
mod gallery;
mod json;
mod simulate;
mod snapshots;
mod unusable;

/// The printed answers of a variant, as arguments for `grade`.
fn printed(record: &Value) -> Vec<String> {
    let part = |part: &Value| {
        let answer = part["printed"].as_str().or(part["value"].as_str()).unwrap();
        format!("{}={answer}", part["id"].as_str().unwrap())
    };
    record["ask"].as_array().unwrap().iter().map(part).collect()
}

#[test]
fn list_shows_the_built_in_bank_anywhere() {
    let room = Room::empty();
    let bank = lines(&room.fine(&["list", "--format", "json"]));
    assert!(bank.len() >= 14);
    let ids: Vec<&str> = bank.iter().map(|card| card["id"].as_str().unwrap()).collect();
    assert!(ids.is_sorted() && ids.contains(&"impact/two-carts"));
    let carts = bank.iter().find(|card| card["id"] == "impact/two-carts").unwrap();
    assert_eq!(carts["forms"], serde_json::json!(["forward", "find-e"]));
    assert_eq!((&carts["topic"], &carts["level"]), (&"impact".into(), &"intro".into()));
    let table = room.fine(&["list", "--topic", "impact", "--format", "table"]);
    assert!(table.starts_with("PROBLEM") && table.lines().skip(1).all(|line| line.starts_with("impact/")));
    assert!(!table.contains('\u{1b}'), "colours are for terminals only");
}

#[test]
fn a_bank_in_the_folder_takes_the_place_of_the_built_in_one() {
    let room = Room::with(&[("problem_bank/.keep", "")]);
    room.fine(&["new", "impact/my-carts"]);
    let cards = lines(&room.fine(&["list", "--format", "json"]));
    assert_eq!((cards.len(), &cards[0]["id"]), (1, &"impact/my-carts".into()));
    assert_eq!(room.run(&["generate", "impact/two-carts"]).code, 2);
    room.fine(&["check", "--seeds", "20"]);
}

#[test]
fn a_problem_that_is_there_is_left_alone() {
    let room = Room::empty();
    room.fine(&["new", "impact/my-carts"]);
    let ran = room.run(&["new", "impact/my-carts"]);
    assert!(ran.code == 2 && ran.err.contains("my-carts.yaml already exists"), "{}", ran.err);
}

#[test]
fn conditions_compare_what_can_be_compared_and_are_told_once() {
    let room = Room::empty();
    room.fine(&["new", "impact/my-carts"]);
    let broken = room.read("my-carts.yaml").replace("\nforms:", "\nwhere: [ v_A2 > 3 kg ]\nforms:");
    fs::write(room.path("my-carts.yaml"), broken).unwrap();
    let ran = room.run(&["generate", "my-carts.yaml"]);
    let message = "`v_A2 > 3 kg` compares a velocity with a mass";
    assert!(ran.code == 2 && ran.err.matches(message).count() == 1, "{}", ran.err);
}

#[test]
fn one_broken_file_does_not_hide_the_others_of_a_bank() {
    let room = Room::with(&[("problem_bank/a/bad.yaml", "id: a/bad\n")]);
    room.fine(&["new", "a/good"]);
    let ran = room.run(&["list"]);
    assert_eq!(ran.code, 2);
    assert!(ran.out.contains("a/good") && ran.err.contains("problem_bank/a/bad.yaml"), "{}{}", ran.out, ran.err);
}

#[test]
fn two_files_with_one_identity_are_told() {
    let room = Room::with(&[("problem_bank/.keep", "")]);
    room.fine(&["new", "a/good"]);
    fs::copy(room.path("problem_bank/a/good.yaml"), room.path("problem_bank/a/twin.yaml")).unwrap();
    let ran = room.run(&["list"]);
    assert!(
        ran.code == 2 && ran.err.contains("`a/good` is also the identity of problem_bank/a/good.yaml"),
        "{}",
        ran.err
    );
}

#[test]
fn the_collision_of_the_seed_page() {
    let given = ["m_A=3 kg", "m_B=2 kg", "v_A1=3 m/s", "v_B1=-2 m/s", "e=0.7"];
    let find = [("v_A2", -0.4), ("v_B2", 3.1), ("T_1", 17.5), ("T_2", 9.85), ("T_lost", 7.65)];
    let mut arguments = vec!["solve", "impact/two-carts", "--format", "json"];
    for value in &given {
        arguments.extend(["--set", value]);
    }
    for (name, _) in &find {
        arguments.extend(["--find", name]);
    }
    let record = &lines(&Room::empty().fine(&arguments))[0];
    for (part, (name, value)) in record["ask"].as_array().unwrap().iter().zip(find) {
        assert_eq!(part["id"], name);
        let bound = part["error_bound"].as_f64().unwrap();
        assert!((part["value"].as_f64().unwrap() - value).abs() <= bound && bound < 1e-12, "{part}");
    }
    assert_eq!(record["given"]["e"]["value"], "0.7");
    assert!(record["solution"].as_str().unwrap().contains("-0.4"));
}

#[test]
fn solve_shows_how_in_every_format() {
    let room = Room::empty();
    let markdown = room.fine(&["solve", "impact/two-carts", "--seed", "3"]);
    assert!(markdown.contains("Laws") && !markdown.contains("ertificate"));
    assert!(room.fine(&["solve", "impact/two-carts", "--instructor"]).len() > markdown.len());
    assert!(room.fine(&["solve", "impact/two-carts", "--faded", "1"]).len() < markdown.len());
    let short = room.fine(&["solve", "impact/two-carts"]);
    let full = room.fine(&["solve", "impact/two-carts", "--detailed"]);
    let answer = full.lines().find(|line| line.starts_with("The velocity of")).unwrap();
    let numbered = |text: &str| text.matches("\\tag{").count();
    assert!(short.contains("so by conservation of linear momentum:") && short.contains(answer), "{short}");
    assert!(numbered(&short) == 2 && numbered(&full) > 2, "{short}");
    assert!(full.contains("Check:") && !short.contains("Check:"), "{short}");
    assert!(room.fine(&["solve", "impact/two-carts", "--format", "latex"]).contains("\\documentclass"));
    let page = room.fine(&["solve", "impact/two-carts", "--format", "html"]);
    let bare = room.fine(&["solve", "impact/two-carts", "--format", "html", "--no-font"]);
    assert!(page.starts_with("<!") && page.contains("@font-face") && !bare.contains("@font-face"));
}

#[test]
fn generate_repeats_itself_and_follows_its_seeds() {
    let room = Room::empty();
    let arguments = ["generate", "impact/two-carts", "--seed", "4", "--count", "3", "--format", "json"];
    let three = room.fine(&arguments);
    assert_eq!(three, room.fine(&arguments));
    let seeds: Vec<u64> = lines(&three).iter().map(|record| record["seed"].as_u64().unwrap()).collect();
    assert_eq!(seeds, [4, 5, 6]);
    let last = room.fine(&["generate", "impact/two-carts", "--seed", "6", "--format", "json"]);
    assert_eq!(three.lines().last(), last.lines().next());
    let record = &lines(&last)[0];
    for key in ["problem", "digest", "scheme", "seed", "form", "text", "given", "ask"] {
        assert!(!record[key].is_null(), "{key}");
    }
    assert!(record.get("solution").is_none());
    let solved = room.fine(&["generate", "impact/two-carts", "--format", "json", "--solution"]);
    assert!(lines(&solved)[0]["solution"].as_str().unwrap().contains("## "));
}

#[test]
fn generate_makes_one_document_or_many() {
    let room = Room::empty();
    let sheet = room.fine(&["generate", "impact/two-carts", "--seed", "7"]);
    let all = room.fine(&["generate", "impact/two-carts", "--seed", "7", "--solution", "--key"]);
    assert!(all.len() > sheet.len() && all.contains("Answers") && !sheet.contains("Answers"));
    room.fine(&["generate", "impact/two-carts", "--count", "2", "--key", "--format", "latex", "-o", "deep/exam.tex"]);
    let exam = room.read("deep/exam.tex");
    assert_eq!((exam.matches("\\documentclass").count(), exam.matches("\\end{document}").count()), (1, 1));
    assert_eq!(room.names("deep"), ["exam.tex"], "nothing temporary is left");
    room.fine(&["generate", "impact/two-carts", "--form", "find-e", "--solution", "--key", "-o", "sheets/"]);
    let names = room.names("sheets");
    for name in ["impact-two-carts-find-e-seed-1.md", "impact-two-carts-find-e-seed-1-solution.md"] {
        assert!(names.contains(&name.to_owned()), "{names:?}");
    }
    assert_eq!(room.names("sheets-teacher"), ["key.md"]);
}

#[test]
fn a_roster_gives_each_student_numbers_that_only_the_secret_tells() {
    let room = Room::with(&[("class.csv", "name;id\nAda;s1\nBob;s2\n"), ("secret.txt", "course 2026\n")]);
    let arguments = ["generate", "impact/two-carts", "--roster", "class.csv", "--format", "json"];
    let with = |more: &[&str]| room.fine(&[&arguments[..], more].concat());
    with(&["--secret", "secret.txt", "-o", "a/"]);
    let files = ["s1-impact-two-carts-forward.json", "s2-impact-two-carts-forward.json", "seeds.csv"];
    assert_eq!(room.names("a-teacher"), files);
    let record = &lines(&room.read("a-teacher/s1-impact-two-carts-forward.json"))[0];
    assert_eq!((&record["student"]["name"], &record["student"]["id"]), (&"Ada".into(), &"s1".into()));
    let seed = record["seed"].to_string();
    assert!(
        room.read("a-teacher/seeds.csv")
            .contains(&format!("s1,Ada,impact/two-carts,{},forward,s{seed}", record["digest"].as_str().unwrap()))
    );
    // The seed alone draws other numbers.
    let open = &lines(&room.fine(&["generate", "impact/two-carts", "--seed", &seed, "--format", "json"]))[0];
    assert_ne!(open["given"], record["given"]);
    let keyed = ["generate", "impact/two-carts", "--seed", &seed, "--secret", "secret.txt", "--format", "json"];
    assert_eq!(lines(&room.fine(&keyed))[0]["given"], record["given"]);
    // One document beside its table of seeds.
    with(&["-o", "all.jsonl"]);
    assert_eq!((room.read("all.jsonl").lines().count(), room.read("all-teacher/seeds.csv").lines().count()), (2, 3));
}

#[test]
fn grade_marks_one_set_of_answers() {
    let room = Room::empty();
    let record = &lines(&room.fine(&["generate", "impact/two-carts", "--seed", "7", "--format", "json"]))[0];
    let answers = printed(record);
    let grade = |answers: &[&str], more: &[&str]| {
        let mut arguments = vec!["grade", "--problem", "impact/two-carts", "--seed", "7"];
        for answer in answers {
            arguments.extend(["--answer", answer]);
        }
        room.run(&[&arguments[..], more].concat())
    };
    let right: Vec<&str> = answers.iter().map(String::as_str).collect();
    let all = grade(&right, &["--format", "json"]);
    let report = &lines(&all.out)[0];
    assert_eq!((all.code, report["total"].as_f64(), report["out_of"].as_u64()), (0, Some(5.0), Some(5)), "{}", all.out);
    assert_eq!((report["parts"][0]["verdict"].as_str(), report["seed"].as_u64()), (Some("right"), Some(7)));
    assert_eq!(grade(&right[..1], &[]).code, 1, "what is not answered is not right");
    assert_eq!(grade(&["v_A2=1.00e9 m/s"], &[]).code, 1);
    let unreadable = grade(&["v_A2=3..2 m/s"], &[]);
    assert!(unreadable.code == 2 && unreadable.out.contains("unreadable"), "{}", unreadable.out);
    let commas: Vec<String> = answers.iter().map(|answer| answer.replace('.', ",")).collect();
    let commas: Vec<&str> = commas.iter().map(String::as_str).collect();
    assert_eq!(grade(&commas, &["--decimal", "comma"]).code, 0);
}

#[test]
fn grade_marks_a_table_and_keeps_going_at_a_bad_row() {
    let room = Room::empty();
    let record = &lines(&room.fine(&["generate", "impact/two-carts", "--seed", "7", "--format", "json"]))[0];
    let cells: Vec<String> =
        printed(record).iter().map(|answer| answer.split_once('=').unwrap().1.to_owned()).collect();
    let digest = record["digest"].as_str().unwrap();
    let head = "student,problem,digest,seed,form,attempt,v_A2,v_B2,T_lost";
    let good = format!("s1,impact/two-carts,{digest},7,forward,1,{}", cells.join(","));
    let again = good.replacen("forward,1,", "forward,2,", 1);
    fs::write(room.path("good.csv"), format!("{head}\n{good}\n{again}\n")).unwrap();
    let marks = room.fine(&["grade", "good.csv"]);
    assert_eq!(marks.lines().count(), 1 + 2 * 3);
    assert!(marks.lines().nth(1).unwrap().starts_with("2,s1,impact/two-carts,7,forward,1,v_A2,2,2,right,"), "{marks}");

    let rows = [
        "s2,impact/two-carts,,7,forward,1,100 m/s,banana,",
        "s3,impact/no-carts,,7,forward,1,1,1,1",
        "s4,impact/two-carts,,seven,forward,1,1,1,1",
        "s5,impact/two-carts,0000000000000000,7,forward,1,1,1,1",
        "s6,impact/two-carts,,7,backward,1,1,1,1",
        "s7,impact/two-carts,,7,forward",
        "s8,impact/two-carts,,7,find-e,1,1,1,1",
        &good,
    ];
    fs::write(room.path("mixed.csv"), format!("{head}\n{}\n", rows.join("\n"))).unwrap();
    let ran = room.run(&["grade", "mixed.csv", "-o", "marks.csv"]);
    assert_eq!(ran.code, 2);
    for line in 3..=8 {
        assert!(ran.err.contains(&format!("mixed.csv:{line}: ")), "line {line}\n{}", ran.err);
    }
    assert!(ran.err.contains("8 rows read: 2 marked (6 answers), 6 refused"), "{}", ran.err);
    let marks = room.read("marks.csv");
    let verdicts: Vec<&str> = marks.lines().skip(1).filter_map(|line| line.split(',').nth(9)).collect();
    assert_eq!(verdicts, ["wrong", "unreadable", "unanswered", "right", "right", "right"], "{marks}");
}

#[test]
fn check_tells_what_is_promised_and_what_was_not_looked_at() {
    let room = Room::empty();
    let text = room.fine(&["check", "impact/two-carts", "--seeds", "50"]);
    for part in [
        "find-e",
        "key-marks, simulation",
        "for an answer in 0.0 %",
        "0.1 % error would be detected in: v_A2, v_B2, T_lost",
        "restitution",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let json = room.fine(&["check", "impact/two-carts", "--seeds", "50", "--format", "json"]);
    let audit = &lines(&json)[0];
    assert_eq!((&audit["problem"], audit["forms"].as_array().unwrap().len()), (&"impact/two-carts".into(), 2));
    assert_eq!(audit["forms"][0]["promises"][0]["outcome"], "kept");
    assert_eq!(audit["forms"][1]["simulation"]["witnessed"][0], "e");
    assert_eq!(json, room.fine(&["check", "impact/two-carts", "--seeds", "50", "--format", "json"]));
}

#[test]
fn check_says_where_nothing_needed_simulating() {
    let file = format!("{}/tests/fixtures/found/roots_all.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = Room::empty().fine(&["check", &file, "--seeds", "5"]);
    assert!(text.contains("nothing needed simulating: 5 seeds by formulas of its own; "), "{text}");
}

#[test]
fn check_finds_promises_that_are_broken() {
    let problem = "\
id: a/b
title: B
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: cart A, mass: m_A }, B: { name: cart B, mass: m_A } }
  stages:
    - impact: { between: [A, B], restitution: e }
given:
  m_A: { min: 1, max: 6, step: 0.5, unit: kg }
  v_A1: { min: 2, max: 6, step: 0.5, unit: m/s }
  v_B1: 0 m/s
  e: 1
require:
  - v_A1 > v_B1 - 100 m/s
text: Cart A ({{ m_A }}) moves {{ v_A1 | motion }} and hits its twin, which {{ v_B1 | motion }}; $e$ = {{ e }}.
ask:
  - { find: v_A2, unit: m/s }
  - { find: v_B2, unit: m/s }
";
    let room = Room::with(&[("b.yaml", problem)]);
    let ran = room.run(&["check", "b.yaml", "--seeds", "100"]);
    assert_eq!(ran.code, 1, "{}{}", ran.out, ran.err);
    for said in ["`v_A2` is always", "`v_B2` equals a given in 100.0 %", "`v_A1 > v_B1 - 100 m/s` never rejects a draw"]
    {
        assert!(ran.out.contains(said), "{said}\n{}", ran.out);
    }
}

#[test]
fn a_new_problem_is_sound_and_never_overwrites() {
    let room = Room::empty();
    let said = room.fine(&["new", "impact/my-carts"]);
    assert!(said.contains("momentous check my-carts.yaml"), "{said}");
    let check = room.fine(&["check", "my-carts.yaml", "--seeds", "100"]);
    assert!(!check.contains("broken"), "{check}");
    room.fine(&["generate", "my-carts.yaml", "--solution"]);
    fs::write(room.path("my-carts.yaml"), "mine").unwrap();
    assert_eq!(room.run(&["new", "impact/my-carts"]).code, 2);
    assert_eq!(room.read("my-carts.yaml"), "mine");
    assert_eq!(room.run(&["new", "Impact/My Carts"]).code, 2);
}

#[test]
fn schema_and_completions_print() {
    let room = Room::empty();
    let schema: Value = serde_json::from_str(&room.fine(&["schema"])).unwrap();
    assert!(schema["properties"]["scene"]["description"].is_string());
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(room.fine(&["completions", shell]).contains("generate"), "{shell}");
    }
}

#[test]
fn help_teaches_by_example() {
    let room = Room::empty();
    assert!(room.fine(&["--help"]).contains("Exit codes:"));
    for command in ["list", "check", "generate", "solve", "grade", "new", "snapshot", "schema", "completions"] {
        let help = room.fine(&[command, "--help"]);
        assert!(help.contains(&format!("  momentous {command}")), "{help}");
    }
}

#[test]
fn a_users_own_templates_take_the_place_of_the_built_in_ones() {
    let room = Room::with(&[("templates/markdown/document.tera", "Nothing but this.\n")]);
    assert!(room.fine(&["generate", "impact/two-carts"]).contains("Nothing but this."));
    fs::write(room.path("templates/markdown/document.tera"), "line\n{{ nonsense }}\n").unwrap();
    let ran = room.run(&["generate", "impact/two-carts", "-o", "out.md"]);
    assert!(ran.code == 2 && ran.err.contains("document.tera:2"), "{}", ran.err);
    assert!(!room.path("out.md").exists());
}

#[test]
fn a_reader_that_leaves_early_is_no_fault() {
    let room = Room::empty();
    let program = assert_cmd::cargo::cargo_bin("momentous");
    let script = format!("{} generate impact/two-carts --count 3000 --format json | head -n 1", program.display());
    let output = std::process::Command::new("sh").args(["-c", &script]).current_dir(room.0.path()).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 1);
}

#[test]
fn the_bank_of_this_package_is_the_one_that_is_built_in() {
    let room = Room::empty();
    let mut command = Command::cargo_bin("momentous").unwrap();
    let here = command.current_dir(Path::new(env!("CARGO_MANIFEST_DIR"))).args(["list"]).output().unwrap();
    assert_eq!(String::from_utf8(here.stdout).unwrap(), room.fine(&["list"]));
}
