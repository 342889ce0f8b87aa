//! Work as students write it, compared with a tutor's key.

use std::collections::BTreeMap;
use std::fs;

use momentous::grade::DecimalMark;
use momentous::work::{Judge, Verdict};
use serde::Deserialize;

use super::drawn;

/// So many of the lines are judged as the key says; of 440.
const AGREED: usize = 395;
/// No more of them cannot be read or decided.
const OPEN: usize = 35;

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

#[test]
fn lines_are_judged_as_a_tutor_judges_them() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/work/students.yaml");
    let works: Vec<Work> = serde_yaml::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let (mut agreed, mut open, mut lines) = (0, Vec::new(), 0);
    let mut apart: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for work in &works {
        let exercise = drawn(&work.problem, work.seed);
        let mut judge = Judge::new(exercise.worked(), DecimalMark::Point);
        for line in &work.lines {
            let judged = judge.line(&line.text);
            lines += 1;
            let said =
                format!("{:?} {:?} {} [{}] -> {}", line.key, judged.verdict, line.text, line.why, judged.message);
            match agrees(line.key, judged.verdict) {
                Some(true) => agreed += 1,
                Some(false) => apart.entry(format!("{} ({})", work.problem, work.student)).or_default().push(said),
                None => open.push(format!("{} {said}", work.problem)),
            }
        }
    }
    let apart: Vec<String> =
        apart.into_iter().map(|(work, lines)| format!("{work}\n  {}", lines.join("\n  "))).collect();
    assert!(agreed >= AGREED, "{agreed} of {lines}\n{}\nopen:\n  {}", apart.join("\n"), open.join("\n  "));
    assert!(open.len() <= OPEN, "{}:\n  {}", open.len(), open.join("\n  "));
}
