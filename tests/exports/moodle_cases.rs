//! Cases for Moodle: a file of questions for each problem, and a file of cases beside it.

use std::fs;
use std::path::Path;

use momentous::exercise::Item;
use momentous::quantity::Unit;
use serde_json::{Map, Value, json};

use super::bank::{exported, forms, numbers, text};
use super::cases::{Answer, tries};
use super::moodle::{Field, fields};
use super::xml::{self, Node};

/// Every problem of the bank, all its forms in one file.
pub fn write(folder: &Path) {
    let items: Vec<&Item> = forms().iter().flatten().collect();
    for items in items.chunk_by(|left, right| left.identity.problem == right.identity.problem) {
        let file = text(exported("moodle", items.iter().copied()));
        let root = xml::read(&file);
        let questions = root.all("question").filter(|question| question.attribute("type") != "category");
        let cases: Vec<Value> =
            items.iter().zip(questions).flat_map(|(item, question)| cases(item, question)).collect();
        let path = folder.join(items[0].identity.problem.replace('/', "-"));
        fs::write(path.with_extension("xml"), file).unwrap();
        fs::write(path.with_extension("json"), json!(cases).to_string()).unwrap();
    }
}

fn cases(item: &Item, question: &Node) -> Vec<Value> {
    let name = question.text_at(&["name", "text"]);
    let fields = fields(question);
    match (question.attribute("type"), &fields[..]) {
        ("numerical", [field]) => numerical(item, name, field),
        ("multichoice", [field]) => choice(name, field),
        _ => cloze(item, name, &fields),
    }
}

/// The right answer as it is printed, in each unit and without one; then windows.
fn numerical(item: &Item, name: &str, field: &Field) -> Vec<Value> {
    let printed = &item.parts[0].printed;
    let (points, number) = numbers(item)[0];
    let mut cases = vec![json!({ "question": name, "answer": printed, "fraction": 1.0, "accepted": "complete" })];
    for (unit, _) in &field.units {
        let other = Unit::parse(&unit.replace('*', " ")).unwrap();
        let answer = format!("{} {unit}", number.right * number.unit.in_terms_of(&other).to_f64());
        cases.push(json!({ "question": name, "answer": answer, "fraction": 1.0, "accepted": "complete" }));
    }
    let unit = field.units.first().map_or("", |(unit, _)| unit);
    if !unit.is_empty() {
        let bare = number.right.to_string();
        let left = number.without_unit.0.to_f64().value() / f64::from(points);
        let fraction = field.mark(&bare).0;
        assert!((fraction - left).abs() < 0.05, "{name}: {fraction} {left}");
        cases.push(json!({ "question": name, "answer": bare, "fraction": fraction }));
        cases.push(json!({ "question": name, "answer": format!("{bare} furlong"), "fraction": fraction }));
    }
    for attempt in tries(&[(points, number)], number.windows.len()) {
        let Some(Some(Answer { value, share, said })) = attempt.answers.first() else { continue };
        let fraction = fraction(field, *value, *share);
        let answer = format!("{value} {unit}");
        cases.push(json!({ "question": name, "answer": answer, "fraction": fraction, "feedback_contains": said }));
    }
    cases
}

fn choice(name: &str, field: &Field) -> Vec<Value> {
    let one = |answer: &super::moodle::Answer| {
        json!({
            "question": name, "answer": answer.text, "fraction": answer.fraction / 100.0,
            "feedback_contains": [answer.feedback],
        })
    };
    field.answers.iter().map(one).collect()
}

/// Everything right, as it is printed; then windows of all gaps for numbers at once, then each choice.
fn cloze(item: &Item, name: &str, fields: &[Field]) -> Vec<Value> {
    let gaps = || (1..=fields.len()).map(|place| place.to_string());
    let numbers = numbers(item);
    let whole: u32 = fields.iter().map(|field| field.weight).sum();
    let mut asked = numbers.iter();
    let right = |field: &Field| {
        if field.is_choice {
            return field.answers.iter().find(|answer| answer.fraction >= 100.0).unwrap().text.clone();
        }
        asked.next().map(|(_, number)| format!("{:.*e}", number.figures - 1, number.right)).unwrap()
    };
    let right: Map<String, Value> = gaps().zip(fields.iter().map(right).map(Value::from)).collect();
    let mut cases = vec![json!({ "question": name, "response": right, "fraction": 1.0, "accepted": "complete" })];
    for attempt in tries(&numbers, numbers.iter().map(|(_, number)| number.windows.len()).max().unwrap_or(0)) {
        let (mut response, mut parts, mut said, mut earned) = (Map::new(), Map::new(), Vec::new(), 0.0);
        let asked = gaps().zip(fields).filter(|(_, field)| !field.is_choice);
        for ((gap, field), answer) in asked.zip(&attempt.answers) {
            let Some(Answer { value, share, said: says }) = answer else { continue };
            let share = fraction(field, *value, *share);
            earned += share * f64::from(field.weight) / f64::from(whole);
            response.insert(gap.clone(), json!(value.to_string()));
            parts.insert(gap, json!(share));
            said.extend(says.iter().cloned());
        }
        cases.push(json!({
            "question": name, "response": response, "parts": parts, "fraction": earned, "feedback_contains": said,
        }));
    }
    for (gap, field) in gaps().zip(fields).filter(|(_, field)| field.is_choice) {
        for answer in &field.answers {
            cases.push(json!({
                "question": name, "response": { &gap: answer.text }, "parts": { &gap: answer.fraction / 100.0 },
                "feedback_contains": [answer.feedback],
            }));
        }
    }
    cases
}

/// What a field gives for a number of that share of the points: the same, or the nearest that Moodle knows.
fn fraction(field: &Field, value: f64, share: f64) -> f64 {
    let fraction = field.mark_number(value).0;
    assert!((fraction - share).abs() < 0.05, "{value}: {fraction} {share}");
    fraction
}
