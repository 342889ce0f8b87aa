//! A walk on something that floats.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body walks along another that is free to move, from rest to rest: a person along a boat.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Walk {
    /// A name for the stage, used in brackets: `s_B[walk]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that walks.
    pub body: String,
    /// What it walks on.
    pub on: String,
    /// How far it walks relative to what it walks on, positive along the first axis.
    pub distance: Term,
}
