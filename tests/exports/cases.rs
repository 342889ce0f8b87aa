//! Cases for players of QTI: what to answer, and what it has to give. They are written where `EXPORT_CASES` names a folder.

use std::fs;
use std::path::Path;

use momentous::exercise::{Item, NumberItem, Window};
use serde_json::{Map, Value, json};

use super::bank::{exported, forms, numbers, unpacked};
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

/// An answer to a number, the share of the points that it earns, and what is said of it.
type Answer<'i> = (String, f64, &'i [String]);

/// The right answers as they are printed, each end of their windows, what lies outside of every window, and mistakes, each in
/// all fields at once.
fn cases(item: &Item, written: &qti::Item) -> Vec<Value> {
    let responses = written.responses();
    let all: Map<String, Value> = responses.iter().map(|(name, right)| (name.clone(), json!(right))).collect();
    let mut cases = vec![json!({ "name": "printed", "responses": all, "expect": { "SCORE": written.most() } })];
    let asked: Vec<&(String, String)> = responses.iter().filter(|(name, _)| written.choices(name).is_empty()).collect();
    let numbers = numbers(item);
    let mut case = |name: &str, answer: &dyn Fn(u32, &NumberItem) -> Option<Answer<'_>>| {
        let (mut score, mut said, mut given) = (0.0, Vec::new(), Map::new());
        for ((field, right), (points, number)) in asked.iter().zip(&numbers) {
            let Some((value, worth, says)) = answer(*points, number) else { continue };
            score += worth * written.mark(&[(field, right)]).score;
            said.extend(says.iter().map(|own| own.trim().to_owned()));
            given.insert(field.clone(), json!(value));
        }
        if !given.is_empty() {
            cases.push(json!({ "name": name, "responses": given, "expect": { "SCORE": score, "says": said } }));
        }
    };
    for (name, end) in [("low", (|own| own.low) as fn(&Window) -> f64), ("high", |own| own.high)] {
        case(name, &|points, number| {
            let full = number.windows.iter().find(|own| worth(own, points) >= 1.0)?;
            Some((end(full).to_string(), 1.0, &full.feedback))
        });
    }
    case("outside", &|_, number| {
        let outside = number.windows.iter().fold(1e9, |outside, own| outside + own.high.abs());
        Some((outside.to_string(), 0.0, &[]))
    });
    for place in 0..MISTAKES {
        case("mistake", &|points, number| {
            let own = number.windows.iter().filter(|own| !own.mistakes.is_empty()).nth(place)?;
            Some(((own.low + (own.high - own.low) / 2.0).to_string(), worth(own, points), &own.feedback))
        });
    }
    cases
}

fn worth(window: &Window, points: u32) -> f64 {
    window.points.0.to_f64().value() / f64::from(points)
}
