//! Bodies that act on each other only.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::Term;

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
    /// How long they act on each other, where they move at first and their displacements are wanted.
    #[serde(default)]
    pub during: Option<Term>,
    /// Whether no kinetic energy is lost.
    #[serde(default)]
    pub elastic: bool,
    /// The kinetic energy lost, if it is given.
    #[serde(default)]
    pub loss: Option<Term>,
}
