//! Graphs to choose from, of problems that were published with theirs: what the right one looks like, in words, and the mistakes
//! behind the others.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use momentous::exercise::{Exercise, Marker};
use momentous::fault::Source;
use momentous::grade::{DecimalMark, Sitting};
use momentous::problem::{compile, load};

#[test]
fn the_right_graph_is_the_published_one() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/graphs");
    let mut seen = 0;
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let (name, text) = (path.display().to_string(), fs::read_to_string(&path).unwrap());
        let problem = load(Source::new(&name, &text)).and_then(|loaded| compile(loaded, None));
        let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")));
        let comment = |key: &str| text.lines().find_map(|line| line.strip_prefix(key)).unwrap();
        let wrong: Vec<&str> = comment("# wrong: ").split("; ").collect();
        for seed in 1..20 {
            let exercise = Exercise::draw(&problem, 0, seed).unwrap_or_else(|reason| panic!("{name}: {reason}"));
            let mut marker = Marker::new(&problem, 0, DecimalMark::Point).unwrap();
            let pictures = &exercise.sheet().parts[0].pictures;
            assert_eq!(pictures.len(), wrong.len() + 1, "{name}");
            let mut behind = Vec::new();
            for (picture, letter) in pictures.iter().zip(["A", "B", "C", "D"]) {
                assert_eq!(picture.caption, format!("Graph {letter}"));
                let report = marker.mark(exercise.worked(), &[("a", letter)], Sitting::default());
                match &report.parts[0].diagnosis {
                    Some(diagnosis) => behind.push(diagnosis.codes[0]),
                    None => assert_eq!(picture.description, comment("# expect: "), "{name}, seed {seed}"),
                }
            }
            behind.sort_unstable();
            let mut wrong = wrong.clone();
            wrong.sort_unstable();
            assert_eq!(behind, wrong, "{name}, seed {seed}");
        }
        seen += 1;
    }
    assert_eq!(seen, 3);
}

const SLED: &str = "
id: graphs/sled
title: Sled
level: core
scene:
  axes: { x: to the right }
  bodies: { A: { name: the sled } }
  stages: [ { push: { body: A, during: T, forces: [ { value: FORCE } ] } } ]
given: { m_A: 2 kg, F: 6 N, T: 4 s, v_A1: 0 m/s }
text: 'The sled ({{ m_A }}) {{ v_A1 | motion }} and is pushed for {{ T }}, at first with {{ F }}.'
ask: [ { choose: Which graph is right?, pictures: PLOTTED } ]
";

/// The descriptions of all graphs of a sled.
fn of_sled(force: &str, plotted: &str) -> Vec<String> {
    let text = SLED.replace("FORCE", force).replace("PLOTTED", plotted);
    let problem = load(Source::new("sled.yaml", &text)).and_then(|loaded| compile(loaded, None));
    let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")));
    let exercise = Exercise::draw(&problem, 0, 1).unwrap();
    let pictures = exercise.sheet().parts.swap_remove(0).pictures;
    pictures.into_iter().map(|picture| picture.description).collect()
}

/// 6 N on 2 kg for 4 s: 12 m/s and, by the area under the line, 24 m; a force that falls to zero gives half of that.
#[test]
fn the_graphs_of_mistakes_have_the_shapes_of_the_mistakes() {
    let expected = [
        (
            "F",
            "velocity-time",
            [
                "The velocity starts at 0 m/s, goes straight to 12.0 m/s at 4.00 s.",
                "The velocity starts at 12.0 m/s, stays there until 4.00 s.",
                "The velocity starts at 0 m/s, goes straight to -12.0 m/s at 4.00 s.",
                "The velocity starts at 0 m/s, goes along a curve through 3.00 m/s at 2.00 s to 12.0 m/s at 4.00 s.",
            ],
        ),
        (
            "F",
            "force-time",
            [
                "The net force starts at 6.00 N, stays there until 4.00 s.",
                "The net force starts at 0 N, goes straight to 6.00 N at 4.00 s.",
                "The net force starts at 6.00 N, goes straight to 0 N at 4.00 s.",
                "The net force starts at -6.00 N, stays there until 4.00 s.",
            ],
        ),
        (
            "F*(1 - t/T)",
            "velocity-time",
            [
                "The velocity starts at 0 m/s, goes along a curve through 4.50 m/s at 2.00 s to 6.00 m/s at 4.00 s.",
                "The velocity starts at 6.00 m/s, goes straight to 0 m/s at 4.00 s.",
                "The velocity starts at 0 m/s, goes straight to 6.00 m/s at 4.00 s.",
                "The velocity starts at 0 m/s, goes along a curve through -4.50 m/s at 2.00 s to -6.00 m/s at 4.00 s.",
            ],
        ),
        (
            "F*(1 - t/T)",
            "force-time",
            [
                "The net force starts at 6.00 N, goes straight to 0 N at 4.00 s.",
                "The net force starts at 0 N, goes along a curve through 4.50 N at 2.00 s to 6.00 N at 4.00 s.",
                "The net force starts at 3.00 N, stays there until 4.00 s.",
                "The net force starts at -6.00 N, goes straight to 0 N at 4.00 s.",
            ],
        ),
    ];
    for (force, plotted, expected) in expected {
        let (mut found, mut expected) = (of_sled(force, plotted), expected.to_vec());
        found.sort_unstable();
        expected.sort_unstable();
        assert_eq!(found, expected, "{force}, {plotted}");
    }
}
