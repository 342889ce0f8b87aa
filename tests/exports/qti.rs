//! A reader of QTI items that marks as the standard says, for both versions.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::xml::{Node, read};

/// An item with names as the third version spells them, without its prefix.
pub struct Item {
    root: Node,
}

/// What marking sets.
pub struct Marked {
    pub score: f64,
    pub outcomes: BTreeMap<String, String>,
}

#[derive(Clone, Debug, PartialEq)]
enum Value {
    Null,
    Number(f64),
    Text(String),
    Truth(bool),
}

impl Item {
    pub fn read(xml: &str) -> Self {
        Self { root: spelt(&read(xml)) }
    }

    pub fn identifier(&self) -> &str {
        self.root.attribute("identifier")
    }

    pub fn title(&self) -> &str {
        self.root.attribute("title")
    }

    /// The text of the body without its elements.
    pub fn text(&self) -> String {
        self.root.at(&["item-body"]).unwrap().whole_text()
    }

    pub fn most(&self) -> f64 {
        let outcome =
            self.root.all("outcome-declaration").find(|declaration| declaration.attribute("identifier") == "MAXSCORE");
        outcome.unwrap().text_at(&["default-value", "value"]).parse().unwrap()
    }

    /// The fields in order: names of responses with their right values.
    pub fn responses(&self) -> Vec<(String, String)> {
        let declared = self.root.all("response-declaration");
        let right = |declaration: &Node| declaration.text_at(&["correct-response", "value"]).to_owned();
        declared.map(|declaration| (declaration.attribute("identifier").to_owned(), right(declaration))).collect()
    }

    /// The choices of a field with their texts.
    pub fn choices(&self, response: &str) -> Vec<(String, String)> {
        let mut found = Vec::new();
        self.root.walk(&mut |node| {
            if node.name == "choice-interaction" && node.attribute("response-identifier") == response {
                let choice = |choice: &Node| (choice.attribute("identifier").to_owned(), choice.whole_text());
                found = node.all("simple-choice").map(choice).collect();
            }
        });
        found
    }

    /// What is shown where the outcome has that value.
    pub fn feedback(&self, outcome: &str, value: &str) -> Option<String> {
        let mut found = None;
        self.root.walk(&mut |node| {
            let is_it = node.name == "feedback-block"
                && node.attribute("outcome-identifier") == outcome
                && node.attribute("identifier") == value;
            if is_it {
                found = Some(node.whole_text());
            }
        });
        found
    }

    /// Marks answers; a field without one is empty.
    pub fn mark(&self, answers: &[(&str, &str)]) -> Marked {
        let mut marked = Marked { score: 0.0, outcomes: BTreeMap::new() };
        for rule in &self.root.at(&["response-processing"]).unwrap().children {
            if rule.name == "response-condition" {
                let taken = rule.children.iter().find(|branch| {
                    assert!(matches!(branch.name.as_str(), "response-if" | "response-else-if"), "{}", branch.name);
                    value(&branch.children[0], answers, &marked) == Value::Truth(true)
                });
                taken
                    .into_iter()
                    .flat_map(|branch| &branch.children[1..])
                    .for_each(|step| set(step, answers, &mut marked));
            } else {
                set(rule, answers, &mut marked);
            }
        }
        marked
    }
}

fn set(rule: &Node, answers: &[(&str, &str)], marked: &mut Marked) {
    assert_eq!(rule.name, "set-outcome-value");
    match value(&rule.children[0], answers, marked) {
        Value::Number(number) => {
            assert_eq!(rule.attribute("identifier"), "SCORE");
            marked.score = number;
        }
        Value::Text(text) => drop(marked.outcomes.insert(rule.attribute("identifier").to_owned(), text)),
        other => panic!("{other:?}"),
    }
}

fn value(node: &Node, answers: &[(&str, &str)], marked: &Marked) -> Value {
    let all: Vec<Value> = node.children.iter().map(|child| value(child, answers, marked)).collect();
    let compared = || match all[..] {
        [Value::Number(left), Value::Number(right)] => left.partial_cmp(&right),
        // An empty answer counts as zero, as it does in players.
        [Value::Null, Value::Number(right)] => 0.0.partial_cmp(&right),
        _ => None,
    };
    match node.name.as_str() {
        "variable" if node.attribute("identifier") == "SCORE" => Value::Number(marked.score),
        "variable" => match answers.iter().find(|(name, _)| *name == node.attribute("identifier")) {
            None => Value::Null,
            Some((_, text)) => text.parse().map_or_else(|_| Value::Text((*text).to_owned()), Value::Number),
        },
        "base-value" if node.attribute("base-type") == "float" => Value::Number(node.text.parse().unwrap()),
        "base-value" => Value::Text(node.text.clone()),
        "is-null" => Value::Truth(all == [Value::Null]),
        "not" => Value::Truth(all == [Value::Truth(false)]),
        "and" => Value::Truth(all.iter().all(|truth| *truth == Value::Truth(true))),
        "or" => Value::Truth(all.contains(&Value::Truth(true))),
        "match" => Value::Truth(all[0] == all[1]),
        "gte" => Value::Truth(matches!(compared(), Some(Ordering::Greater | Ordering::Equal))),
        "lte" => Value::Truth(matches!(compared(), Some(Ordering::Less | Ordering::Equal))),
        "sum" => {
            Value::Number(all.iter().map(|term| if let Value::Number(number) = term { *number } else { 0.0 }).sum())
        }
        other => panic!("{other}"),
    }
}

/// The same tree in one spelling: `qti-base-value` and `baseValue` as `base-value`.
fn spelt(node: &Node) -> Node {
    let kebab = |name: &str| {
        let name = name.strip_prefix("qti-").unwrap_or(name);
        name.chars().fold(String::new(), |mut out, letter| {
            if letter.is_ascii_uppercase() {
                out.push('-');
            }
            out.push(letter.to_ascii_lowercase());
            out
        })
    };
    Node {
        name: kebab(&node.name),
        attributes: node.attributes.iter().map(|(name, value)| (kebab(name), value.clone())).collect(),
        children: node.children.iter().map(spelt).collect(),
        ..node.clone()
    }
}
