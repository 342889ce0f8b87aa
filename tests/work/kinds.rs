//! Kinds of lines that were once judged otherwise than a tutor would, each with its verdicts and the points for all of them.

use std::fs;

use momentous::grade::DecimalMark;
use momentous::work::{Judge, judge};
use serde::Deserialize;

use super::drawn;

#[derive(Deserialize)]
struct Kind {
    shows: String,
    problem: String,
    seed: u64,
    lines: Vec<Line>,
    /// The points for all lines.
    points: u32,
}

#[derive(Deserialize)]
struct Line {
    text: String,
    verdict: serde_yaml::Value,
}

#[test]
fn each_kind_of_line_is_judged_as_a_tutor_would() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/work/kinds.yaml");
    let kinds: Vec<Kind> = serde_yaml::from_str(&fs::read_to_string(path).unwrap()).unwrap();
    let mut apart = Vec::new();
    for kind in &kinds {
        let exercise = drawn(&kind.problem, kind.seed);
        let mut judge = Judge::new(exercise.worked(), DecimalMark::Point);
        let judged: Vec<_> = kind.lines.iter().map(|line| judge.line(&line.text)).collect();
        for (line, judged) in kind.lines.iter().zip(&judged) {
            if serde_yaml::to_value(judged.verdict).unwrap() != line.verdict {
                apart.push(format!("{}: {}: {:?}: {}", kind.shows, line.text, judged.verdict, judged.message));
            }
        }
        let (report, _) = judge.conclude(judged);
        if report.points != kind.points {
            apart.push(format!("{}: {}: {} points", kind.shows, kind.problem, report.points));
        }
    }
    assert!(apart.is_empty(), "{}", apart.join("\n"));
}

/// Whoever takes the other direction as positive and copies the hints comes to every answer.
#[test]
fn hints_follow_the_direction_that_is_taken_as_positive() {
    for problem in ["impact/two-carts", "chains/siding-bumper", "conservation/coupling-wagons"] {
        let exercise = drawn(problem, 5);
        let mut work = "take left as positive".to_owned();
        let mut steps = 0;
        while let (report, Some(next)) = judge(exercise.worked(), &work, DecimalMark::Point) {
            assert!(report.lines.iter().all(|line| !line.verdict.is_wrong()), "{report}");
            work = format!("{work}\n{}", next.numbers);
            steps += 1;
            assert!(steps < 12, "{problem}\n{work}\n{report}");
        }
        let (report, _) = judge(exercise.worked(), &work, DecimalMark::Point);
        assert_eq!(report.points, report.out_of, "{report}");
    }
}

#[test]
fn hints_of_a_sheet_in_letters_hold_no_numbers_of_its_scene() {
    let exercise = drawn("concepts/coupling-in-symbols", 5);
    let (_, next) = judge(exercise.worked(), "", DecimalMark::Point);
    let hint = next.unwrap().numbers;
    assert!(hint.contains("m_A*v_A1") && !hint.contains("kg") && !hint.contains(" t)"), "{hint}");
}
