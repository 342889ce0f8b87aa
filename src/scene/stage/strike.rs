//! A body that strikes an arm.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body strikes a light arm that turns about a fixed point and carries particles, or a body that turns about it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Strike {
    /// A name for the stage, used in brackets: `T_lost[hit]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that strikes the arm. Its velocity is that at right angles to the arm.
    pub body: String,
    /// How far from the fixed point it strikes.
    pub at: Term,
    /// The fixed point about which the arm turns.
    pub about: String,
    /// A body with a moment of inertia that turns about the point, in place of the light arm: a rod, a door, a roundabout.
    #[serde(default)]
    pub rotor: Option<String>,
    /// The particles on the arm, each with its distance from the fixed point: `{ A: L, B: L/2 }`.
    #[serde(default)]
    pub carries: BTreeMap<String, Term>,
    /// The coefficient of restitution.
    #[serde(default)]
    pub restitution: Option<Term>,
    /// Whether the body stays on the arm.
    #[serde(default)]
    pub plastic: bool,
}
