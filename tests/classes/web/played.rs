//! Scenes that are played: how many forms of the bank are, and that the record of each is one motion.

use serde_json::{Value, json};

use super::client::Client;
use super::problems;

/// The share of the forms of the bank that have to be played, in percent.
const LEAST: usize = 90;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Whether momentum and kinetic energy of a moment are those of its bodies, by their definitions.
fn adds_up(moment: &Value) -> bool {
    let (masses, momentum) = (numbers(&moment["masses"]), numbers(&moment["momentum"]));
    let (mut sum, mut size, mut kinetic) = (vec![0.0; momentum.len()], 0.0, 0.0);
    for (mass, velocity) in masses.iter().zip(moment["velocities"].as_array().unwrap()) {
        for (total, part) in sum.iter_mut().zip(numbers(velocity)) {
            *total += mass * part;
            size += (mass * part).abs();
            kinetic += mass * part * part / 2.0;
        }
    }
    let same = momentum.iter().zip(&sum).all(|(part, sum)| (part - sum).abs() <= 1e-9 * size);
    same && (moment["kinetic_energy"].as_f64().unwrap() - kinetic).abs() <= 1e-3 * kinetic + 1e-12
}

#[test]
fn nearly_every_form_of_the_bank_is_played_and_the_rest_says_why() {
    let client = Client::new();
    let (mut forms, mut refused) = (0, Vec::new());
    for problem in problems() {
        for form in problem.forms() {
            forms += 1;
            let name = form.question.name.as_deref();
            let request = json!({ "problem": problem.id(), "form": name, "seed": 3, "together": true });
            let page =
                client.get(&format!("/play/{}?form={}&seed=3", problem.id(), name.unwrap_or_default())).text(200);
            let answer = client.call("simulate", &request);
            if answer.status != 200 {
                let reason = answer.json(422)["message"].as_str().unwrap().to_owned();
                let is_told = reason.starts_with("nothing to simulate: ") || reason.starts_with("not shown: ");
                assert!(is_told && page.contains("role=\"alert\""), "{}: {reason}", problem.id());
                refused.push(format!("{} {}: {reason}", problem.id(), name.unwrap_or_default()));
                continue;
            }
            assert!(page.contains("class=\"film\""), "{}", problem.id());
            let record = answer.json(200);
            for film in record["stages"].as_array().unwrap() {
                let moments = film["moments"].as_array().unwrap();
                let times: Vec<f64> = moments.iter().map(|moment| moment["time"].as_f64().unwrap()).collect();
                assert!(times.first() < times.last() && times.is_sorted(), "{} {name:?}", problem.id());
                let wrong = moments.iter().find(|moment| !adds_up(moment));
                assert!(wrong.is_none(), "{} {name:?}, stage {}: {wrong:?}", problem.id(), film["stage"]);
            }
        }
    }
    let played = forms - refused.len();
    println!("{played} of {forms} forms are played; not played:\n{}", refused.join("\n"));
    assert!(forms > 100 && 100 * played >= LEAST * forms, "{played} of {forms}: {refused:#?}");
}

/// A ball thrown on a floor: the flight is run along each axis by itself, and the bounces once to the last that is asked for
/// and once to their end.
#[test]
fn what_was_run_in_parts_is_played_as_one_motion() {
    let client = Client::new();
    let request = json!({ "problem": "bouncing/ball-on-a-ramp", "seed": 1 });
    let parts = client.call("simulate", &request).json(200);
    let whole = client
        .call("simulate", &json!({ "problem": "bouncing/ball-on-a-ramp", "seed": 1, "together": true }))
        .json(200);
    let stages = |record: &Value| -> Vec<u64> {
        record["stages"].as_array().unwrap().iter().map(|film| film["stage"].as_u64().unwrap()).collect()
    };
    assert_eq!((stages(&parts), stages(&whole)), (vec![1, 1, 2, 2], vec![1, 2]));
    let (across, height, both) = (&parts["stages"][0], &parts["stages"][1], &whole["stages"][0]);
    assert_eq!(both["axes"], json!(["x", "y"]));
    for place in [0, 77, 240] {
        let at = |film: &Value| film["moments"][place]["positions"][0][0].as_f64().unwrap();
        assert_eq!(numbers(&both["moments"][place]["positions"][0]), [at(across), at(height)]);
    }
    assert_eq!(whole["stages"][1]["moments"], parts["stages"][3]["moments"]);
}
