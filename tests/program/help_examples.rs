//! What `momentous help` shows runs: the examples of every command, in a course folder with the files that they name.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use crate::room::Room;

/// Examples that are left out, by what they contain, and why.
const LEFT_OUT: [(&str, &str); 14] = [
    ("serve", "runs until it is stopped; tests/classes runs it"),
    ("chart", "measures for a minute"),
    ("> ", "a name that the shell takes"),
    ("| jq", "needs jq"),
    ("--format pdf", "needs the feature pdf; tests/pdf runs it"),
    ("--count 100000", "takes minutes where nothing is optimised"),
    ("momentous check", "takes minutes where nothing is optimised; the README's first hour runs it"),
    ("momentous diagnose", "takes minutes where nothing is optimised"),
    ("momentous snapshot", "takes minutes where nothing is optimised; cli/snapshot.rs runs it"),
    ("momentous page", "needs the engine for browsers; tests/browser runs it"),
    ("momentous secret", "has run before the others"),
    ("homework/week-3.yaml", "homework.rs runs it"),
    ("--codes", "tests/exports runs it"),
    ("--changes", "the README's first hour runs it"),
];

/// Problems of the folder, of those that are built in.
const PROBLEMS: [&str; 3] = ["impact/two-carts", "bouncing/rubber-ball", "central-force/comet-visit"];

const SUBMISSIONS: &str = "student,problem,seed,form,v_A2,v_B2\ns17,impact/two-carts,1,forward,-0.5 m/s,4 m/s\n";
const SUBMISSIONS_JSON: &str =
    r#"{"student":"s17","problem":"impact/two-carts","seed":1,"form":"forward","answers":{"v_A2":"-0.5 m/s"}}"#;

/// A course folder with every file that an example names.
fn course() -> Room {
    let room = Room::with(&[
        ("class.csv", "id,name\ns17,Ada Example\n"),
        ("lines.txt", "m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2\n"),
        ("submissions.csv", SUBMISSIONS),
        ("submissions.jsonl", SUBMISSIONS_JSON),
    ]);
    for problem in PROBLEMS {
        let path = room.path(&format!("problem_bank/{problem}.yaml"));
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, room.fine(&["show", problem])).unwrap();
    }
    room.fine(&["secret", "secret.txt"]);
    for name in ["my-carts.yaml", "my-problem.yaml"] {
        room.fine(&["new", name]);
    }
    room.fine(&[
        "generate",
        "impact/two-carts",
        "--roster",
        "class.csv",
        "--secret",
        "secret.txt",
        "-o",
        "handed-out/",
    ]);
    std::fs::copy(room.path("handed-out-teacher/seeds.csv"), room.path("seeds.csv")).unwrap();
    room
}

/// Runs a line by a shell that finds the program.
fn shell(folder: &Path, line: &str) -> (Option<i32>, String) {
    let program = Path::new(env!("CARGO_BIN_EXE_momentous")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    let output = Command::new("sh").args(["-c", line]).current_dir(folder).env("PATH", path).output().unwrap();
    let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    (output.status.code(), said.concat())
}

/// The examples of a page of help, each a command without what is said of it.
fn examples(help: &str) -> Vec<String> {
    let mut examples: Vec<String> = Vec::new();
    let mut is_open = false;
    for line in help.lines() {
        let is_first = line.starts_with("  momentous ");
        if is_first || is_open {
            is_open = line.ends_with('\\');
            let command = line.trim().trim_end_matches('\\');
            let command = command.split("   ").next().unwrap_or(command);
            match examples.last_mut().filter(|_| !is_first) {
                Some(last) => last.push_str(command),
                None => examples.push(command.to_owned()),
            }
        }
    }
    examples
}

#[cfg(unix)]
#[test]
fn every_example_of_help_runs() {
    let room = course();
    // Nothing is broken into lines there.
    let help = |name: Option<&str>| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
        let output = command.args(name).arg("--help").env("COLUMNS", "400").output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let main = help(None);
    let (_, commands) = main.split_once("Commands:").unwrap();
    let names =
        commands.lines().skip(1).take_while(|line| line.starts_with("  ")).filter(|line| !line.starts_with("   "));
    let names: Vec<&str> =
        names.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help").collect();
    let pages = names.iter().map(|name| help(Some(name))).chain([main.clone()]);
    let all: BTreeSet<String> = pages.flat_map(|help| examples(&help)).collect();
    assert!(names.len() > 15 && all.len() > 60, "{names:?}\n{all:#?}");
    let mut failed = Vec::new();
    for line in all.iter().filter(|line| !LEFT_OUT.iter().any(|(part, _)| line.contains(part))) {
        let (code, said) = shell(room.0.path(), line);
        // 1 is the answer of a check: an example may well show one that fails.
        if !matches!(code, Some(0 | 1)) {
            failed.push(format!("{line}: {code:?}\n{said}"));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
