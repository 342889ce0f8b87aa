//! Repeated bounces on a level floor.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::Term;

/// A body that was dropped bounces on a level floor, again and again.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bounces {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// The coefficient of restitution at each bounce.
    pub restitution: Term,
    /// How many bounces `h_n` and `t_n` speak of.
    #[serde(default)]
    pub count: Option<Term>,
}
