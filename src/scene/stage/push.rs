//! Forces of known law that act on a body for a time.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::{Force, Term};

/// Forces act on a body for a time.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Push {
    /// A name for the stage, used in brackets: `dt[push]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// How long: a duration (`dt`, `4 s`), or the start and the end on the body's own clock (`[0 s, t_2]`).
    pub during: During,
    /// The forces. Weight acts by itself in a vertical plane.
    pub forces: Vec<Force>,
}

/// How long a stage lasts.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum During {
    /// Start and end.
    Between([Term; 2]),
    /// A duration; the stage's clock starts at zero.
    For(Term),
}
