//! How much work a call and a page is, counted: a problem is looked up once, and what comes of it is bounded.

use std::cell::Cell;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::calls::{Engine, Limits, Problems, Refused};
use momentous::problem::{Problem, compile, load};
use momentous::render::Renderer;
use serde_json::{Value, json};

use super::client::Client;

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
    let calls: [(&str, Value, usize); 10] = [
        ("collision", json!({ "values": { "e": 0.5 } }), 100_000),
        ("discs", json!({ "values": { "e": 0.5 } }), 100_000),
        ("givens", json!({ "problem": "impact/two-carts" }), 4_000),
        ("hint", json!({ "problem": "impact/two-carts", "number": 1 }), 1_000),
        ("mark", json!({ "problem": "impact/two-carts", "answers": { "v_A2": "1.00 m/s" } }), 2_000),
        ("read", json!({ "problem": "impact/two-carts", "part": "v_A2", "text": "1.00 m/s" }), 200),
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

/// Every kind of page, at its largest where its address says how large it is: with the look-ups that it needs, and its most bytes.
#[test]
fn a_page_looks_its_problem_up_once_and_stays_within_its_size() {
    let client = Client::new();
    let typed = "set.m_A=3+kg&set.m_B=2+kg&set.v_A1=3+m%2Fs&set.v_B1=-2+m%2Fs&set.e=0.7";
    let pages: [(&str, &str, u64, usize); 16] = [
        ("/", "", 0, 40_000),
        ("/practice/impact/two-carts?seed=7", "", 1, 20_000),
        (
            "/practice/impact/two-carts",
            "answer.v_A2=1+m%2Fs&answer.v_B2=2&answer.T_lost=x&hints=2&further=5&do=hint",
            1,
            20_000,
        ),
        ("/practice/impact/two-carts?{typed}", "", 1, 20_000),
        ("/practice/no/such-problem", "", 1, 4_000),
        ("/solution/impact/two-carts?seed=7", "", 1, 60_000),
        ("/solution/impact/two-carts?seed=7&steps=2", "", 1, 60_000),
        ("/solve/impact/two-carts?{typed}&find=v_A2", "", 1, 60_000),
        ("/play/impact/two-carts?seed=7", "", 1, 60_000),
        ("/play/impact/hockey-pucks?seed=7", "", 1, 60_000),
        ("/simulators/collision?method=penalty&step=0.001", "", 1, 100_000),
        ("/simulators/restitution?e=0.99&h=20&n=12&v_t=1", "", 1, 100_000),
        ("/simulators/restitution?e=0.99&h=20&n=12&method=explicit-euler&step=0.005", "", 1, 100_000),
        ("/simulators/restitution?e=0.99&h=20&n=12&e_2=0.99", "", 1, 200_000),
        ("/simulators/discs", "", 1, 100_000),
        ("/simulators/pendulum", "", 0, 4_000),
    ];
    for (address, form, most_looked_up, most) in pages {
        let address = address.replace("{typed}", typed);
        let before = client.app.looked_up();
        let answer = if form.is_empty() { client.get(&address) } else { client.post(&address, form) };
        let (looked_up, bytes) = (client.app.looked_up() - before, answer.text(answer.status).len());
        println!("{address}: {looked_up} look-ups, {bytes} bytes");
        assert_eq!(looked_up, most_looked_up, "{address} looks its problem up");
        assert!(bytes <= most, "{address} has {bytes} bytes");
    }
}
