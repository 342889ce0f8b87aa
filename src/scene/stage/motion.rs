//! A motion that is known as a function of time or of place.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Axis, Components, Term};

use super::During;

/// A body moves as a function says: its velocity or its place as a function of the time `t`, or along one axis its velocity as a
/// function of its place. What acts on it follows.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// A name for the stage, used in brackets: `J_A[start]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// How long: a duration, or the start and the end on the body's own clock (`[t_1, t_2]`). Default: `dt`.
    #[serde(default)]
    pub during: Option<During>,
    /// The velocity: `b*t - c*t^2`; with several axes `{ x: b*t, y: v_0 }`; along one axis perhaps a term in the place `x`: `k*x`.
    #[serde(default)]
    pub velocity: Option<Course>,
    /// The place as a function of the time `t`, instead of the velocity.
    #[serde(default)]
    pub position: Option<Course>,
}

/// A quantity as it changes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Course {
    /// Along each axis.
    Components(Components),
    /// Along the only axis.
    Only(Term),
}

impl Course {
    /// The term along an axis, in a scene with that many.
    #[must_use]
    pub fn along(&self, axis: Axis, axes: usize) -> Option<&Term> {
        match self {
            Self::Only(term) => (axes == 1).then_some(term),
            Self::Components(components) => components.get(axis),
        }
    }
}
