//! The table of random scenes knows every key of every kind of stage.

use std::collections::{BTreeMap, BTreeSet};

use momentous::problem::json_schema;
use serde_json::Value;

use super::table::{Table, plain};

/// The kinds of stage with their keys, as the schema of problem files has them; a second name of a kind is left out.
fn schema() -> BTreeMap<String, BTreeSet<String>> {
    let schema = serde_json::to_value(json_schema()).unwrap();
    let target = |reference: &Value| {
        let pointer = reference.as_str().unwrap().trim_start_matches('#').to_owned();
        schema.pointer(&pointer).unwrap().clone()
    };
    let stages = schema.pointer("/$defs/Stage/oneOf").and_then(Value::as_array).unwrap();
    let keys = |kind: &Value| kind["properties"].as_object().unwrap().keys().cloned().collect::<BTreeSet<_>>();
    let mut kinds: BTreeMap<String, (String, BTreeSet<String>)> = BTreeMap::new();
    for stage in stages {
        let (name, reference) = stage["properties"].as_object().unwrap().iter().next().unwrap();
        let kind = (name.clone(), keys(&target(&reference["$ref"])));
        kinds.entry(reference["$ref"].to_string()).or_insert(kind);
    }
    kinds.into_values().collect()
}

#[test]
fn every_key_of_every_stage_has_a_row_and_a_shape_that_uses_it() {
    let (table, schema) = (Table::read(), schema());
    let named: BTreeSet<&str> = table.stages.iter().map(|kind| kind.name.as_str()).collect();
    assert_eq!(named, schema.keys().map(String::as_str).collect());
    for kind in &table.stages {
        let used = kind.shapes.iter().flat_map(|shape| shape.needed.iter().chain(&shape.further));
        let used: BTreeSet<&str> = used.map(|key| plain(key)).collect();
        let rows: BTreeSet<&str> = kind.keys.keys().map(|key| plain(key)).collect();
        let keys: BTreeSet<&str> = schema[&kind.name].iter().map(String::as_str).collect();
        assert_eq!(rows, keys, "{}: its rows, and the keys of the schema", kind.name);
        assert_eq!(used, keys, "{}: the keys of its shapes, and those of the schema", kind.name);
    }
}
