//! What a body moves through resists it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// Air or a liquid resists the motion of a body: `{ linear: b }`, or along a line `{ quadratic: k }`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Resistance {
    /// In proportion to the speed: the resistance divided by the speed.
    Linear(Term),
    /// In proportion to the square of the speed: the resistance divided by the square of the speed.
    Quadratic(Term),
}
