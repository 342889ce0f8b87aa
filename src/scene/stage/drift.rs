//! Free motion at constant velocity.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// Nothing acts on the bodies along the axes: they go on evenly, for a time or until something holds.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drift {
    /// A name for the stage, used in brackets: `dt[back]`.
    #[serde(default)]
    pub name: Option<String>,
    /// How long.
    #[serde(default)]
    pub during: Option<Term>,
    /// Until when: an equation in the places of the bodies, without instants: `x_A = d`, `x_A = x_B`.
    #[serde(default)]
    pub until: Option<Term>,
}
