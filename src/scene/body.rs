//! Bodies, the surfaces that they strike, and the points about which moments are taken.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Components, Term};

/// Whether weight acts in the plane of the drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Plane {
    /// A level table, ice, a track: weight has no part in the motion.
    #[default]
    Horizontal,
    /// A drop, a throw, a wall seen from the side.
    Vertical,
}

/// A particle.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// How the body is called in a sentence: `cart A`, `the ball`.
    pub name: String,
    /// Its mass: a name from `given`, a value or an expression. Default: the name `m_` and the body's short name.
    #[serde(default)]
    pub mass: Option<Term>,
    /// Its moment of inertia about its axle, where it is no particle but the `rotor` of a stage: a roundabout, a disc, a rod. Write the
    /// formula if it has one: `m_R*R^2/2`.
    #[serde(default)]
    pub inertia: Option<Term>,
    /// What lets it move along one direction only: the rails under a wedge, the floor under a gun, the cord of a sphere.
    #[serde(default)]
    pub guide: Option<Guide>,
}

/// A smooth guide: it gives a body whatever impulse is needed at right angles to it, and none along it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Guide {
    /// The direction along which the body can move: `x`, `30 deg above +x`.
    pub along: Term,
    /// What guides it, as it is called in a sentence: `the rails`. Default: `the ground`.
    #[serde(default)]
    pub by: Option<String>,
}

/// A smooth surface of a body too heavy to be moved.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Surface {
    /// How the surface is called in a sentence. Default: "the" and its short name.
    #[serde(default)]
    pub name: Option<String>,
    /// Where its outward normal points, away from the surface: `up`, `to the left`, `120 deg above +x`.
    pub normal: Term,
    /// Its velocity along its normal, where it moves: a name, a value or an expression. Default: at rest.
    #[serde(default)]
    pub velocity: Option<Term>,
}

impl Point {
    /// The vertical line through the point, which the author may have called an axis.
    #[must_use]
    pub fn vertical(&self) -> String {
        if self.name.contains("axis") { self.name.clone() } else { format!("the vertical axis through {}", self.name) }
    }
}

/// A fixed point.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// How the point is called in a sentence: `the pivot`.
    pub name: String,
    /// Where it is, by its coordinates along the axes: `{ x: 2 m, y: b }`; those left out are zero. Default: the origin.
    #[serde(default)]
    pub at: Components,
}
