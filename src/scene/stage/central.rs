//! Motion under a central force.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A particle moves from one place to another under a force that always points to, or away from, a fixed point.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Central {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The particle.
    pub body: String,
    /// The fixed point.
    pub about: String,
    /// Gravity's parameter GM of what is at the point, where its gravity is the force.
    #[serde(default)]
    pub gravity: Option<Term>,
    /// The spring, or the elastic cord, that holds the particle to the point, where its force is the one that acts.
    #[serde(default)]
    pub spring: Option<CentralSpring>,
    /// The shape of the orbit, if its shape, its period or times are wanted.
    #[serde(default)]
    pub orbit: Option<Orbit>,
}

/// A light spring, or a light elastic cord, from a fixed point to a particle.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CentralSpring {
    /// Its stiffness.
    pub stiffness: Term,
    /// Its length where it is not stretched. Default: zero.
    #[serde(default)]
    pub unstretched: Option<Term>,
    /// Whether it is a cord, which goes slack where a spring would push: it has to be taut at both places.
    #[serde(default)]
    pub cord: bool,
    /// What it is called in a sentence: `the leash`. Default: `the spring`, or `the cord`.
    #[serde(default)]
    pub called: Option<String>,
}

impl CentralSpring {
    /// Its name in a sentence.
    #[must_use]
    pub fn called(&self) -> &str {
        self.called.as_deref().unwrap_or(if self.cord { "the cord" } else { "the spring" })
    }
}

/// The shape of an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Orbit {
    /// Closed: it comes back after a period. A circle told by rounded values is better said to be one: `circle`.
    Ellipse,
    /// Round: the distance and the speed stay the same.
    Circle,
    /// With just the speed to escape.
    Parabola,
}
