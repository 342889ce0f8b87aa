//! What ends a stage.

use schemars::JsonSchema;
use serde::Deserialize;

/// What ends a stage, where neither a time nor a place does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Until {
    /// The body comes to rest.
    Rest,
}

/// The same, where another body may carry the one that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Halt {
    /// The body comes to rest.
    Rest,
    /// The body and the one that carries it have the same velocity.
    Together,
}
