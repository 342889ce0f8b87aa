//! The simulators: balances over random controls, and what cannot be.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use serde_json::{Value, json};

use super::client::Client;

/// What a call says to these values.
fn shown(client: &Client, call: &str, values: &Value, method: Option<&str>) -> Value {
    client.call(call, &json!({ "values": values, "method": method })).json(200)
}

fn at(value: &Value, pointer: &str) -> f64 {
    value.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number at {pointer}"))
}

fn is_near(left: f64, right: f64, scale: f64) -> bool {
    (left - right).abs() <= 1e-9 * scale.abs().max(1e-12)
}

/// A number with few decimals, as a slider gives it.
fn decimals(from: i32, to: i32, scale: f64) -> impl Strategy<Value = f64> {
    (from..=to).prop_map(move |number| f64::from(number) / scale)
}

/// The random values on which a property is tried.
const CASES: u32 = 48;

/// Runs a property on random values; the seed is fixed, so that a run can be repeated.
fn over<S: Strategy>(values: &S, property: impl Fn(S::Value)) {
    often(CASES, values, property);
}

fn often<S: Strategy>(cases: u32, values: &S, property: impl Fn(S::Value)) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha),
    );
    runner
        .run(values, |value| {
            property(value);
            Ok(())
        })
        .unwrap();
}

#[test]
fn a_collision_keeps_momentum_loses_energy_and_returns_e() {
    let client = Client::new();
    let speeds = (decimals(-100, 100, 10.0), decimals(-100, 100, 10.0));
    let values = (decimals(1, 200, 10.0), decimals(1, 200, 10.0), speeds, decimals(0, 100, 100.0));
    over(&values, |(mass_a, mass_b, (fast, slow), e)| {
        let set = json!({ "m_A": mass_a, "m_B": mass_b, "v_A": fast, "v_B": slow, "e": e });
        let shown = shown(&client, "collision", &set, None);
        let size = (mass_a * fast).abs() + (mass_b * slow).abs();
        assert!(is_near(at(&shown, "/momentum/2/before/value"), mass_a * fast + mass_b * slow, size), "{set}");
        assert!(is_near(at(&shown, "/momentum/2/after/value"), mass_a * fast + mass_b * slow, size), "{set}");
        let [after_a, after_b] = ["/bodies/0/after/value", "/bodies/1/after/value"].map(|place| at(&shown, place));
        let energy = |a: f64, b: f64| 0.5 * mass_a * a * a + 0.5 * mass_b * b * b;
        let before = energy(fast, slow);
        assert!(is_near(at(&shown, "/lost/value"), before - energy(after_a, after_b), before), "{set}");
        if fast > slow {
            assert!(is_near(after_b - after_a, e * (fast - slow), 20.0), "{set}");
            // The reduced mass: T_lost = (1 - e^2) mu (v_A - v_B)^2 / 2.
            let reduced = mass_a * mass_b / (mass_a + mass_b);
            let lost = (1.0 - e * e) * reduced * (fast - slow) * (fast - slow) / 2.0;
            assert!(is_near(at(&shown, "/lost/value"), lost, before), "{set}");
            // The carts start 5 m apart, each with half a length of 0.3 m times the cube root of its mass in kg.
            let apart = 5.0 - 0.3 * (mass_a.cbrt() + mass_b.cbrt());
            assert!(is_near(at(&shown, "/meeting/time/value"), apart / (fast - slow), 50.0), "{set}");
            assert!(is_near(at(&shown, "/meeting/impulse/value"), (1.0 + e) * reduced * (fast - slow), size), "{set}");
        } else {
            assert!(shown["meeting"].is_null() && shown["told"].as_str().unwrap().starts_with("No impact"), "{set}");
            assert_eq!((after_a, after_b), (fast, slow), "{set}");
        }
    });
}

#[test]
fn a_ball_bounces_in_a_geometric_sequence() {
    let client = Client::new();
    let values = (decimals(1, 200, 10.0), decimals(1, 99, 100.0), 1..=12);
    over(&values, |(height, e, n)| {
        let set = json!({ "h": height, "e": e, "n": n });
        let shown = shown(&client, "restitution", &set, None);
        let fall = (2.0 * height / 9.81_f64).sqrt();
        assert!(is_near(at(&shown, "/sums/time/value"), fall * (1.0 + e) / (1.0 - e), fall / (1.0 - e)), "{set}");
        assert!(
            is_near(at(&shown, "/sums/path/value"), height * (1.0 + e * e) / (1.0 - e * e), height / (1.0 - e)),
            "{set}"
        );
        for (bounce, power) in shown["bounces"].as_array().unwrap().iter().zip(0..) {
            let kept = e.powi(power);
            assert!(is_near(at(bounce, "/height/value"), height * kept * kept, height), "{set}: {bounce}");
            if power > 0 {
                assert!(
                    is_near(at(bounce, "/after/value"), kept * (2.0 * 9.81 * height).sqrt(), 20.0),
                    "{set}: {bounce}"
                );
            }
        }
        assert!(is_near(at(&shown, "/bounces/0/height/value"), height, height), "{set}");
    });
}

#[test]
fn air_takes_height_and_its_error_is_said() {
    let client = Client::new();
    let vacuum = shown(&client, "restitution", &json!({ "h": 10 }), None);
    let air = shown(&client, "restitution", &json!({ "h": 10, "v_t": 12 }), None);
    assert!(at(&air, "/bounces/1/height/value") < at(&vacuum, "/bounces/1/height/value"));
    // v^2 = v_t^2 (1 - exp(-2 g h / v_t^2)) just before the first bounce.
    let arrival = 12.0 * (1.0 - (-2.0 * 9.81 * 10.0 / 144.0_f64).exp()).sqrt();
    assert!((at(&air, "/bounces/1/before/value") + arrival).abs() < 1e-7);
    assert!(air["how"].as_str().unwrap().contains("Runge") && air["sums"].is_null());
}

#[test]
fn methods_err_and_say_by_how_much() {
    let client = Client::new();
    for (call, method, errs) in [
        ("collision", "event-driven", false),
        ("collision", "explicit-euler", true),
        ("collision", "penalty", true),
        ("restitution", "runge-kutta", false),
        ("restitution", "moreau-jean", true),
        ("restitution", "sequential-impulses", true),
    ] {
        let values = if call == "collision" { json!({ "v_A": 3.1 }) } else { json!({}) };
        let shown = shown(&client, call, &values, Some(method));
        assert!(shown["compared"]["refused"].is_null(), "{method}");
        assert_eq!(at(&shown, "/compared/rows/0/amount/value") > 1e-4, errs, "{method}: {}", shown["compared"]["rows"]);
    }
    let refused = shown(&client, "collision", &json!({ "e": 0 }), Some("penalty"));
    assert!(refused["compared"]["refused"].as_str().unwrap().starts_with("no calibration"));
}

/// Impulses between two bodies, and those of a floor and of weight, are all counted: no method has a drift of momentum, however its
/// steps divide the time.
#[test]
fn no_step_invents_a_drift_of_momentum() {
    let client = Client::new();
    let level = |call: &str, values: &Value, method: &str, step: f64| {
        let request = json!({ "values": values, "method": method, "step": step });
        let compared = client.call(call, &request).json(200)["compared"].clone();
        if !compared["refused"].is_null() {
            return;
        }
        let points = compared["drifts"][0]["points"].as_array().unwrap();
        let greatest = points.iter().map(|point| at(point, "/1").abs()).fold(0.0, f64::max);
        assert!(!points.is_empty() && greatest == 0.0, "{call} {values}, {method} with {step} s: {greatest} %");
    };
    let methods =
        ["event-driven", "explicit-euler", "symplectic-euler", "moreau-jean", "penalty", "sequential-impulses"];
    // The steps that divide the usual 1.8 s, of which rounding leaves a sliver.
    for step in [0.06, 0.03, 0.015, 0.1, 0.09, 0.018] {
        for method in methods {
            level("collision", &json!({}), method, step);
        }
    }
    let values = (decimals(1, 200, 10.0), decimals(1, 200, 10.0), decimals(-50, 100, 10.0), decimals(0, 100, 100.0));
    let settings = (decimals(3, 100, 1000.0), 0..methods.len());
    often(200, &(values, settings), |((mass_a, mass_b, fast, e), (step, method))| {
        let collision = json!({ "m_A": mass_a, "m_B": mass_b, "v_A": fast, "e": e });
        level("collision", &collision, methods[method], step);
        // The force of a spring on the floor is counted when the contact is over.
        if methods[method] != "penalty" {
            level("restitution", &json!({ "h": mass_a, "e": e }), methods[method], step);
        }
    });
}

/// 3 kg at 3 m/s meets 2 kg at -2 m/s: the reduced mass 6/5 kg and the speed of approach 5 m/s give 6 N s until both move alike.
#[test]
fn the_area_of_a_contact_is_its_impulse_and_its_parts_stand_to_each_other_as_e() {
    let client = Client::new();
    let shown = shown(&client, "collision", &json!({}), None);
    for (row, expected) in [6.0, 4.2, 0.7, 10.2].into_iter().enumerate() {
        let value = at(&shown, &format!("/contact/rows/{row}/amount/value"));
        assert!((value / expected - 1.0).abs() < 1e-15, "row {row}: {value}");
    }
    assert_eq!(shown["contact"]["rows"][2]["amount"]["text"], "0.700");
    for values in [json!({ "e": 0 }), json!({ "v_A": -3 })] {
        assert!(self::shown(&client, "collision", &values, None)["contact"].is_null(), "{values}");
    }
}

/// Equal discs, nothing lost, one at rest: they part at a right angle. The line of impact is 30 degrees above the x-axis, since the
/// impact parameter is half of the sum of the radii.
#[test]
fn equal_discs_part_at_a_right_angle() {
    let client = Client::new();
    let values = json!({ "m_A": 2, "m_B": 2, "v_A": 4, "v_B": 0, "b": 0.4, "e": 1 });
    let shown = shown(&client, "discs", &values, None);
    assert_eq!(shown["line_of_impact"]["text"], "30.0°");
    // B takes the component along the line, 4 cos 30°, and A keeps 4 sin 30° across it.
    let along = 4.0 * (3.0_f64.sqrt() / 2.0);
    for (pointer, expected) in [
        ("/bodies/1/after/0/value", along * (3.0_f64.sqrt() / 2.0)),
        ("/bodies/1/after/1/value", along / 2.0),
        ("/bodies/0/after/0/value", 1.0),
        ("/bodies/0/after/1/value", -(3.0_f64.sqrt())),
        ("/lost/value", 0.0),
    ] {
        assert!((at(&shown, pointer) - expected).abs() < 1e-12, "{pointer}: {}", at(&shown, pointer));
    }
    let solution = shown["problem"]["solved"]["solution"].as_str().unwrap();
    assert!(solution.contains("Worked solution"), "the problem's own solution");
    let missed = self::shown(&client, "discs", &json!({ "b": 0.8 }), None);
    assert!(missed["meeting"].is_null() && missed["problem"]["solved"].is_null());
}

#[test]
fn what_cannot_be_is_refused_with_the_reason() {
    let client = Client::new();
    for (call, request, reason) in [
        ("collision", json!({ "values": { "e": 1.2 } }), "a coefficient of restitution above 1 would create energy"),
        ("collision", json!({ "values": { "m_A": -1 } }), "`m_A` must be greater than zero"),
        ("collision", json!({ "values": { "m_B": 0 } }), "`m_B` must be greater than zero"),
        ("collision", json!({ "values": { "m_A": 1e300 } }), "`m_A` lies between 0.1 kg and 20 kg here"),
        ("collision", json!({ "values": { "v_A": -1e300 } }), "`v_A` lies between -10 m/s and 10 m/s here"),
        ("collision", json!({ "values": { "v_t": 1 } }), "`v_t` cannot be set here"),
        ("collision", json!({ "values": { "x_A": 1 } }), "`x_A` lies between -6 m and -1 m here"),
        ("discs", json!({ "values": { "e": 1.2 } }), "a coefficient of restitution above 1 would create energy"),
        ("discs", json!({ "values": { "b": 2 } }), "`b` lies between -1 m and 1 m here"),
        ("restitution", json!({ "values": { "e_2": 1.2 } }), "`e_2` lies between 0 and 1 here"),
        ("collision", json!({ "method": "euler" }), "the methods are"),
        ("collision", json!({ "method": "penalty", "step": -1 }), "a step is a positive time"),
        ("collision", json!({ "method": "penalty", "step": 1e-9 }), "would take more than 20000 steps"),
        ("restitution", json!({ "values": { "e": 1.01 } }), "a coefficient of restitution above 1 would create energy"),
        ("restitution", json!({ "values": { "h": -4 } }), "`h_0` cannot be negative"),
        ("restitution", json!({ "values": { "h": 1e9 } }), "`h` lies between 0.1 m and 20 m here"),
        ("restitution", json!({ "values": { "n": 2.5 } }), "`n` is a number of bounces"),
        ("restitution", json!({ "values": { "v_t": -1 } }), "`v_t` lies between 0 m/s and 60 m/s here"),
    ] {
        let answer = client.call(call, &request);
        assert!((400..500).contains(&answer.status), "{call} {request}: {}", answer.status);
        let said = answer.json(answer.status)["message"].as_str().unwrap().to_owned();
        assert!(said.contains(reason), "{call} {request}: {said}");
    }
    let page = client.get("/simulators/collision?m_A=NaN");
    let text = page.text(200);
    assert!(
        text.contains("value=\"NaN\"") && text.contains("is not a value for `m_A`"),
        "the value stays, with the reason"
    );
    assert!(!text.contains("class=\"results\""));
    assert_eq!(client.get("/simulators/pendulum").status, 404);
}

/// A field that is emptied is not the usual value, which nobody typed.
#[test]
fn an_empty_field_is_said_to_be_empty() {
    let client = Client::new();
    let page = |address: &str| client.get(address).text(200);
    let empty = page("/simulators/collision?m_A=&m_B=2");
    assert!(
        empty.contains("The field “Mass of A” holds no number. Type one.")
            && empty.contains("id=\"m_A\" name=\"m_A\" min=\"0.1\" max=\"20.0\" step=\"any\" value=\"\"")
    );
    assert!(!empty.contains("class=\"results\""));
    assert!(
        page("/simulators/collision?m_B=2").contains("class=\"results\""),
        "what is not in the address has its usual value"
    );
    assert!(page("/simulators/restitution?method=penalty&step=").contains("“step” holds no number"));
    assert!(page("/simulators/restitution?method=&step=").contains("class=\"results\""), "no method has a step");
}
