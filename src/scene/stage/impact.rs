//! An impact: of two bodies, or of a body and a surface.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Included;

/// An impact. Contacts are smooth: the impulse acts along the line of impact, unless the bodies stick.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Impact {
    /// A name for the stage, used in brackets: `J_A[hit]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The two bodies; the line of impact points from the first to the second, so the second lies ahead of the first.
    #[serde(default)]
    pub between: Option<[String; 2]>,
    /// The one body that strikes a surface (with `against`).
    #[serde(default)]
    pub body: Option<String>,
    /// The surface that is struck.
    #[serde(default)]
    pub against: Option<String>,
    /// The coefficient of restitution: a name, a value or an expression.
    #[serde(default)]
    pub restitution: Option<Term>,
    /// Whether no kinetic energy is lost: e = 1 along a line of impact, and a balance of energy where no line is known.
    #[serde(default)]
    pub elastic: bool,
    /// The kinetic energy lost, where it is given instead of e: `40 J`, `T_A1/2`.
    #[serde(default)]
    pub loss: Option<Term>,
    /// Whether the bodies stay together.
    #[serde(default)]
    pub plastic: bool,
    /// The short name of the body that the two become where they stay together: `C`.
    #[serde(default)]
    pub becomes: Option<String>,
    /// In two dimensions, the direction of the line of impact, from the first body to the second: `30 deg above +x`.
    #[serde(default)]
    pub line_of_impact: Option<Term>,
    /// How long the contact lasts, if the average force is wanted.
    #[serde(default)]
    pub duration: Option<Term>,
    /// What the balance includes although a short contact usually leaves it out: `[weight]`. It needs the `duration`.
    #[serde(default)]
    pub include: Vec<Included>,
}

/// The parties of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partners<'a> {
    /// Two bodies.
    Bodies(&'a str, &'a str),
    /// A body and a surface.
    Surface(&'a str, &'a str),
}

impl Impact {
    /// The parties of the impact; `None` where the keys contradict each other or are missing.
    #[must_use]
    pub fn partners(&self) -> Option<Partners<'_>> {
        match (&self.between, &self.body, &self.against) {
            (Some([first, second]), None, None) => Some(Partners::Bodies(first, second)),
            (None, Some(body), Some(surface)) => Some(Partners::Surface(body, surface)),
            _ => None,
        }
    }
}
