//! What a face allows is what its calls and pages take, and no more.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::calls::{Engine, Limits, Problems, Refused, RefusedKind};
use momentous::problem::{Problem, compile, load};
use momentous::render::Renderer;
use momentous::web::Settings;
use serde_json::{Value, json};

use super::client::Client;

struct BuiltIn;

impl Problems for BuiltIn {
    fn problem(&self, id: &str) -> Result<Arc<Problem>, Refused> {
        Ok(Arc::new(compile(load(Bank::built_in().find(id).unwrap().clone()).unwrap(), None).unwrap()))
    }
}

/// Each bound with a call that reaches it: refused below what the call needs, answered at it.
#[test]
fn each_bound_holds_and_is_the_faces_own() {
    let renderer = Renderer::new(None).unwrap();
    let usual = Limits::default();
    let carts = |more: Value| {
        let mut request = json!({ "problem": "impact/two-carts" });
        request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        request
    };
    let three = json!({ "m_A": "3 kg", "m_B": "2 kg", "e": "0.5" });
    let stepped = json!({ "method": "explicit-euler", "step": 0.1 });
    let rows: [(&str, Value, Limits, &str); 6] = [
        ("sheet", carts(json!({})), Limits { request_bytes: 20, ..usual }, "at most 20 bytes make a request"),
        ("solve", carts(json!({ "set": three })), Limits { values: 2, ..usual }, "at most 2 values can be set"),
        ("solve", carts(json!({ "find": ["v_A2", "v_B2"] })), Limits { values: 1, ..usual }, "at most 1 quantities"),
        ("mark", carts(json!({ "answers": three })), Limits { values: 2, ..usual }, "at most 2 answers"),
        (
            "restitution",
            json!({ "values": { "n": 5 } }),
            Limits { bounces: 4, ..usual },
            "1, 2, 3, ... 4, and 5 is none",
        ),
        ("collision", stepped, Limits { simulator_steps: 7, ..usual }, "would take more than 7 steps"),
    ];
    for (call, request, limits, reason) in rows {
        let request = request.to_string().into_bytes();
        let engine = |limits| Engine { problems: &BuiltIn, renderer: &renderer, limits };
        let refused = engine(limits).call(call, &request).unwrap_err();
        assert!(refused.message.contains(reason), "{call}: {}", refused.message);
        assert!(matches!(refused.kind, RefusedKind::TooLarge | RefusedKind::Values), "{call}");
        assert!(engine(usual).call(call, &request).is_ok(), "{call} within the usual limits");
    }
}

/// An accuracy for which no steps are left is refused; a method that has no more impacts ends.
#[test]
fn a_run_ends_with_its_steps_and_impacts() {
    let renderer = Renderer::new(None).unwrap();
    let ask = |limits: Limits, call: &str, request: Value| -> Value {
        let engine = Engine { problems: &BuiltIn, renderer: &renderer, limits };
        serde_json::from_str(&engine.call(call, request.to_string().as_bytes()).unwrap()).unwrap()
    };
    let usual = Limits::default();
    let dropped = || json!({ "problem": "impact/two-carts", "method": "symplectic-euler", "accuracy": 0.1 });
    assert_eq!(ask(usual, "simulate", dropped())["stages"][0]["ends"], "at its time");
    let few = Engine { problems: &BuiltIn, renderer: &renderer, limits: Limits { scene_steps: 1, ..usual } };
    let refused = few.call("simulate", dropped().to_string().as_bytes()).unwrap_err();
    assert_eq!(refused.kind, RefusedKind::NotSimulated);
    assert!(refused.message.contains("no setting of symplectic Euler"), "{}", refused.message);
    let bouncing = || json!({ "method": "event-driven", "values": { "e": 0.9 } });
    let moments = |limits| {
        let shown = ask(limits, "restitution", bouncing());
        shown["compared"]["places"][0]["points"].as_array().unwrap().last().unwrap()[0].as_f64().unwrap()
    };
    assert!(moments(Limits { simulator_impacts: 3, ..usual }) < moments(usual));
}

#[test]
fn a_server_takes_no_more_than_its_settings_allow() {
    let limits = Limits { request_bytes: 200, fields: 2, values: 1, ..Limits::default() };
    let client = Client::with(Settings { limits, ..Settings::default() });
    let long = format!("answer.v_A2={}", "1".repeat(300));
    assert_eq!(client.post("/practice/impact/two-carts", &long).status, 413);
    assert_eq!(client.get("/practice/impact/two-carts?seed=1&form=forward&do=check").status, 413);
    assert_eq!(client.post("/practice/impact/two-carts", "answer.v_A2=1&answer.v_B2=1").status, 413);
    assert_eq!(client.post("/practice/impact/two-carts", "answer.v_A2=1&seed=1").status, 200);
}
