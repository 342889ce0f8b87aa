//! A free fall through a height.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body moves freely down through a height. Needs a vertical plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fall {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// The height through which it falls: a name, a value or an expression.
    pub height: Term,
}
