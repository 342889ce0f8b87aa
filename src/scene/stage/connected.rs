//! Two bodies on a taut string over a pulley.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Until;

/// Two bodies on the ends of a taut, light string over a smooth, light pulley. Velocities are counted along the string, from the
/// trailing body to the leading one.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Connected {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that is drawn along: it rises if it hangs.
    pub trailing: Strand,
    /// The body that goes ahead: it sinks if it hangs.
    pub leading: Strand,
    /// How the pulley is called in a sentence. Default: the pulley.
    #[serde(default)]
    pub over: Option<String>,
    /// How long. Default: `dt`.
    #[serde(default)]
    pub duration: Option<Term>,
    /// How far each of them moves.
    #[serde(default)]
    pub distance: Option<Term>,
    /// `rest` if they move until they are at rest.
    #[serde(default)]
    pub until: Option<Until>,
}

/// The most strands on which a body may hang.
pub const MOST_STRANDS: u8 = 6;

/// One end of the string.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Strand {
    /// The body.
    pub body: String,
    /// `hanging`, `level`, or the angle of the slope on which it lies. Default: hanging.
    #[serde(default)]
    pub on: Option<Term>,
    /// On how many strands of the string a body hangs, by a light movable pulley or a block and tackle: it is drawn with as many
    /// tensions, and moves by that fraction of what the string runs. Default: 1.
    #[serde(default)]
    pub strands: Option<u8>,
    /// The coefficient of kinetic friction on its floor or slope. Default: smooth.
    #[serde(default)]
    pub friction: Option<Term>,
}

impl Strand {
    /// On how many strands the body hangs.
    #[must_use]
    pub fn strands(&self) -> u8 {
        self.strands.unwrap_or(1)
    }

    /// Whether the body hangs.
    #[must_use]
    pub fn hangs(&self) -> bool {
        self.on.as_ref().is_none_or(|term| term.0.trim() == "hanging")
    }
}
