//! The JSON Schema of problem files, from the same types that read them.

use std::sync::LazyLock;

use schemars::JsonSchema;
use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use serde_json::Value;
use serde_json::json;

use super::super::language::draft::Draft;
use super::super::language::homework::HomeworkDraft;
use super::super::language::settings::Course;
use super::document::SAME_KEYS;
use super::shape::Shapes;

/// The schema, made once.
static SCHEMA: LazyLock<Value> = LazyLock::new(|| schema_of::<Draft>("A problem for momentous"));

/// The same for editors, with every word for a key.
static PUBLISHED: LazyLock<Value> = LazyLock::new(|| {
    let mut schema = SCHEMA.clone();
    add_words(&mut schema);
    schema
});

static COURSE_SCHEMA: LazyLock<Value> = LazyLock::new(|| schema_of::<Course>("The settings of a course for momentous"));

static HOMEWORK_SCHEMA: LazyLock<Value> = LazyLock::new(|| schema_of::<HomeworkDraft>("A homework for momentous"));

/// The shapes of the schema, read once.
pub(super) static SHAPES: LazyLock<Shapes<'static>> = LazyLock::new(|| Shapes::of(&SCHEMA));

pub(super) static COURSE_SHAPES: LazyLock<Shapes<'static>> = LazyLock::new(|| Shapes::of(&COURSE_SCHEMA));

pub(super) static HOMEWORK_SHAPES: LazyLock<Shapes<'static>> = LazyLock::new(|| Shapes::of(&HOMEWORK_SCHEMA));

fn schema_of<T: JsonSchema>(title: &str) -> Value {
    let settings = SchemaSettings::draft2020_12().with_transform(RecursiveTransform(without_null));
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("title".to_owned(), title.into());
    schema.to_value()
}

/// The JSON Schema (draft 2020-12) of a problem file, with a description for every key: an editor completes and checks by it.
///
/// ```
/// let schema = momentous_problem::json_schema();
/// assert_eq!(schema["properties"]["title"]["description"], "The title on the sheet.");
/// ```
#[must_use]
pub fn json_schema() -> &'static Value {
    &PUBLISHED
}

/// The JSON Schema of `course.yaml`.
#[must_use]
pub fn course_schema() -> &'static Value {
    &COURSE_SCHEMA
}

/// The JSON Schema of a file of homework.
#[must_use]
pub fn homework_schema() -> &'static Value {
    &HOMEWORK_SCHEMA
}

/// Takes `null` out of what a key may hold: a key that is not wanted is left out.
fn without_null(schema: &mut Schema) {
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|kind| kind != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            schema.insert("type".to_owned(), only);
        }
    }
    if let Some(Value::Array(alternatives)) = schema.get_mut("anyOf") {
        alternatives.retain(|alternative| alternative["type"] != "null");
        if let [Value::Object(only)] = alternatives.as_slice() {
            let only = only.clone();
            schema.remove("anyOf");
            for (key, value) in only {
                if schema.get(&key).is_none() {
                    schema.insert(key, value);
                }
            }
        }
    }
    schema.remove("default");
}

/// Puts beside each key the other words for it: as a further key, or as a further form where it says which form it is.
fn add_words(schema: &mut Value) {
    for (word, usual) in SAME_KEYS {
        let says_form = |form: &Value| form["required"] == json!([usual]);
        let renamed = |form: &Value| {
            let properties = json!({ word: form["properties"][usual] });
            let mut form = form.clone();
            (form["properties"], form["required"]) = (properties, json!([word]));
            form
        };
        if let Some(forms) = schema.get_mut("oneOf").and_then(Value::as_array_mut) {
            let more: Vec<Value> = forms.iter().filter(|form| says_form(form)).map(renamed).collect();
            forms.extend(more);
        }
        if !says_form(schema)
            && let Some(keys) = schema.get_mut("properties").and_then(Value::as_object_mut)
            && let Some(default) = keys.get(usual).cloned()
        {
            keys.insert(word.to_owned(), default);
        }
    }
    match schema {
        Value::Array(items) => items.iter_mut().for_each(add_words),
        Value::Object(entries) => entries.values_mut().for_each(add_words),
        _ => {}
    }
}
