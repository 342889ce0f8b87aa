//! Requests that nobody sends by accident: every route answers them, and nothing breaks.

use axum::http::Method;
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};
use serde_json::json;

use super::client::{Client, encoded, percent};

/// How many requests are tried on each route.
const TRIES: u32 = 150;

/// Every route, with `*` where the hostile text goes.
const ROUTES: [&str; 15] = [
    "/*",
    "/?search=*&level=*",
    "/practice/*",
    "/practice/impact/two-carts?form=*&seed=*",
    "/solution/*",
    "/solution/impact/two-carts?steps=*&seed=*",
    "/solve/*",
    "/solve/impact/two-carts?set.m_A=*&find=*",
    "/solve/impact/two-carts?set.*=1",
    "/simulators/*",
    "/simulators/collision?m_A=*&e=*&method=*&step=*",
    "/simulators/discs?m_A=*&b=*&e=*",
    "/simulators/restitution?h=*&e=*&v_t=*&e_2=*",
    "/static/*/*",
    "/watch?*",
];

/// What is tried, beside what chance makes.
const TEXTS: [&str; 18] = [
    "",
    "..",
    "../../etc/passwd",
    "impact/../../x",
    "\0",
    "%",
    "<script>alert(1)</script>",
    "{{ 7 * 7 }}",
    "{% include \"web/layout.tera\" %}",
    "' OR 1=1 --",
    "-1",
    "18446744073709551616",
    "1e309",
    "NaN",
    "\u{202e}\u{0}\u{1b}[31m",
    "((((((((((((((((((((((((((((((((",
    "9^9^9^9^9",
    "e",
];

fn text(random: &mut ChaCha8Rng) -> String {
    if random.random_bool(0.5) {
        return TEXTS[random.random_range(0..TEXTS.len())].to_owned();
    }
    let length = random.random_range(0..40);
    (0..length).map(|_| char::from_u32(random.random_range(1..0x2fff)).unwrap_or('?')).collect()
}

/// Statuses that tell a client what it did wrong, or that it did nothing wrong.
fn is_answered(status: u16) -> bool {
    matches!(status, 200 | 400 | 404 | 405 | 413 | 415 | 422)
}

#[test]
fn hostile_addresses_are_answered() {
    let client = Client::new();
    let mut random = ChaCha8Rng::seed_from_u64(20);
    for route in ROUTES {
        for _ in 0..TRIES {
            let parts: Vec<String> =
                route.split('*').map(|part| part.to_owned() + &percent(&text(&mut random))).collect();
            let address = parts.concat();
            let answer = client.get(&address);
            assert!(is_answered(answer.status), "{address}: {}", answer.status);
            assert!(!String::from_utf8_lossy(&answer.text(answer.status).into_bytes()).contains("<script>alert"));
        }
    }
}

#[test]
fn hostile_forms_are_answered() {
    let client = Client::new();
    let mut random = ChaCha8Rng::seed_from_u64(21);
    for problem in ["impact/two-carts", "concepts/coupling-in-symbols", "bouncing/marble-on-tile"] {
        for _ in 0..TRIES {
            let names = ["answer.v_A2", "answer.x", "hints", "further", "seed", "form", "do", "decimal", "set.m_A"];
            let count = random.random_range(0..8);
            let fields: Vec<(String, String)> = (0..count)
                .map(|_| (names[random.random_range(0..names.len())].to_owned(), text(&mut random)))
                .collect();
            let answer = client.post(&format!("/practice/{problem}"), &encoded(&fields));
            assert!(is_answered(answer.status), "{fields:?}: {}", answer.status);
        }
    }
}

#[test]
fn hostile_calls_are_answered() {
    let client = Client::new();
    let mut random = ChaCha8Rng::seed_from_u64(22);
    for call in ["collision", "discs", "givens", "hint", "mark", "read", "restitution", "sheet", "simulate", "solve"] {
        for _ in 0..TRIES {
            let mut words = || text(&mut random);
            let request = json!({
                "problem": if words().len() % 2 == 0 { words() } else { "impact/two-carts".to_owned() },
                "part": "v_A2", "text": words(), "answers": { "v_A2": words(), words(): words() },
                "number": 1, "set": { "m_A": words() }, "find": [words()], "method": words(), "values": { "m_A": words() },
            });
            let mut body = request.to_string().into_bytes();
            if random.random_bool(0.3) && !body.is_empty() {
                let at = random.random_range(0..body.len());
                body[at] = random.random();
            }
            let answer = client.bytes(Method::POST, &format!("/api/{call}"), "application/json", body);
            assert!(is_answered(answer.status), "{call} {request}: {}", answer.status);
        }
    }
}

#[test]
fn large_requests_are_refused() {
    let client = Client::new();
    let large = "x".repeat(100_000);
    assert_eq!(client.post("/practice/impact/two-carts", &format!("answer.v_A2={large}")).status, 413);
    let refused = client.call("mark", &json!({ "problem": large })).json(413);
    assert_eq!(
        (&refused["kind"], &refused["message"]),
        (&json!("too_large"), &json!("a request has at most 65536 bytes"))
    );
    let many: Vec<(String, String)> = (0..1000).map(|place| (format!("set.x{place}"), "1".to_owned())).collect();
    assert_eq!(client.post("/solve/impact/two-carts", &encoded(&many)).status, 413);
}

#[test]
fn other_methods_are_refused() {
    let client = Client::new();
    for (method, address) in [(Method::DELETE, "/"), (Method::PUT, "/api/mark"), (Method::GET, "/api/mark")] {
        let refused = client.bytes(method, address, "text/plain", Vec::new()).text(405);
        let reason = if address == "/" { "This address does not take such a request" } else { "{\"kind\":\"invalid\"" };
        assert!(refused.contains(reason), "{refused}");
    }
    for refused in
        [client.get("/practice/%ff"), client.bytes(Method::POST, "/practice/impact/two-carts", "a/b", vec![1])]
    {
        let status = refused.status;
        assert!([400, 415].contains(&status));
        assert!(refused.text(status).contains("The request cannot be read"));
    }
}
