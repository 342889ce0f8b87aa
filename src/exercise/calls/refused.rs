//! Why a call has no response.

use serde::Serialize;

use momentous_fault::Faults;
use momentous_problem::NoVariant;

/// Why a call was refused, for whoever called and for a program to match on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, thiserror::Error)]
#[error("{message}")]
pub struct Refused {
    /// Its kind.
    pub kind: RefusedKind,
    /// The fault, in a sentence without a full stop.
    pub message: String,
    /// The way out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
}

/// The kinds of refusals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RefusedKind {
    /// There is nothing of that name.
    Unknown,
    /// The request cannot be read.
    Invalid,
    /// It is shown in an assignment only, for now.
    Reserved,
    /// The request is too large.
    TooLarge,
    /// The values that were typed cannot be used.
    Values,
    /// Nothing of the scene can be simulated.
    NotSimulated,
    /// A problem file or a template is at fault; its author is told, not the user.
    Fault,
}

impl Refused {
    /// A refusal of that kind.
    pub fn new(kind: RefusedKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into(), help: None }
    }

    /// The same with a way out.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The fault and the way out, as sentences.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        let sentence = |text: &str| {
            let mut letters = text.chars();
            let first = letters.next().map_or_else(String::new, |first| first.to_uppercase().to_string());
            let end = if text.ends_with(['?', '.', '!']) { "" } else { "." };
            format!("{first}{}{end}", letters.as_str())
        };
        [Some(&self.message), self.help.as_ref()].into_iter().flatten().map(|text| sentence(text)).collect()
    }

    /// A file or a template at fault.
    #[must_use]
    pub fn fault(faults: &Faults) -> Self {
        Self::new(RefusedKind::Fault, faults.to_string().trim_end().to_owned())
    }

    /// Values of the user's own that cannot be used: each fault in a sentence, without a place, since no file is to blame.
    #[must_use]
    pub fn values(faults: &Faults) -> Self {
        let messages: Vec<&str> = faults.list.iter().map(|fault| fault.message.as_str()).collect();
        let refused = Self::new(RefusedKind::Values, messages.join("; "));
        match faults.list.iter().find_map(|fault| fault.help.clone()) {
            Some(help) => refused.help(help),
            None => refused,
        }
    }
}

impl From<NoVariant> for Refused {
    fn from(reason: NoVariant) -> Self {
        let refused = Self::new(RefusedKind::Values, reason.to_string());
        refused.help("take another seed")
    }
}
