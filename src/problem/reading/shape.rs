//! Shapes of a document, read out of a JSON Schema once, so that no reading of a document looks through it.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde_json::{Map, Value as Json};

/// A schema without alternatives, as it is written.
type Written<'s> = &'s Map<String, Json>;

/// The shapes that a schema describes.
#[derive(Debug)]
pub(crate) struct Shapes<'s> {
    /// The whole document.
    pub(crate) root: Place<'s>,
    /// Every form that may stand anywhere.
    forms: Vec<Form<'s>>,
}

/// A place, and what may stand there.
#[derive(Debug)]
pub(crate) struct Place<'s> {
    /// The schema's description of the place.
    pub(crate) about: Option<&'s str>,
    /// Positions of the forms among all forms.
    forms: Vec<usize>,
}

/// One form that a value may take.
#[derive(Debug)]
pub(crate) enum Form<'s> {
    /// That word and no other.
    Word(&'s str),
    /// Any text.
    Text,
    /// A whole number in that range.
    Whole(RangeInclusive<u64>),
    /// Any number.
    Number,
    /// True or false.
    Truth,
    /// A list; how many items it may have, and what each is.
    List(Option<RangeInclusive<usize>>, Place<'s>),
    /// A mapping.
    Mapping(Keys<'s>),
}

/// The keys of a mapping.
#[derive(Debug)]
pub(crate) struct Keys<'s> {
    /// The keys that the schema names, with what each holds.
    named: Vec<(&'s str, Place<'s>)>,
    /// Those that may not be missing.
    pub(crate) required: Vec<&'s str>,
    /// The place behind any other key, where others may stand here.
    others: Option<Place<'s>>,
    /// The only names that others may have.
    pub(crate) listed: Option<Vec<&'s str>>,
}

impl<'s> Shapes<'s> {
    /// Reads a schema.
    pub(crate) fn of(schema: &'s Json) -> Self {
        let mut reader = Reader {
            definitions: schema.get("$defs").and_then(Json::as_object),
            met: Vec::new(),
            found: BTreeMap::new(),
        };
        let root = reader.place(schema);
        let mut forms = Vec::new();
        // Reading a form meets others, itself perhaps: a list of stages may stand within a stage.
        while let Some(written) = reader.met.get(forms.len()).copied() {
            forms.push(reader.form(written));
        }
        Self { root, forms }
    }

    /// The forms of a place.
    pub(crate) fn forms<'a>(&'a self, place: &'a Place<'s>) -> impl Iterator<Item = &'a Form<'s>> + Clone {
        place.forms.iter().filter_map(|form| self.forms.get(*form))
    }

    /// The words of which one may stand in a place.
    pub(crate) fn words(&self, place: &Place<'s>) -> Vec<&'s str> {
        self.forms(place).filter_map(Form::word).collect()
    }
}

impl<'s> Form<'s> {
    /// The word that it is.
    pub(crate) fn word(&self) -> Option<&'s str> {
        if let Self::Word(word) = self { Some(word) } else { None }
    }
}

impl<'s> Keys<'s> {
    /// The place behind a key, where the schema names it.
    pub(crate) fn named(&self, key: &str) -> Option<&Place<'s>> {
        self.named.iter().find(|(entry, _)| *entry == key).map(|(_, place)| place)
    }

    /// The place behind a key, where it may stand here.
    pub(crate) fn place(&self, key: &str) -> Option<&Place<'s>> {
        let is_listed = || self.listed.as_ref().is_none_or(|listed| listed.contains(&key));
        self.named(key).or_else(|| self.others.as_ref().filter(|_| is_listed()))
    }

    /// The keys that the schema names, in its order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'s str> {
        self.named.iter().map(|(name, _)| *name)
    }
}

struct Reader<'s> {
    /// The definitions that references name.
    definitions: Option<Written<'s>>,
    /// The forms met so far.
    met: Vec<Written<'s>>,
    /// The position of each, by where it is written.
    found: BTreeMap<*const Map<String, Json>, usize>,
}

impl<'s> Reader<'s> {
    fn place(&mut self, schema: &'s Json) -> Place<'s> {
        let mut forms = Vec::new();
        self.add_forms(schema, &mut forms);
        Place { about: schema.get("description").and_then(Json::as_str), forms }
    }

    /// All forms that a schema allows, references followed.
    fn add_forms(&mut self, schema: &'s Json, forms: &mut Vec<usize>) {
        let Json::Object(written) = schema else { return };
        if let Some(reference) = written.get("$ref").and_then(Json::as_str) {
            let name = reference.strip_prefix("#/$defs/");
            if let Some(target) = name.and_then(|name| self.definitions?.get(name)) {
                self.add_forms(target, forms);
            }
            return;
        }
        if let Some(Json::Array(alternatives)) = written.get("anyOf").or(written.get("oneOf")) {
            for form in alternatives {
                self.add_forms(form, forms);
            }
            return;
        }
        let next = self.met.len();
        let place = *self.found.entry(std::ptr::from_ref(written)).or_insert(next);
        if place == next {
            self.met.push(written);
        }
        forms.push(place);
    }

    fn form(&mut self, written: Written<'s>) -> Form<'s> {
        if let Some(word) = written.get("const").and_then(Json::as_str) {
            return Form::Word(word);
        }
        let bound = |name: &str| written.get(name).and_then(Json::as_u64);
        let count = |name: &str| bound(name).and_then(|bound| usize::try_from(bound).ok());
        match written.get("type").and_then(Json::as_str) {
            Some("object") => Form::Mapping(self.keys(written)),
            Some("array") => {
                let counts = count("minItems").zip(count("maxItems")).map(|(least, most)| least..=most);
                Form::List(counts, self.place(written.get("items").unwrap_or(&Json::Null)))
            }
            Some("integer") => Form::Whole(bound("minimum").unwrap_or(0)..=bound("maximum").unwrap_or(u64::MAX)),
            Some("number") => Form::Number,
            Some("boolean") => Form::Truth,
            // What is left is text: our types know no other kind.
            _ => Form::Text,
        }
    }

    fn keys(&mut self, written: Written<'s>) -> Keys<'s> {
        let strings =
            |list: Option<&'s Json>| list?.as_array().map(|list| list.iter().filter_map(Json::as_str).collect());
        let properties = written.get("properties").and_then(Json::as_object).into_iter().flatten();
        Keys {
            named: properties.map(|(name, schema)| (name.as_str(), self.place(schema))).collect(),
            required: strings(written.get("required")).unwrap_or_default(),
            others: written
                .get("additionalProperties")
                .filter(|others| others.is_object())
                .map(|others| self.place(others)),
            listed: strings(written.get("propertyNames").and_then(|names| names.get("enum"))),
        }
    }
}
