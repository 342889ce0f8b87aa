//! Free flight of one body or several.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Resistance;

/// Bodies move freely: under their weight in a vertical plane, uniformly in a horizontal one. A body that a flight does not
/// name has a clock of its own, which stands still meanwhile.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flight {
    /// A name for the stage, used in brackets: `dt[rise]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The one body that flies.
    #[serde(default)]
    pub body: Option<String>,
    /// Several bodies that fly at the same time.
    #[serde(default)]
    pub bodies: Vec<String>,
    /// When it ends: `top`, or an equation in the places then, `y = 0 m`, `x = d`, `y_A = y_B`.
    #[serde(default)]
    pub until: Option<Term>,
    /// How long it lasts.
    #[serde(default)]
    pub during: Option<Term>,
    /// What resists the motion of the one body that flies, in proportion to the speed: `{ linear: b }`.
    #[serde(default)]
    pub resistance: Option<Resistance>,
    /// The slope along which the first axis runs, the second pointing away from it: `alpha` where the first axis points up or down
    /// the slope, else `alpha above +x`. Default: the axes are level and upright.
    #[serde(default)]
    pub incline: Option<Term>,
}

impl Flight {
    /// Whether nothing but weight acts.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.resistance.is_none()
    }

    /// The bodies that fly.
    pub fn flying(&self) -> impl Iterator<Item = &str> {
        self.body.iter().chain(&self.bodies).map(String::as_str)
    }
}
