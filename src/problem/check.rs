//! The first reading of a document, against the schema: every wrong key and every value of a wrong form, all at once.

use serde_json::{Map, Value as Json};
use serde_yaml::{Mapping, Number, Value};

use crate::fault::{Code, Fault, Path, did_you_mean};

use super::document::{Entry, Kind, Node, Scalar, Style};

/// One form that a value may take: a schema without alternatives.
type Form<'s> = &'s Map<String, Json>;

/// Reads a document by a JSON Schema. A scalar becomes a number or a truth value only where the schema allows no text,
/// so that a decimal stays as it was written. What is faulty is left out of the value.
#[must_use]
pub fn check(root: &Node, schema: &Json) -> (Value, Vec<Fault>) {
    let mut checker = Checker { definitions: schema.get("$defs").and_then(Json::as_object), faults: Vec::new() };
    let value = checker.value(root, schema, &Path::root(), "the file");
    (value.unwrap_or_default(), checker.faults)
}

struct Checker<'s> {
    /// What references of the schema name.
    definitions: Option<Form<'s>>,
    faults: Vec<Fault>,
}

impl<'s> Checker<'s> {
    /// Reads a value; a fault of it that knows no better way out tells what the schema says of the place.
    fn value(&mut self, node: &Node, schema: &'s Json, path: &Path, what: &str) -> Option<Value> {
        let before = self.faults.len();
        let value = self.formed(node, schema, path, what);
        for fault in self.faults.iter_mut().skip(before).filter(|fault| fault.help.is_none()) {
            fault.help = schema.get("description").and_then(Json::as_str).map(|about| format!("{what}: {about}"));
        }
        value
    }

    fn formed(&mut self, node: &Node, schema: &'s Json, path: &Path, what: &str) -> Option<Value> {
        let mut forms = Vec::new();
        self.forms(schema, &mut forms);
        if node.is_null() {
            let help = format!("write {} after the colon, or remove the key", expected(&forms));
            self.fault(Fault::new(Code::Value, format!("{what} has no value")).help(help), path);
            return None;
        }
        let found = match &node.kind {
            Kind::Scalar(scalar) => return self.scalar(scalar, &forms, path, what),
            Kind::List(items) => match forms.iter().find(|form| is(form, "array")) {
                Some(form) => return self.list(items, form, path, what),
                None => "a list",
            },
            Kind::Mapping(entries) => {
                let objects: Vec<Form<'s>> = forms.iter().copied().filter(|form| is(form, "object")).collect();
                if !objects.is_empty() {
                    return self.mapping(entries, &objects, path, what);
                }
                "a mapping"
            }
        };
        self.fault(Fault::new(Code::Value, format!("{what} must be {}, not {found}", expected(&forms))), path);
        None
    }

    /// All forms that a schema allows, references followed.
    fn forms(&self, schema: &'s Json, forms: &mut Vec<Form<'s>>) {
        let Json::Object(map) = schema else { return };
        if let Some(reference) = map.get("$ref").and_then(Json::as_str) {
            let name = reference.strip_prefix("#/$defs/");
            if let Some(target) = name.and_then(|name| self.definitions?.get(name)) {
                self.forms(target, forms);
            }
            return;
        }
        match map.get("anyOf").or(map.get("oneOf")) {
            Some(Json::Array(alternatives)) => alternatives.iter().for_each(|form| self.forms(form, forms)),
            _ => forms.push(map),
        }
    }

    /// The words of which one may stand in a place.
    fn words(&self, schema: &'s Json) -> Vec<&'s str> {
        let mut forms = Vec::new();
        self.forms(schema, &mut forms);
        forms.iter().filter_map(|form| form.get("const")?.as_str()).collect()
    }

    fn scalar(&mut self, scalar: &Scalar, forms: &[Form<'s>], path: &Path, what: &str) -> Option<Value> {
        let text = scalar.text.as_str();
        let allows = |kind: &str| forms.iter().any(|form| is(form, kind) && !form.contains_key("const"));
        let words: Vec<&str> = forms.iter().filter_map(|form| form.get("const")?.as_str()).collect();
        if words.contains(&text) {
            return Some(text.into());
        }
        if allows("string") {
            let trap = (scalar.style == Style::Plain).then(|| trap(text, allows("number"))).flatten();
            let Some(trap) = trap else { return Some(text.into()) };
            let fault = Fault::new(Code::Value, format!("`{text}` would be read as {trap}"));
            self.fault(fault.help(format!("write \"{text}\", in quotes, if the text is meant")), path);
            return None;
        }
        let plain = scalar.style == Style::Plain;
        match (text, text.parse::<u64>()) {
            ("true" | "false", _) if plain && allows("boolean") => return Some(Value::Bool(text == "true")),
            (_, Ok(number)) if plain && allows("integer") => return self.integer(number, forms, path, what),
            _ => {}
        }
        let fault = Fault::new(Code::Value, format!("{what} must be {}, not `{text}`", expected(forms)));
        self.fault(
            match (did_you_mean(text, words.iter().copied()), truth(text)) {
                (Some(word), _) => fault.help(format!("did you mean `{word}`?")),
                (None, Some(truth)) if allows("boolean") => fault.help(format!("write `{truth}`")),
                _ if !plain && text.parse::<u64>().is_ok() => fault.help("remove the quotes"),
                _ => fault,
            },
            path,
        );
        None
    }

    fn integer(&mut self, number: u64, forms: &[Form<'s>], path: &Path, what: &str) -> Option<Value> {
        let bound = |name: &str| forms.iter().find_map(|form| form.get(name)?.as_u64());
        let (least, greatest) = (bound("minimum").unwrap_or(0), bound("maximum").unwrap_or(u64::MAX));
        if (least..=greatest).contains(&number) {
            return Some(Value::Number(Number::from(number)));
        }
        let message = format!("{what} must lie between {least} and {greatest}, not at {number}");
        self.fault(Fault::new(Code::Value, message), path);
        None
    }

    fn list(&mut self, items: &[Node], form: Form<'s>, path: &Path, what: &str) -> Option<Value> {
        let bound = |name: &str| form.get(name).and_then(Json::as_u64).and_then(|bound| usize::try_from(bound).ok());
        if let (Some(least), Some(greatest)) = (bound("minItems"), bound("maxItems"))
            && !(least..=greatest).contains(&items.len())
        {
            let wanted = if least == greatest { format!("exactly {least}") } else { format!("{least} to {greatest}") };
            let message = format!("{what} must have {wanted} items, not {}", items.len());
            self.fault(Fault::new(Code::Value, message), path);
            return None;
        }
        let schema = form.get("items").unwrap_or(&Json::Null);
        let mut read = |(index, item): (usize, &Node)| {
            let what = format!("item {} of {what}", index + 1);
            self.value(item, schema, &path.index(index), &what).unwrap_or_default()
        };
        Some(Value::Sequence(items.iter().enumerate().map(&mut read).collect()))
    }

    fn mapping(&mut self, entries: &[Entry], objects: &[Form<'s>], path: &Path, what: &str) -> Option<Value> {
        let form = self.choose(entries, objects, path, what)?;
        let properties = form.get("properties").and_then(Json::as_object);
        let allowed_names = form.get("propertyNames").and_then(|names| names["enum"].as_array());
        let mut meant = Vec::new();
        let mut mapping = Mapping::new();
        for Entry { key, value, .. } in entries {
            let others = form.get("additionalProperties").filter(|others| others.is_object());
            let others = others.filter(|_| allowed_names.is_none_or(|names| names.iter().any(|name| name == key)));
            let Some(schema) = properties.and_then(|properties| properties.get(key)).or(others) else {
                let listed = allowed_names.into_iter().flatten().filter_map(Json::as_str);
                let known: Vec<&str> = known_keys(form).chain(listed).collect();
                let free = known.iter().copied().filter(|name| entries.iter().all(|entry| entry.key != *name));
                let free: Vec<&str> = free.collect();
                meant.extend(did_you_mean(key, free.iter().copied()));
                let rival = objects.iter().any(|other| first_required(other) == Some(key.as_str()));
                let help = match (rival, did_you_mean(key, known.iter().copied())) {
                    (true, _) => format!(
                        "it cannot stand beside `{}`: begin a new item with `- `",
                        first_required(form).unwrap_or_default()
                    ),
                    (false, Some(name)) => format!("did you mean `{name}`?"),
                    (false, None) if free.is_empty() => "all keys that can stand here do: remove this one".to_owned(),
                    (false, None) => format!("the keys here are {}", quoted(&free, "and")),
                };
                let fault = Fault::new(Code::UnknownKey, format!("`{key}` is not a key of {what}"));
                self.fault(fault.help(help), &path.name(key.as_str()));
                continue;
            };
            let child = self.value(value, schema, &path.key(key.as_str()), &format!("`{key}`"));
            mapping.insert(key.as_str().into(), child.unwrap_or_default());
        }
        for name in
            required(form).filter(|name| entries.iter().all(|entry| entry.key != *name) && !meant.contains(name))
        {
            let description = properties.and_then(|properties| properties.get(name)?.get("description")?.as_str());
            let words = properties.and_then(|properties| properties.get(name)).map(|schema| self.words(schema));
            let words = words.filter(|words| !words.is_empty());
            let words = words.map_or_else(String::new, |words| format!(" One of {}.", quoted(&words, "and")));
            let help = format!("add `{name}:`. {}{words}", description.unwrap_or_default());
            let fault = Fault::new(Code::MissingKey, format!("{what} lacks the key `{name}`"));
            self.fault(fault.help(help.trim_end()), path);
        }
        Some(Value::Mapping(mapping))
    }

    /// The form that the author had in mind: the one of which most of the required keys are there.
    fn choose(&mut self, entries: &[Entry], objects: &[Form<'s>], path: &Path, what: &str) -> Option<Form<'s>> {
        let has = |name: &str| entries.iter().any(|entry| entry.key == name);
        let score = |form: &Form<'s>| {
            (required(form).filter(|name| has(name)).count(), known_keys(form).filter(|name| has(name)).count())
        };
        let best = objects.iter().rev().max_by_key(|form| score(form)).copied()?;
        let needs_none = required(best).next().is_none();
        if objects.len() == 1 || score(&best).0 > 0 || needs_none && score(&best).1 > 0 {
            return Some(best);
        }
        let heads: Vec<&str> = objects.iter().filter_map(|form| first_required(form)).collect();
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
                format!("{what} does not say of which kind it is"),
                format!("add one of the keys {}", quoted(&heads, "or")),
                path.clone(),
            ),
        };
        self.fault(Fault::new(Code::UnknownKey, message).help(help), &place);
        None
    }

    fn fault(&mut self, fault: Fault, path: &Path) {
        self.faults.push(fault.at_path(path.clone()));
    }
}

fn required(form: Form<'_>) -> impl Iterator<Item = &str> {
    form.get("required").and_then(Json::as_array).into_iter().flatten().filter_map(Json::as_str)
}

/// Whether a form is of that JSON type.
fn is(form: Form<'_>, kind: &str) -> bool {
    form.get("type").and_then(Json::as_str) == Some(kind)
}

fn first_required(form: Form<'_>) -> Option<&str> {
    required(form).next()
}

fn known_keys(form: Form<'_>) -> impl Iterator<Item = &str> {
    form.get("properties").and_then(Json::as_object).into_iter().flat_map(Map::keys).map(String::as_str)
}

/// What else YAML tools may make of a plain text, where it is a trap.
fn trap(text: &str, numbers_welcome: bool) -> Option<&'static str> {
    if truth(text).is_some() {
        return Some("true or false");
    }
    // Every number begins so, and reading a document for each text is dear.
    let may_be_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    (!numbers_welcome && may_be_number && serde_yaml::from_str::<Number>(text).is_ok()).then_some("a number")
}

/// The truth value that YAML 1.1 or 1.2 sees in a word.
fn truth(text: &str) -> Option<bool> {
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" => Some(true),
        "false" | "no" | "off" => Some(false),
        _ => None,
    }
}

/// What may stand in a place, in words.
fn expected(forms: &[Form<'_>]) -> String {
    let words: Vec<&str> = forms.iter().filter_map(|form| form.get("const")?.as_str()).collect();
    let has = |kind: &str| forms.iter().any(|form| is(form, kind) && !form.contains_key("const"));
    let text = if has("number") { "a value, a name or an expression" } else { "text" };
    let plain = [
        ("string", text),
        ("integer", "a whole number"),
        ("boolean", "`true` or `false`"),
        ("array", "a list"),
        ("object", "a mapping"),
    ];
    let mut phrases: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    let counts = |kind: &str| has(kind) && !(kind == "integer" && has("string"));
    phrases.extend(plain.iter().filter(|(kind, _)| counts(kind)).map(|(_, phrase)| (*phrase).to_owned()));
    join(&phrases, "or")
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
