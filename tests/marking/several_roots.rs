//! Several values of one quantity: each right one counts, and each wrong one takes away a right one.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::{DecimalMark, Report};
use momentous::problem::{compile, load};

/// 4 m above the ground at 10 m/s: with g = 9.81 m/s², after 0.5465 s and 1.4922 s.
fn exercise(points: u32) -> Exercise {
    let yaml = format!(
        "
id: impulse/twice-at-one-height
title: Twice at the same height
level: core
scene:
  axes: {{ y: upwards }}
  plane: vertical
  bodies:
    ball: {{ name: the ball, mass: m }}
  stages:
    - flight: {{ body: ball, during: dt }}
given:
  m: any
  r_ball1: 0 m
  v_ball1: 10 m/s
  r_ball2: 4 m
roots: all
text: A ball is thrown {{{{ v_ball1 | motion }}}} from {{{{ r_ball1 }}}}. When is it at {{{{ r_ball2 }}}}?
ask:
  - {{ find: dt, unit: s, points: {points} }}
"
    );
    let loaded = load(Source::new("roots.yaml", &yaml)).unwrap_or_else(|faults| panic!("{faults}"));
    let problem = Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}")));
    Exercise::draw(&problem, 0, 1).unwrap_or_else(|reason| panic!("{reason}"))
}

fn marked(exercise: &Exercise, answer: &str) -> Report {
    exercise.grade(&BTreeMap::from([("dt".to_owned(), answer.to_owned())]), DecimalMark::Point)
}

#[test]
fn right_values_count_and_wrong_ones_take_away() {
    // Out of four points.
    let table = [
        ("0.547 s or 1.49 s", "4", "right"),
        ("1.49 s or 0.547 s", "4", "right"),
        ("0.547 or 1.49 s", "4", "right"),
        ("1.49, 0.547 s", "4", "right"),
        ("t = 0.547 s, t = 1.49 s", "4", "right"),
        ("0.547 s", "2", "some_values"),
        ("0.547 s or 2 s", "0", "some_values"),
        ("0.547 s or 1.49 s or 3 s", "2", "some_values"),
        ("0.547 s or 1.49 s or 3 s or 4 s", "0", "some_values"),
        ("0.547 s or 0.547 s", "0", "some_values"),
        ("2 s or 3 s", "0", "wrong"),
        ("0.547 or 1.49", "2", "unit_missing"),
        ("0.547 s or 1..49 s", "0", "unreadable"),
        ("", "0", "unanswered"),
    ];
    for (answer, points, verdict) in table {
        let report = marked(&exercise(4), answer);
        assert_eq!(report.parts.len(), 1, "{answer}");
        assert_eq!(
            (report.total.to_string().as_str(), report.parts[0].verdict.code(), report.out_of),
            (points, verdict, 4),
            "{answer}"
        );
        assert_eq!(report.parts[0].id, "dt");
    }
}

#[test]
fn one_point_is_shared_by_halves() {
    assert_eq!(marked(&exercise(1), "0.547 s").total.to_string(), "0.5");
    assert_eq!(marked(&exercise(1), "0.547 s or 1.49 s").total.to_string(), "1");
}

#[test]
fn who_rounds_on_the_way_gives_every_root() {
    let exercise = exercise(2);
    let report = exercise.grade(&exercise.rounded_answers(), DecimalMark::Point);
    assert!(report.is_right(), "{report}");
}
