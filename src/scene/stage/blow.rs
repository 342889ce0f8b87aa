//! A blow of unknown history.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Included;

/// A body is struck, caught or thrown: only the impulse, or the average force and the duration, is considered.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Blow {
    /// A name for the stage, used in brackets: `J_A[kick]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// What strikes it, as it is called in a sentence: `the bat`.
    pub by: String,
    /// How long it lasts, if the average force is wanted.
    #[serde(default)]
    pub duration: Option<Term>,
    /// What the balance includes although a short contact usually leaves it out: `[weight]`. It needs the `duration`.
    #[serde(default)]
    pub include: Vec<Included>,
}
