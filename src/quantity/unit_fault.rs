//! Faults of a text that is not a unit.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Span;

/// A fault in the text of a unit, with its place in that text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct UnitFault {
    /// The fault.
    pub kind: UnitFaultKind,
    /// The place: bytes of the text that was read.
    pub span: Span,
}

/// The ways in which a text is not a unit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitFaultKind {
    /// A name that no unit has.
    #[error("the unit `{name}` is not known")]
    Unknown {
        /// The name.
        name: String,
        /// The nearest names that are known, the nearest first; perhaps none.
        near: Vec<String>,
    },
    /// A text with more than one meaning.
    #[error("`{written}` can be read in two ways")]
    Ambiguous {
        /// The text.
        written: String,
        /// Unambiguous ways to write what may have been meant.
        readings: Vec<String>,
    },
    /// A character that has no place there.
    #[error("`{0}` is not allowed here in a unit")]
    Unexpected(String),
    /// A unit is missing: after an operator, or between brackets.
    #[error("a unit is missing here")]
    Missing,
    /// An exponent that is no integer from -9 to 9.
    #[error("the exponent of a unit is an integer from -9 to 9")]
    Exponent,
    /// A text that is too long, nested too deeply or raised to too high a power.
    #[error("this is too long for a unit")]
    TooLong,
}

impl UnitFault {
    pub(super) fn new(kind: UnitFaultKind, start: usize, end: usize) -> Self {
        Self { kind, span: Span { start, end } }
    }

    /// The way out.
    #[must_use]
    pub fn help(&self) -> String {
        let quoted = |names: &[String]| {
            let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            quoted.join(" or ")
        };
        match &self.kind {
            UnitFaultKind::Unknown { near, .. } if !near.is_empty() => format!("did you mean {}?", quoted(near)),
            UnitFaultKind::Ambiguous { readings, .. } => format!("write {}", quoted(readings)),
            _ => "write units such as `kg`, `m/s^2`, `N s`, `m/(s kg)` or `ft lb`".to_owned(),
        }
    }

    /// The same, moved `bytes` to the right: as a fault of the text that contains the unit.
    #[must_use]
    pub fn shifted(mut self, bytes: usize) -> Self {
        self.span = Span { start: self.span.start + bytes, end: self.span.end + bytes };
        self
    }
}

impl From<UnitFault> for Fault {
    fn from(fault: UnitFault) -> Self {
        Fault::new(Code::UnknownUnit, fault.to_string()).help(fault.help()).at(fault.span)
    }
}
