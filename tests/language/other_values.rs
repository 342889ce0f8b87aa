//! Forms with other values of what their file gives.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{Problem, compile, load};

const RIFLE: &str = include_str!("../fixtures/problems/rifle_kick.yaml");

fn rifle() -> Arc<Problem> {
    let problem = load(Source::new("rifle_kick.yaml", RIFLE)).and_then(|loaded| compile(loaded, None));
    Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")))
}

fn answer(problem: &Arc<Problem>, form: &str, seed: u64, id: &str) -> f64 {
    let form = problem.form(Some(form)).unwrap();
    let record = Exercise::draw(problem, form, seed).unwrap().record(None);
    let parts = record["ask"].as_array().unwrap();
    parts.iter().find(|part| part["id"] == id).unwrap()["value"].as_f64().unwrap()
}

/// With the published answers of `OpenStax` College Physics, section 8.5.
#[test]
fn a_rifle_held_loosely_and_tightly_kicks_as_the_book_says() {
    let problem = rifle();
    let rows = [
        ("loosely", "v_rifle2", -4.58, 0.01),
        ("loosely", "T_rifle2", 31.5, 0.1),
        ("tightly", "v_rifle2", -0.491, 0.001),
        ("tightly", "T_rifle2", 3.38, 0.01),
    ];
    for (form, id, published, place) in rows {
        let computed = answer(&problem, form, 1, id);
        assert!((computed - published).abs() <= place, "{form}: {id} is {computed}, published {published}");
    }
}

#[test]
fn a_form_may_draw_what_others_fix() {
    let problem = rifle();
    let mass = |seed| format!("{:.3}", 0.0250 * 550.0 / -answer(&problem, "either", seed, "v_rifle2"));
    let masses: BTreeSet<String> = (1..=60).map(mass).collect();
    assert_eq!(masses, ["25.000", "26.000", "27.000", "28.000", "29.000", "30.000"].map(str::to_owned).into());
}
