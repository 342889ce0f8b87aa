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
