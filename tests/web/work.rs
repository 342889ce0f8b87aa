//! How much work a call is, counted: a problem is looked up once, and what comes of it is bounded.

use std::cell::Cell;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::calls::{Engine, Limits, Problems, Refused};
use momentous::problem::{Problem, compile, load};
use momentous::render::Renderer;
use serde_json::{Value, json};

/// A bank that counts how often it is asked.
struct Counted(Cell<u32>);

impl Problems for Counted {
    fn problem(&self, id: &str) -> Result<Arc<Problem>, Refused> {
        self.0.set(self.0.get() + 1);
        Ok(Arc::new(compile(load(Bank::built_in().find(id).unwrap().clone()).unwrap(), None).unwrap()))
    }
}

#[test]
fn a_call_looks_its_problem_up_once_and_answers_within_its_size() {
    let renderer = Renderer::new(None).unwrap();
    // Each call with its request and the most bytes of its response.
    let calls: [(&str, Value, usize); 9] = [
        ("collision", json!({ "values": { "e": 0.5 } }), 100_000),
        ("givens", json!({ "problem": "impact/two-carts" }), 4_000),
        ("hint", json!({ "problem": "impact/two-carts", "number": 1 }), 1_000),
        ("mark", json!({ "problem": "impact/two-carts", "answers": { "v_A2": "1 m/s" } }), 2_000),
        ("read", json!({ "problem": "impact/two-carts", "part": "v_A2", "text": "1 m/s" }), 200),
        ("restitution", json!({ "values": { "e": 0.5 } }), 100_000),
        ("sheet", json!({ "problem": "impact/two-carts" }), 10_000),
        ("simulate", json!({ "problem": "impact/two-carts" }), 400_000),
        ("solve", json!({ "problem": "impact/two-carts" }), 60_000),
    ];
    for (call, request, most) in calls {
        let problems = Counted(Cell::new(0));
        let engine = Engine { problems: &problems, renderer: &renderer, limits: Limits::default() };
        let response = engine.call(call, request.to_string().as_bytes()).unwrap();
        assert_eq!(problems.0.get(), 1, "{call} looks its problem up");
        assert!(response.len() <= most, "{call} answers with {} bytes", response.len());
    }
}
