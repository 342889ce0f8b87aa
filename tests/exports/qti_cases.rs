//! Cases for players of QTI: items with their pictures, and a file of cases beside each.

use std::fs;
use std::path::Path;

use momentous::exercise::Item;
use serde_json::{Map, Value, json};

use super::bank::{exported, forms, numbers, unpacked};
use super::cases::tries;
use super::qti;

/// How many mistakes of each field are tried, which takes a player a second each.
const MISTAKES: usize = 4;

/// Every item of the bank with its pictures and its cases.
pub fn write(target: &str, folder: &Path) {
    for items in forms() {
        for (name, content) in unpacked(exported(target, items)) {
            let Some(name) = name.strip_prefix("items/") else { continue };
            fs::write(folder.join(name), content).unwrap();
        }
        for item in items {
            let name = format!("item-{}", item.code);
            let written = qti::Item::read(&fs::read_to_string(folder.join(format!("{name}.xml"))).unwrap());
            fs::write(folder.join(format!("{name}.json")), json!({ "cases": cases(item, &written) }).to_string())
                .unwrap();
        }
    }
}

fn cases(item: &Item, written: &qti::Item) -> Vec<Value> {
    let responses = written.responses();
    let all: Map<String, Value> = responses.iter().map(|(name, right)| (name.clone(), json!(right))).collect();
    let mut cases = vec![json!({ "name": "printed", "responses": all, "expect": { "SCORE": written.most() } })];
    let asked: Vec<&(String, String)> = responses.iter().filter(|(name, _)| written.choices(name).is_empty()).collect();
    for attempt in tries(&numbers(item), MISTAKES) {
        let (mut score, mut said, mut given) = (0.0, Vec::new(), Map::new());
        for ((field, right), answer) in asked.iter().zip(&attempt.answers) {
            let Some(answer) = answer else { continue };
            score += answer.share * written.mark(&[(field, right)]).score;
            said.extend(answer.said.iter().map(|text| text.trim().to_owned()));
            given.insert(field.clone(), json!(answer.value.to_string()));
        }
        cases.push(json!({ "name": attempt.name, "responses": given, "expect": { "SCORE": score, "says": said } }));
    }
    cases
}
