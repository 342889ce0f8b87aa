//! The first reading of a document, against the schema: every wrong key and every value of a wrong form, all at once.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::RangeInclusive;

use serde_yaml::{Mapping, Number, Value};

use momentous_fault::{Code, Fault, Path, did_you_mean};

use super::advice::advice;
use super::document::{Entry, Kind, Node, Scalar, Style, usual_key};
use super::shape::{Form, Keys, Place, Shapes};

/// Reads a document by a schema. A scalar becomes a number or a truth value only where the schema allows no text,
/// so that a decimal stays as it was written. What is faulty is left out of the value.
pub(crate) fn check(root: &Node, shapes: &Shapes) -> (Value, Vec<Fault>) {
    let mut checker = Checker { shapes, faults: Vec::new() };
    let value = checker.value(root, &shapes.root, &Path::root(), What::File);
    (value.unwrap_or_default(), checker.faults)
}

/// Keys that name one thing, each with the key under which several are named where that can be.
const ONE_AND_SEVERAL: &[(&str, &str)] = &[("body", "bodies")];

struct Checker<'s> {
    shapes: &'s Shapes<'s>,
    faults: Vec<Fault>,
}

/// How a fault refers to a value.
#[derive(Clone, Copy)]
enum What<'w> {
    File,
    Key(&'w str),
    Item(usize, &'w What<'w>),
}

impl fmt::Display for What<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => write!(formatter, "the file"),
            Self::Key(key) => write!(formatter, "`{key}`"),
            Self::Item(index, of) => write!(formatter, "item {} of {of}", index + 1),
        }
    }
}

impl<'s> Checker<'s> {
    /// Reads a value; a fault of it that knows no better way out tells what the schema says of the place.
    fn value(&mut self, node: &Node, place: &'s Place<'s>, path: &Path, what: What) -> Option<Value> {
        let before = self.faults.len();
        let value = self.formed(node, place, path, what);
        for fault in self.faults.iter_mut().skip(before).filter(|fault| fault.help.is_none()) {
            fault.help = place.about.map(|about| format!("{what}: {about}"));
        }
        value
    }

    fn formed(&mut self, node: &Node, place: &'s Place<'s>, path: &Path, what: What) -> Option<Value> {
        let forms = self.shapes.forms(place);
        if node.is_null() {
            let help = format!("write {} after the colon, or remove the key", expected(forms));
            self.fault(Fault::new(Code::Value, format!("{what} has no value")).help(help), path);
            return None;
        }
        let found = match &node.kind {
            Kind::Scalar(scalar) => return self.scalar(scalar, place, path, what),
            Kind::List(items) => {
                let list =
                    |form: &'s Form<'s>| if let Form::List(counts, item) = form { Some((counts, item)) } else { None };
                if let Some((counts, item)) = forms.clone().find_map(list) {
                    return self.list(items, (counts.as_ref(), item), path, what);
                }
                "a list"
            }
            Kind::Mapping(mapping) => {
                let entries = mapping.entries();
                let keys = |form: &'s Form<'s>| if let Form::Mapping(keys) = form { Some(keys) } else { None };
                let objects: Vec<&Keys<'s>> = forms.clone().filter_map(keys).collect();
                if !objects.is_empty() {
                    return self.mapping(entries, &objects, path, what);
                }
                "a mapping"
            }
        };
        self.fault(Fault::new(Code::Value, format!("{what} must be {}, not {found}", expected(forms))), path);
        None
    }

    fn scalar(&mut self, scalar: &Scalar, place: &'s Place<'s>, path: &Path, what: What) -> Option<Value> {
        let text = scalar.text.as_str();
        let forms = self.shapes.forms(place);
        let allows = |test: fn(&Form) -> bool| forms.clone().any(test);
        if forms.clone().any(|form| form.word() == Some(text)) {
            return Some(text.into());
        }
        if allows(|form| matches!(form, Form::Text)) {
            let numbers_welcome = allows(|form| matches!(form, Form::Number));
            let trap = (scalar.style == Style::Plain).then(|| trap(text, numbers_welcome)).flatten();
            let Some(trap) = trap else { return Some(text.into()) };
            let fault = Fault::new(Code::Value, format!("`{text}` would be read as {trap}"));
            let help = match what {
                What::Key("id") => "a name begins with a letter".to_owned(),
                _ => format!("write \"{text}\", in quotes, if the text is meant"),
            };
            self.fault(fault.help(help), path);
            return None;
        }
        let plain = scalar.style == Style::Plain;
        let may_be_truth = allows(|form| matches!(form, Form::Truth));
        let range = forms.clone().find_map(|form| if let Form::Whole(range) = form { Some(range) } else { None });
        match (text, text.parse::<u64>(), range) {
            ("true" | "false", ..) if plain && may_be_truth => return Some(Value::Bool(text == "true")),
            (_, Ok(number), Some(range)) if plain => {
                if range.contains(&number) {
                    return Some(Value::Number(Number::from(number)));
                }
                let (least, greatest) = (range.start(), range.end());
                let message = format!("{what} must lie between {least} and {greatest}, not at {number}");
                self.fault(Fault::new(Code::Value, message), path);
                return None;
            }
            _ => {}
        }
        let fault = Fault::new(Code::Value, format!("{what} must be {}, not `{}`", expected(forms), beginning(text)));
        self.fault(
            match (did_you_mean(text, self.shapes.words(place)), truth(text)) {
                (Some(word), _) => fault.help(format!("did you mean `{word}`?")),
                (None, Some(truth)) if may_be_truth => fault.help(format!("write `{truth}`")),
                _ if !plain && text.parse::<u64>().is_ok() => fault.help("remove the quotes"),
                _ => fault,
            },
            path,
        );
        None
    }

    fn list(
        &mut self,
        items: &[Node],
        (counts, place): (Option<&RangeInclusive<usize>>, &'s Place<'s>),
        path: &Path,
        what: What,
    ) -> Option<Value> {
        if let Some(counts) = counts.filter(|counts| !counts.contains(&items.len())) {
            let (least, greatest) = (counts.start(), counts.end());
            let wanted = if least == greatest { format!("exactly {least}") } else { format!("{least} to {greatest}") };
            let message = format!("{what} must have {wanted} items, not {}", items.len());
            self.fault(Fault::new(Code::Value, message), path);
            return None;
        }
        let read = |(index, item): (usize, &Node)| {
            self.value(item, place, &path.index(index), What::Item(index, &what)).unwrap_or_default()
        };
        Some(Value::Sequence(items.iter().enumerate().map(read).collect()))
    }

    fn mapping(&mut self, entries: &[Entry], objects: &[&'s Keys<'s>], path: &Path, what: What) -> Option<Value> {
        let keys = self.choose(entries, objects, path, what)?;
        let mut meant = BTreeSet::new();
        // The keys that there may be, and those of them that are not there; for the first key that may not.
        let mut offered = None;
        let mut mapping = Mapping::new();
        for Entry { key, value, .. } in entries {
            let usual = if keys.place(key).is_some() { key.as_str() } else { usual_key(key) };
            let Some(place) = keys.place(usual) else {
                let (known, free) = offered.get_or_insert_with(|| {
                    let known: Vec<&str> = keys.names().chain(keys.listed.iter().flatten().copied()).collect();
                    let is_free = |name: &&str| entries.iter().all(|entry| entry.key != **name);
                    let free: Vec<&str> = known.iter().copied().filter(is_free).collect();
                    (known, free)
                });
                meant.extend(did_you_mean(key, free.iter().copied()));
                let rival = objects.iter().any(|other| other.required.first() == Some(&key.as_str()));
                let help = match (rival, did_you_mean(key, known.iter().copied())) {
                    (true, _) => {
                        let first_key = keys.required.first().copied().unwrap_or_default();
                        format!("it cannot be combined with `{first_key}`: begin a new item with `- `")
                    }
                    (false, Some(name)) => {
                        let others: Vec<&str> = free.iter().copied().filter(|key| *key != name).collect();
                        let others = match &others[..] {
                            [] => String::new(),
                            others => format!(" Other keys here: {}.", quoted(others, "and")),
                        };
                        format!("did you mean `{name}`?{others}")
                    }
                    (false, None) if advice(key).is_some() => advice(key).unwrap_or_default().to_owned(),
                    (false, None) if free.is_empty() => {
                        "all possible keys are already here: remove this one".to_owned()
                    }
                    (false, None) if key.split_whitespace().nth(1).is_some() => {
                        "within `{ }` a text with a comma or a colon stands in quotation marks".to_owned()
                    }
                    (false, None) => format!("the keys here are {}", quoted(known, "and")),
                };
                let fault = Fault::new(Code::UnknownKey, format!("`{key}` is not a key of {what}"));
                self.fault(fault.help(help), &path.name(key.as_str()));
                continue;
            };
            let child = match ONE_AND_SEVERAL.iter().find(|(one, _)| *one == usual) {
                Some((_, several)) if matches!(value.kind, Kind::List(_)) && !self.takes_a_list(place) => {
                    let help = match keys.named(several) {
                        Some(_) => format!("name several under `{several}`"),
                        None => format!("{what} is about one: give it a stage for each"),
                    };
                    let fault = Fault::new(Code::Value, format!("`{key}` must be text, not a list"));
                    self.fault(fault.help(help), &path.key(key.as_str()));
                    None
                }
                _ => self.value(value, place, &path.key(key.as_str()), What::Key(key)),
            };
            if mapping.insert(usual.into(), child.unwrap_or_default()).is_some() {
                let fault =
                    Fault::new(Code::UnknownKey, format!("`{key}` is a second name for a key that is already here"));
                self.fault(fault.help(format!("keep `{usual}`")), &path.name(key.as_str()));
            }
        }
        let is_there = |name: &str| entries.iter().any(|entry| entry.key == name || usual_key(&entry.key) == name);
        for name in keys.required.iter().filter(|name| !is_there(name) && !meant.contains(*name)) {
            let place = keys.named(name);
            let about = place.and_then(|place| place.about).unwrap_or_default();
            let words = place.map(|place| self.shapes.words(place)).filter(|words| !words.is_empty());
            let words = words.map_or_else(String::new, |words| format!(" One of {}.", quoted(&words, "and")));
            let help = format!("add `{name}:`. {about}{words}");
            let fault = Fault::new(Code::MissingKey, format!("{what} lacks the key `{name}`"));
            self.fault(fault.help(help.trim_end()), path);
        }
        Some(Value::Mapping(mapping))
    }

    /// The form that the author had in mind: the one of which most of the required keys are there.
    fn choose(&mut self, entries: &[Entry], objects: &[&'s Keys<'s>], path: &Path, what: What) -> Option<&'s Keys<'s>> {
        if let [only] = objects {
            return Some(only);
        }
        let has = |name: &&str| entries.iter().any(|entry| entry.key == *name || usual_key(&entry.key) == *name);
        let score = |keys: &Keys| (keys.required.iter().copied().filter(has).count(), keys.names().filter(has).count());
        let best = objects.iter().rev().max_by_key(|keys| score(keys)).copied()?;
        if score(best).0 > 0 || best.required.is_empty() && score(best).1 > 0 {
            return Some(best);
        }
        let heads: Vec<&str> = objects.iter().filter_map(|keys| keys.required.first().copied()).collect();
        let typing = entries.iter().find_map(|entry| Some((entry, did_you_mean(&entry.key, heads.iter().copied())?)));
        let (message, help, place) = match (typing, entries) {
            (Some((entry, meant)), _) => (
                format!("`{}` is not a key of {what}", entry.key),
                format!("did you mean `{meant}`?"),
                path.name(entry.key.as_str()),
            ),
            (None, [entry]) => (
                format!("`{}` is not a key of {what}", entry.key),
                format!("the keys here are {}", quoted(&heads, "and")),
                path.name(entry.key.as_str()),
            ),
            (None, _) => (
                format!("the kind of {what} is missing"),
                format!("add one of the keys {}", quoted(&heads, "or")),
                path.clone(),
            ),
        };
        self.fault(Fault::new(Code::UnknownKey, message).help(help), &place);
        None
    }

    fn takes_a_list(&self, place: &Place<'s>) -> bool {
        self.shapes.forms(place).any(|form| matches!(form, Form::List(..)))
    }

    fn fault(&mut self, fault: Fault, path: &Path) {
        self.faults.push(fault.at_path(path.clone()));
    }
}

/// Another reading that YAML tools may have of a plain text, where it is a trap.
fn trap(text: &str, numbers_welcome: bool) -> Option<&'static str> {
    if truth(text).is_some() {
        return Some("true or false");
    }
    // Every number begins so, and reading a document for each text is dear.
    let may_be_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    (!numbers_welcome && may_be_number && serde_yaml::from_str::<Number>(text).is_ok()).then_some("a number")
}

/// The beginning of a text, as long as a message can bear.
fn beginning(text: &str) -> String {
    const MOST: usize = 40;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// The truth value that YAML 1.1 or 1.2 sees in a word.
fn truth(text: &str) -> Option<bool> {
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" => Some(true),
        "false" | "no" | "off" => Some(false),
        _ => None,
    }
}

/// The forms that may stand in a place, in words.
fn expected<'s>(forms: impl Iterator<Item = &'s Form<'s>> + Clone) -> String {
    let has = |test: fn(&Form) -> bool| forms.clone().any(test);
    let is_text = has(|form| matches!(form, Form::Text));
    let text = if has(|form| matches!(form, Form::Number)) { "a value, a name or an expression" } else { "text" };
    let plain = [
        (is_text, text),
        (!is_text && has(|form| matches!(form, Form::Whole(_))), "a whole number"),
        (has(|form| matches!(form, Form::Truth)), "`true` or `false`"),
        (has(|form| matches!(form, Form::List(..))), "a list"),
        (has(|form| matches!(form, Form::Mapping(_))), "a mapping"),
    ];
    let words = forms.filter_map(Form::word).map(|word| format!("`{word}`"));
    let plain = plain.iter().filter(|(counts, _)| *counts).map(|(_, phrase)| (*phrase).to_owned());
    join(&words.chain(plain).collect::<Vec<_>>(), "or")
}

fn quoted(names: &[&str], conjunction: &str) -> String {
    join(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>(), conjunction)
}

fn join(phrases: &[String], conjunction: &str) -> String {
    match phrases {
        [] => "nothing".to_owned(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} {conjunction} {last}", most.join(", ")),
    }
}
