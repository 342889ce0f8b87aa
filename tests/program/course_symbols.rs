//! The letters that a course writes: printed on sheets, in solutions and figures, and read in answers.

use std::process::Command;

use momentous::fault::Source;
use momentous::problem::{compile, load};

/// `J_B = m_B v_C2`, and `p_2 = m_A v_A1`.
const CARTS: &str = "
id: test/course
title: Course
level: intro
symbols: { momentum: L, impulse: I }
scene:
  axes: { x: to the right }
  bodies: { A: { name: cart A }, B: { name: cart B } }
  stages: [ { impact: { between: [A, B], plastic: true, becomes: C } } ]
given: { m_A: 1 kg, m_B: 3 kg, v_A1: { one_of: [2, 4], unit: m/s }, v_B1: 0 m/s }
text: \"Cart A ({{ m_A }}) runs at {{ v_A1 }} into cart B ({{ m_B }}), which {{ v_B1 | motion }}. Find {{ J_B | symbol }}.\"
ask: [ { find: J_B, unit: N s }, { find: p_2, as: formula }, { find: J_A, as: formula, unit: p_1 } ]
";

/// What the command prints for the file, and whether it ended well.
fn momentous(name: &str, arguments: &[&str]) -> (String, bool) {
    let file = std::env::temp_dir().join(format!("momentous-{}-{name}.yaml", std::process::id()));
    std::fs::write(&file, CARTS).unwrap();
    let file_name = file.display().to_string();
    let arguments = arguments.iter().map(|argument| if *argument == "FILE" { &file_name } else { *argument });
    let output = Command::new(env!("CARGO_BIN_EXE_momentous")).args(arguments).output().unwrap();
    std::fs::remove_file(&file).unwrap();
    (String::from_utf8(output.stdout).unwrap(), output.status.success())
}

#[test]
fn sheets_solutions_and_figures_have_the_letters_of_the_course() {
    let (printed, _) = momentous("print", &["generate", "FILE", "--seed", "1", "--solution"]);
    for course in ["Find $I_{B}$.", "$I_{B}$ (in ", "L_{2}", "I_{A}", "impulse: I_A"] {
        assert!(printed.contains(course), "{course} is missing from\n{printed}");
    }
    for usual in ["J_{", "J_A", "J_B", "p_{"] {
        assert!(!printed.contains(usual), "{usual} is left in\n{printed}");
    }
}

#[test]
fn answers_may_be_typed_in_the_letters_of_the_course() {
    let marked = |answers: [&str; 3]| {
        let answers = answers.map(|answer| format!("--answer={answer}"));
        let [a, b, c] = answers.each_ref().map(String::as_str);
        momentous(
            &answers[0].replace(|sign: char| !sign.is_alphanumeric(), "-"),
            &["grade", "--problem", "FILE", "--seed", "1", a, b, c],
        )
    };
    let (value, _) = momentous("value", &["generate", "FILE", "--seed", "1", "--format", "json"]);
    let record: serde_json::Value = serde_json::from_str(value.lines().next().unwrap()).unwrap();
    let impulse = record["ask"][0]["printed"].as_str().unwrap();
    assert_eq!(record["ask"][2]["printed"], "-m_B*L_1/(m_A + m_B)");
    for name in ["I_B", "J_B"] {
        let (report, right) = marked([&format!("{name}={impulse}"), "L_2=m_A v_A1", "I_A=-m_B L_1/(m_A + m_B)"]);
        assert!(right && report.contains("total: 3/3"), "{report}");
    }
    let (report, right) = marked([&format!("I_B={impulse}"), "p_2=m_A v_A1", "J_A=-m_B p_1/(m_A + m_B)"]);
    assert!(!right && report.contains("`p_1` is not given here"), "{report}");
}

#[test]
fn a_letter_that_stands_for_something_else_is_a_fault() {
    for (letters, message) in [
        ("{ momentum: J }", "`J` stands for another quantity"),
        ("{ momentum: L, impulse: L }", "`L` stands for another quantity"),
        ("{ impulse: v }", "`v` stands for another quantity"),
        ("{ impulse: I_x }", "`I_x` is not a letter"),
        ("{ impuls: I }", "impuls"),
    ] {
        let text = CARTS.replace("{ momentum: L, impulse: I }", letters);
        let faults = load(Source::new("course.yaml", &text)).and_then(|loaded| compile(loaded, None)).unwrap_err();
        assert!(faults.to_string().contains(message), "{faults}");
    }
    let swapped = CARTS.replace("{ momentum: L, impulse: I }", "{ momentum: J, impulse: p }");
    assert!(load(Source::new("course.yaml", &swapped)).and_then(|loaded| compile(loaded, None)).is_ok());
}

/// A course with settings, and with one problem in a topic's folder.
fn course(settings: &str, problem: &str) -> tempfile::TempDir {
    let room = tempfile::tempdir().unwrap();
    let topic = room.path().join("problem_bank/test");
    std::fs::create_dir_all(&topic).unwrap();
    std::fs::write(topic.join("course.yaml"), settings).unwrap();
    std::fs::write(topic.join("carts.yaml"), problem).unwrap();
    room
}

/// What the command prints where it runs in that folder: its output, its errors, and whether it ended well.
fn run_in(room: &tempfile::TempDir, arguments: &[&str]) -> (String, String, bool) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
    let output = command.args(arguments).current_dir(room.path()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr), output.status.success())
}

#[test]
fn the_settings_of_a_course_hold_for_every_problem_of_its_folder() {
    let plain = CARTS.replace("symbols: { momentum: L, impulse: I }\n", "");
    let room = course("symbols: { momentum: L, impulse: I }\n", &plain);
    let sheet = ["generate", "test/course", "--seed", "1", "--solution"];
    let (printed, errors, _) = run_in(&room, &sheet);
    assert!(printed.contains("Find $I_{B}$.") && printed.contains("L_{2}"), "{printed}{errors}");
    let (report, _, right) = run_in(&room, &["check", "--seeds", "4"]);
    assert!(right && report.contains("1 problem, 1 form"), "{report}");

    let numbers = ["generate", "test/course", "--seed", "1", "--format", "json"];
    let given = |room| serde_json::from_str::<serde_json::Value>(&run_in(room, &numbers).0).unwrap()["given"].clone();
    assert_eq!(given(&room), given(&course("symbols: {}\n", &plain)), "the letters change no number");

    let answers = ["--answer=I_B=2", "--answer=L_2=m_A v_A1", "--answer=I_A=-m_B L_1/(m_A + m_B)"];
    let (report, ..) = run_in(&room, &[&["grade", "--problem", "test/course", "--seed", "1"], &answers[..]].concat());
    assert!(!report.contains("not given here"), "{report}");
}

#[test]
fn a_problem_says_its_own_letters_and_the_nearest_settings_count() {
    let other_letters = CARTS.replace("{ momentum: L, impulse: I }", "{ impulse: K }");
    let room = course("symbols: { momentum: L, impulse: I }\n", &other_letters);
    std::fs::write(room.path().join("problem_bank/course.yaml"), "symbols: { momentum: Q }\n").unwrap();
    let (printed, errors, _) = run_in(&room, &["generate", "test/course", "--seed", "1"]);
    assert!(printed.contains("Find $K_{B}$.") && printed.contains("L_{2}"), "{printed}{errors}");
}

#[test]
fn settings_alone_hold_for_the_bank_that_is_built_in() {
    let room = tempfile::tempdir().unwrap();
    std::fs::create_dir(room.path().join("problem_bank")).unwrap();
    std::fs::write(room.path().join("problem_bank/course.yaml"), "symbols: { impulse: I }\n").unwrap();
    let (printed, errors, _) = run_in(&room, &["generate", "impulse/tennis-return", "--seed", "1", "--solution"]);
    assert!(printed.contains("I_{") && !printed.contains("J_{"), "{printed}{errors}");
}

#[cfg(unix)]
#[test]
fn settings_that_cannot_be_looked_at_are_not_left_aside() {
    let room = course("symbols: {}\n", CARTS);
    let settings = room.path().join("problem_bank/test/course.yaml");
    std::fs::remove_file(&settings).unwrap();
    std::os::unix::fs::symlink(&settings, &settings).unwrap();
    let (printed, errors, right) = run_in(&room, &["generate", "test/course", "--seed", "1"]);
    assert!(!right && errors.contains("course.yaml"), "{printed}{errors}");
}

#[test]
fn a_fault_of_the_settings_is_told_at_its_place() {
    for (settings, message) in [
        ("symbols: { momentum: v }\n", "`v` stands for another quantity"),
        ("symbol: { momentum: L }\n", "did you mean `symbols`?"),
    ] {
        let room = course(settings, CARTS);
        let (_, errors, right) = run_in(&room, &["generate", "test/course", "--seed", "1"]);
        assert!(!right && errors.contains(message) && errors.contains("test/course.yaml:1:"), "{errors}");
    }
}
