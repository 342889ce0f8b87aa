//! Faults of what somebody typed into a form, field by field.

use serde::Serialize;

/// The fault of a field, and the way out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FieldFault {
    /// The field's name.
    pub field: &'static str,
    /// The fault, as a sentence begins; a line `help:` says the way out.
    pub message: String,
}

/// The faults of a form on the way.
#[derive(Debug, Default)]
pub(super) struct Faults(Vec<FieldFault>);

impl Faults {
    /// Says what is wrong with a field.
    pub(super) fn say(&mut self, field: &'static str, message: impl Into<String>) {
        self.0.push(FieldFault { field, message: message.into() });
    }

    /// Reads a field; returns `None` where it is at fault, which is said.
    pub(super) fn take<T, E: ToString>(&mut self, field: &'static str, read: Result<T, E>) -> Option<T> {
        read.map_err(|message| self.say(field, message.to_string())).ok()
    }

    /// Returns the value made of the fields, or their faults.
    ///
    /// # Errors
    /// All faults, where there are any, or nothing was made.
    pub(super) fn or<T>(self, value: Option<T>) -> Result<T, Vec<FieldFault>> {
        match value {
            Some(value) if self.0.is_empty() => Ok(value),
            _ => Err(self.0),
        }
    }
}
