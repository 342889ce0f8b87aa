//! Fields of a form as they were typed, and their faults.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::FieldFault;
use momentous_exercise::calls::{Refused, RefusedKind};

use super::super::visit::Visit;

/// The fields of a form by their names, as a template shows them.
#[derive(Clone, Debug, Default, Serialize)]
#[serde(transparent)]
pub(crate) struct Form(BTreeMap<String, Entry>);

/// A field: what is in it, and what is wrong with that.
#[derive(Clone, Debug, Default, Serialize)]
struct Entry {
    name: String,
    value: String,
    fault: Option<String>,
}

impl Form {
    /// Fields with what is in them.
    pub(crate) fn new<N: Into<String>>(fields: impl IntoIterator<Item = (N, String)>) -> Self {
        let entry = |(name, value): (N, String)| {
            let name = name.into();
            (name.clone(), Entry { name, value, fault: None })
        };
        Self(fields.into_iter().map(entry).collect())
    }

    /// These fields, as they were sent.
    pub(crate) fn sent(visit: &Visit, names: &[&str]) -> Self {
        let value = |name: &&str| ((*name).to_owned(), visit.fields.text(name).to_owned());
        Self::new(names.iter().map(value))
    }

    /// Puts something into a field.
    pub(crate) fn fill(&mut self, name: &str, value: String) {
        self.0.entry(name.to_owned()).or_default().value = value;
    }

    /// The value of a field, without spaces around it.
    pub(crate) fn value(&self, name: &str) -> &str {
        self.0.get(name).map_or("", |entry| entry.value.trim())
    }

    /// The same with what is wrong. What belongs to no field is said of the first.
    pub(crate) fn with(mut self, faults: &[FieldFault]) -> Self {
        for fault in faults {
            self.say(fault.field, &fault.message);
        }
        self
    }

    /// Says what is wrong with a field; a line `help:` says the way out.
    pub(crate) fn say(&mut self, name: &str, message: &str) {
        let entry = self.0.entry(name.to_owned()).or_default();
        let said = sentences(message);
        entry.fault = Some(match entry.fault.take() {
            None => said,
            Some(before) => format!("{before} {said}"),
        });
    }

    /// Whether something is wrong.
    pub(crate) fn is_wrong(&self) -> bool {
        self.0.values().any(|entry| entry.fault.is_some())
    }
}

/// A message whose last line may say the way out, as sentences.
pub(super) fn sentences(message: &str) -> String {
    let (said, help) = message.split_once("\nhelp: ").map_or((message, None), |(said, help)| (said, Some(help)));
    let refused = Refused::new(RefusedKind::Invalid, said);
    help.map_or(refused.clone(), |help| refused.help(help)).sentences().join(" ")
}
