//! Submissions as objects, in JSON or YAML. Numbers are taken as they were typed: 0.500 has three figures.

use std::collections::BTreeSet;
use std::fmt;

use serde::Deserialize;
use serde::Deserializer;
use serde::de::Error;
use serde::de::MapAccess;
use serde::de::Visitor;
use serde_json::value::RawValue;

use momentous_fault::Fault;
use momentous_fault::Source;
use momentous_problem::Document;
use momentous_problem::Entry;
use momentous_problem::Kind;
use momentous_problem::Node;
use momentous_problem::Style;

use super::{KEYS, Key, Place, Submission};

/// A submission as a JSON object: the keys beside `answers`, which holds the parts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Object<'a> {
    #[serde(borrow, default)]
    student: Option<&'a RawValue>,
    #[serde(borrow)]
    problem: Option<&'a RawValue>,
    #[serde(borrow, default)]
    digest: Option<&'a RawValue>,
    #[serde(borrow)]
    seed: Option<&'a RawValue>,
    #[serde(borrow, default)]
    form: Option<&'a RawValue>,
    #[serde(borrow, default)]
    scheme: Option<&'a RawValue>,
    #[serde(borrow, default)]
    given: Option<&'a RawValue>,
    #[serde(borrow, default)]
    attempt: Option<&'a RawValue>,
    #[serde(borrow, default)]
    hints: Option<&'a RawValue>,
    #[serde(borrow, default)]
    further_hints: Option<&'a RawValue>,
    #[serde(borrow, default)]
    answers: Answers<'a>,
}

/// Parts with their answers, each once.
#[derive(Default)]
struct Answers<'a>(Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Answers<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Parts;
        impl<'de> Visitor<'de> for Parts {
            type Value = Answers<'de>;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("an object with an answer for each part")
            }

            fn visit_unit<E>(self) -> Result<Self::Value, E> {
                Ok(Answers::default())
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let (mut answers, mut parts) = (Vec::new(), BTreeSet::new());
                while let Some((part, answer)) = map.next_entry::<String, &RawValue>()? {
                    if !parts.insert(part.clone()) {
                        return Err(A::Error::custom(format!("`{}` is answered twice", super::excerpt(&part))));
                    }
                    answers.push((part, answer));
                }
                Ok(Answers(answers))
            }
        }
        deserializer.deserialize_any(Parts)
    }
}

impl Submission {
    /// Takes what a JSON object says.
    ///
    /// # Errors
    /// Where it is none, or says something twice or something that has no place in a submission.
    pub fn of_json(place: Place, line: &str) -> Result<Self, String> {
        let object: Object<'_> = serde_json::from_str(line).map_err(|error| without_line(&error))?;
        let mut submission = Self::new(place);
        for (key, name) in KEYS {
            let value = match key {
                Key::Student => object.student,
                Key::Problem => object.problem,
                Key::Digest => object.digest,
                Key::Seed => object.seed,
                Key::Form => object.form,
                Key::Scheme => object.scheme,
                Key::Given => object.given,
                Key::Attempt => object.attempt,
                Key::Hints => object.hints,
                Key::FurtherHints => object.further_hints,
            };
            if let Some(value) = value {
                submission.put_key(key, &of_raw(name, value)?)?;
            }
        }
        for (part, answer) in &object.answers.0 {
            submission.put_answer(part, &of_raw(part, answer)?);
        }
        Ok(submission)
    }

    /// Takes what a YAML file says.
    ///
    /// # Errors
    /// Where it is none, or says something twice or something that has no place in a submission.
    pub fn of_yaml(place: Place, file: &Source) -> Result<Self, String> {
        let document = Document::read(file);
        let told = |fault: &Fault| match fault.span {
            Some(span) => format!("line {}: {}", file.line_and_column(span.start).0, fault.message),
            None => fault.message.clone(),
        };
        if let Some(fault) = document.faults.first() {
            return Err(told(fault));
        }
        let root = document.root.ok_or("the file is empty")?;
        let mut submission = Self::new(place);
        for entry in entries("a submission", &root)? {
            match KEYS.into_iter().find(|(_, name)| *name == entry.key) {
                Some((key, _)) => submission.put_key(key, of_node(entry)?)?,
                None if entry.key == "answers" && entry.value.is_null() => {}
                None if entry.key == "answers" => {
                    for answer in entries("`answers`", &entry.value)? {
                        submission.put_answer(&answer.key, of_node(answer)?);
                    }
                }
                None => {
                    let known = KEYS.map(|(_, name)| name).join(", ");
                    let key = super::excerpt(&entry.key);
                    return Err(format!(
                        "`{key}` is not a key of a submission\nhelp: the keys are {known} and answers"
                    ));
                }
            }
        }
        Ok(submission)
    }
}

/// The fault, with the column; a line of JSON lines is the first for the parser.
fn without_line(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let message = message.split(" at line ").next().unwrap_or_default();
    format!("{message} (at character {})", error.column())
}

/// A value of JSON as it was typed.
fn of_raw(name: &str, value: &RawValue) -> Result<String, String> {
    match value.get() {
        "null" => Ok(String::new()),
        "true" => Ok("yes".to_owned()),
        "false" => Ok("no".to_owned()),
        text if text.starts_with('"') => serde_json::from_str(text).map_err(|error| without_line(&error)),
        text if text.starts_with(['[', '{']) => Err(no_value(name)),
        number => Ok(number.to_owned()),
    }
}

fn entries<'a>(what: &str, node: &'a Node) -> Result<&'a [Entry], String> {
    match &node.kind {
        Kind::Mapping(mapping) => Ok(mapping.entries()),
        Kind::Scalar(_) | Kind::List(_) => Err(format!("{what} is a mapping, with `key: value` on each line")),
    }
}

/// A value of YAML as it was typed.
fn of_node(entry: &Entry) -> Result<&str, String> {
    match &entry.value.kind {
        Kind::Scalar(_) if entry.value.is_null() => Ok(""),
        Kind::Scalar(scalar) => Ok(match (scalar.style, scalar.text.as_str()) {
            (Style::Plain, "true" | "True" | "TRUE") => "yes",
            (Style::Plain, "false" | "False" | "FALSE") => "no",
            (_, text) => text,
        }),
        Kind::List(_) | Kind::Mapping(_) => Err(no_value(&entry.key)),
    }
}

fn no_value(name: &str) -> String {
    format!("`{}` is neither a text nor a number", super::excerpt(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn json(text: &str) -> Result<String, String> {
        Submission::of_json(Place::Line(1), text).map(|read| shown(&read))
    }

    fn yaml(text: &str) -> Result<String, String> {
        Submission::of_yaml(Place::Line(1), &Source::new("a.yaml", text)).map(|read| shown(&read))
    }

    fn shown(submission: &Submission) -> String {
        let answers: Vec<String> = submission.answers().map(|(part, answer)| format!("{part}={answer}")).collect();
        format!("{} {} {}", submission.key(Key::Problem), submission.key(Key::Seed), answers.join(" "))
    }

    #[test]
    fn numbers_keep_the_digits_that_were_typed() {
        let expected = Ok("a/b 007 e=0.500 v=1.50e3 w=-0.0 x=\u{e9} y=yes".to_owned());
        let object = r#"{"problem":"a/b","seed":"007","answers":{"e":0.500,"v":1.50e3,"w":-0.0,"x":"\u00e9","y":true,"z":null}}"#;
        assert_eq!(json(object), expected);
        assert_eq!(
            yaml("problem: a/b\nseed: 007\nanswers: {e: 0.500, v: 1.50e3, w: -0.0, x: é, y: true, z: ~}"),
            expected
        );
    }

    #[test]
    fn what_is_said_twice_is_refused() {
        let twice = |text: &str| json(text).unwrap_err();
        assert!(twice(r#"{"problem":"a","seed":1,"answers":{"v":"1","v":"2"}}"#).starts_with("`v` is answered twice"));
        assert!(twice(r#"{"problem":"a","seed":1,"seed":2}"#).starts_with("duplicate field `seed`"));
        assert!(
            yaml("problem: a\nseed: 1\nanswers:\n  v: 1\n  v: 2\n").unwrap_err().starts_with("line 5: `v` is repeated")
        );
        assert!(yaml("problem: a\nseed: 1\nseed: 1\n").unwrap_err().starts_with("line 3: `seed` is repeated"));
    }

    #[test]
    fn what_is_no_submission_is_told() {
        assert!(json("{").unwrap_err().starts_with("EOF"));
        assert_eq!(
            json(r#"{"problem":1,"seed":2,"answers":{"v":[]}}"#),
            Err("`v` is neither a text nor a number".into())
        );
        assert!(json(r#"{"problem":1,"seed":2,"mark":5}"#).unwrap_err().starts_with("unknown field `mark`"));
        assert!(yaml("problem: a\nmark: 5\n").unwrap_err().starts_with("`mark` is not a key of a submission"));
        assert!(yaml("- a\n").unwrap_err().starts_with("a submission is a mapping"));
        assert!(yaml("a: &x 1\n").is_err() && yaml("").is_err());
        assert_eq!(yaml("problem: a\nseed: 1\nanswers:\n"), Ok("a 1 ".into()));
    }
}
