//! Motion under a central force.

use schemars::JsonSchema;
use serde::Deserialize;

/// A particle moves from one place to another under a force that always points to, or away from, a fixed point.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Central {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The particle.
    pub body: String,
    /// The fixed point.
    pub about: String,
}
