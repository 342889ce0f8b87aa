//! Bodies that act on each other only.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// Bodies act on each other, whatever the forces, for a while, and nothing acts on them from outside along the axes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interact {
    /// A name for the stage, used in brackets: `T_lost[tangle]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The bodies.
    pub between: Vec<String>,
    /// Whether all of them are at rest before, so that their centre of mass stays where it is.
    #[serde(default)]
    pub at_rest: bool,
    /// How long they act on each other, where they move at first and their displacements are wanted. With friction it is `dt` by default.
    #[serde(default)]
    pub during: Option<Term>,
    /// Whether no kinetic energy is lost.
    #[serde(default)]
    pub elastic: bool,
    /// The kinetic energy lost, if it is given.
    #[serde(default)]
    pub loss: Option<Term>,
    /// The coefficient of kinetic friction, where the first of two bodies lies on the second and slides on it.
    #[serde(default)]
    pub friction: Option<Term>,
    /// Which way the first body slides on the second: `to the left`. Default: along the axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// How far the first body slides on the second.
    #[serde(default)]
    pub distance: Option<Term>,
    /// `together` if it slides until both have the same velocity.
    #[serde(default)]
    pub until: Option<UntilTogether>,
}

/// What ends a slide of one body on another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum UntilTogether {
    /// Both move with the same velocity.
    Together,
}
