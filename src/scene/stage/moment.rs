//! A moment about a fixed point.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Strength;

use super::During;

/// A moment acts for a time on all bodies of a scene in a plane or in space, about a fixed point or the centre of mass.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Moment {
    /// A name for the stage, used in brackets: `work[spin]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The fixed point; `G` for the centre of mass.
    pub about: String,
    /// The moment: a term that may contain the time `t`, pieces or a graph; in space its components along the axes.
    pub value: Strength,
    /// How long it acts.
    pub during: During,
}
