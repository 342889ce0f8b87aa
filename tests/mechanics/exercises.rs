//! Exercises of the kinds that stand in every textbook, written by the docs alone, with answers worked out by hand; the
//! arithmetic stands in each file.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};

/// The share by which an answer may differ: that of four figures.
const FOUR_FIGURES: f64 = 5e-4;

#[test]
fn exercises_come_out_as_by_hand() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/exercises");
    let mut compared = 0;
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let (name, text) = (path.display().to_string(), fs::read_to_string(&path).unwrap());
        let problem = load(Source::new(&name, &text)).and_then(|loaded| compile(loaded, None));
        let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")));
        let exercise = Exercise::draw(&problem, 0, 1).unwrap_or_else(|reason| panic!("{name}: {reason}"));
        let record = exercise.record(None);
        let expected = text.lines().find_map(|line| line.strip_prefix("# expect: ")).unwrap();
        let asked = record["ask"].as_array().unwrap();
        assert_eq!(asked.len(), expected.split("; ").count(), "{name}");
        for (part, line) in asked.iter().zip(expected.split("; ")) {
            let (id, value) = line.split_once(" = ").unwrap();
            let (computed, value): (f64, f64) = (part["value"].as_f64().unwrap(), value.parse().unwrap());
            assert_eq!(part["id"], id, "{name}");
            assert!(
                (computed - value).abs() <= FOUR_FIGURES * value.abs(),
                "{name}: {id} is {computed}, by hand {value}"
            );
            compared += 1;
        }
    }
    assert!(compared > 30, "{compared}");
}
