//! A term as an author wrote it, not yet read.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

/// A number, a number with a unit, a name or an expression: `0.8`, `3 kg`, `m_A`, `2*m_A`.
#[derive(Clone, Debug, PartialEq, Eq, JsonSchema)]
#[schemars(with = "TermForm")]
pub struct Term(pub String);

impl Term {
    /// Whether a name stands in it by itself: `x` in `k*x`, but not in `k_x`.
    #[must_use]
    pub fn mentions(&self, name: &str) -> bool {
        self.0.split(|letter: char| !letter.is_alphanumeric() && letter != '_').any(|word| word == name)
    }

    /// Whether it is the number zero, with a unit or without.
    #[must_use]
    pub fn is_written_as_zero(&self) -> bool {
        let number = self.0.split_whitespace().next().and_then(|number| number.parse::<f64>().ok());
        number.is_some_and(|number| number == 0.0)
    }
}

/// The forms that YAML gives a term.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged)]
#[allow(dead_code, reason = "the variants exist to be described in the schema")]
enum TermForm {
    /// A whole number.
    Integer(i64),
    /// A decimal number.
    Decimal(f64),
    /// Anything else, as text.
    Text(String),
}

impl<'de> Deserialize<'de> for Term {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self(match TermForm::deserialize(deserializer)? {
            TermForm::Integer(value) => value.to_string(),
            TermForm::Decimal(value) => value.to_string(),
            TermForm::Text(text) => text,
        }))
    }
}
