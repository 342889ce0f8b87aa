//! Work as students write it, compared with a tutor's key.

use std::fs;

use momentous::grade::DecimalMark;
use momentous::work::{Judge, Verdict};
use serde::Deserialize;

use super::drawn;

/// A file of work: how many lines it has, how many at least are judged as the key says, and how many at most cannot be read or decided.
struct Set {
    file: &'static str,
    lines: usize,
    agreed: usize,
    open: usize,
}

const SETS: [Set; 3] = [
    Set { file: "students", lines: 440, agreed: 419, open: 17 },
    Set { file: "newcomers", lines: 93, agreed: 87, open: 6 },
    Set { file: "strangers", lines: 60, agreed: 55, open: 5 },
];

#[derive(Deserialize)]
struct Work {
    problem: String,
    seed: u64,
    student: String,
    lines: Vec<Keyed>,
}

#[derive(Deserialize)]
struct Keyed {
    text: String,
    key: Key,
    why: String,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord)]
#[serde(rename_all = "kebab-case")]
enum Key {
    Right,
    Wrong,
    Trivial,
    Remark,
}

/// Whether a verdict agrees with a tutor's; what cannot be read or decided is never wrong, and counted apart.
fn agrees(key: Key, verdict: Verdict) -> Option<bool> {
    if matches!(verdict, Verdict::Unreadable | Verdict::Undecided) {
        return None;
    }
    Some(match key {
        Key::Right | Key::Trivial => verdict.is_true() || verdict == Verdict::Convention,
        Key::Wrong if verdict == Verdict::OwnLetter => return None,
        Key::Wrong => verdict.is_wrong() || verdict == Verdict::Coincidence,
        Key::Remark => matches!(verdict, Verdict::Remark | Verdict::Convention) || verdict.is_true(),
    })
}

/// The lines of a file that are judged otherwise than the key says, and those that cannot be read or decided.
struct Apart {
    lines: usize,
    otherwise: Vec<String>,
    open: Vec<String>,
}

fn apart(file: &str) -> Apart {
    let path = format!("{}/tests/fixtures/work/{file}.yaml", env!("CARGO_MANIFEST_DIR"));
    let works: Vec<Work> = serde_yaml::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let mut apart = Apart { lines: 0, otherwise: Vec::new(), open: Vec::new() };
    for work in &works {
        let exercise = drawn(&work.problem, work.seed);
        let mut judge = Judge::new(exercise.worked(), DecimalMark::Point);
        for line in &work.lines {
            let judged = judge.line(&line.text);
            apart.lines += 1;
            let Keyed { text, key, why } = line;
            let said = format!(
                "{} ({}) {key:?} {:?} {text} [{why}] -> {}",
                work.problem, work.student, judged.verdict, judged.message
            );
            match agrees(line.key, judged.verdict) {
                Some(true) => {}
                Some(false) => apart.otherwise.push(said),
                None => apart.open.push(said),
            }
        }
    }
    apart
}

#[test]
fn lines_are_judged_as_a_tutor_judges_them() {
    for set in SETS {
        let Apart { lines, otherwise, open } = apart(set.file);
        let agreed = lines - otherwise.len() - open.len();
        let list = || format!("{}\nopen:\n  {}", otherwise.join("\n"), open.join("\n  "));
        assert_eq!(lines, set.lines);
        assert!(
            agreed >= set.agreed && open.len() <= set.open,
            "{}: {agreed} of {lines}, {} open\n{}",
            set.file,
            open.len(),
            list()
        );
    }
}
