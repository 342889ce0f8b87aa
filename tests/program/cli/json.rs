//! `docs/json.md` names every key of what is printed as JSON.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::room::{Room, lines};

const JSON: &str = include_str!("../../../docs/json.md");

/// Objects whose keys are names of the problem at hand.
const NAMED_BY_THE_PROBLEM: [&str; 2] = ["given", "right"];

fn keys<'a>(value: &'a Value, into: &mut BTreeSet<&'a str>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                into.insert(key);
                if !NAMED_BY_THE_PROBLEM.contains(&key.as_str()) {
                    keys(value, into);
                }
            }
        }
        Value::Array(list) => list.iter().for_each(|value| keys(value, into)),
        _ => {}
    }
}

#[test]
fn every_key_that_is_printed_is_documented() {
    let room = Room::empty();
    let bank = room.fine(&["list", "--format", "json"]);
    let ids: Vec<String> = lines(&bank).iter().map(|card| card["id"].as_str().unwrap().to_owned()).collect();
    let all: Vec<&str> =
        ["generate", "--format", "json", "--solution"].into_iter().chain(ids.iter().map(String::as_str)).collect();
    let wrong = ["grade", "--problem", "impact/two-carts", "--seed", "1", "--closed", "--format", "json"];
    let answers = ["--answer", "v_A2=0.500 m/s", "--answer", "v_B2=9 m/x", "--answer", "T_lost=3.00 J"];
    let printed = [
        bank,
        room.fine(&all),
        room.run(&[wrong.as_slice(), &answers].concat()).out,
        room.run(&["check", "impact/two-carts", "concepts", "bouncing", "--seeds", "2", "--format", "json"]).out,
        room.fine(&["simulate", "impact/two-carts", "--format", "json"]),
    ];
    let values: Vec<Value> = printed.iter().flat_map(|text| lines(text)).collect();
    let mut printed = BTreeSet::new();
    for value in &values {
        keys(value, &mut printed);
    }
    assert!(printed.len() > 60, "only {printed:?}");
    printed.retain(|key| !JSON.contains(&format!("`{key}`")) && !JSON.contains(&format!("\"{key}\"")));
    assert_eq!(printed, BTreeSet::new(), "docs/json.md lacks these");
}
