//! A body inside a cone or a bowl.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::UpOrDown;

/// A body slides from one level to another inside a smooth surface of revolution whose axis is vertical. The axes are polar.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bowl {
    /// A name for the stage, used in brackets: `h_A[in]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// A point on the axis.
    pub about: String,
    /// Whether the body goes `up` or `down` from the first level to the second.
    pub way: UpOrDown,
    /// The height between the two levels. Default: `h_` and the body's short name.
    #[serde(default)]
    pub height: Option<Term>,
    /// The angle between the axis and the wall, where the surface is a cone that opens upwards.
    #[serde(default)]
    pub cone: Option<Term>,
    /// The radius of the sphere, where the surface is the lower half of one.
    #[serde(default)]
    pub sphere: Option<Term>,
    /// At which end the body moves horizontally: where it is launched so, or at its highest or lowest level.
    #[serde(default)]
    pub horizontal: Option<Horizontal>,
}

/// The ends of a stage at which a body moves horizontally.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Horizontal {
    /// At the start.
    Start,
    /// At the end.
    End,
    /// At both.
    Both,
}

impl Bowl {
    /// Whether the body moves horizontally at the start (0) or at the end (1).
    #[must_use]
    pub fn is_horizontal(&self, side: usize) -> bool {
        match self.horizontal {
            Some(Horizontal::Both) => true,
            Some(Horizontal::Start) => side == 0,
            Some(Horizontal::End) => side == 1,
            None => false,
        }
    }
}
