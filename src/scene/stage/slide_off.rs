//! A body that slides down another which is free to move.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body slides from rest down a smooth body that can move along its guide: a block on a wedge with wheels, a bead in a bowl on ice.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlideOff {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that slides.
    pub body: String,
    /// What it slides on; a body with a `guide`.
    pub on: String,
    /// The height through which it sinks.
    pub height: Term,
    /// Where it moves at the end, relative to what it slides on: `30 deg below +x`, `to the right`.
    pub direction: Term,
}
