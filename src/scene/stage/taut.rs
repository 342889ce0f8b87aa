//! A string that goes taut.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A slack, light, inextensible string between two bodies goes taut with a jerk.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Taut {
    /// A name for the stage, used in brackets: `J_A[jerk]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The two bodies, the second ahead of the first along the string.
    pub between: [String; 2],
    /// The smooth, light pulley over which the string runs, as it is called in a sentence. Velocities of both bodies are then
    /// counted along the string, from the first body to the second.
    #[serde(default)]
    pub over: Option<String>,
    /// In two dimensions, the direction of the string, from the first body to the second: `30 deg above +x`.
    #[serde(default)]
    pub along: Option<Term>,
    /// How long the jerk lasts, if the average tension is wanted.
    #[serde(default)]
    pub duration: Option<Term>,
}
