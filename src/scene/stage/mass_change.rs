//! Mass that joins a body while forces act on it, or leaves it, at a steady rate.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::BurningMass;

/// What falls onto a body all the time and stays there: sand, rain, coal.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gain {
    /// What it is called in a sentence: `the sand`.
    pub name: String,
    /// The mass that arrives per unit time, if times or forces are wanted.
    #[serde(default)]
    pub flow: Option<Term>,
    /// The whole mass that arrives in the stage, if that is given or wanted.
    #[serde(default)]
    pub mass: Option<Term>,
    /// The velocity with which it arrives, along the axis. Default: none, so that it falls straight down.
    #[serde(default)]
    pub velocity: Option<Term>,
}

/// What leaves a body all the time and is not thrown: sand that runs out through a hole, and has the velocity of the body as it leaves.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Loss {
    /// What it is called in a sentence: `the sand`.
    pub name: String,
    /// The mass that leaves per unit time, if times or forces are wanted.
    #[serde(default)]
    pub flow: Option<Term>,
    /// The whole mass that leaves in the stage, if that is given or wanted.
    #[serde(default)]
    pub mass: Option<Term>,
}

/// A change of mass as its stage tells it, of either kind.
#[derive(Clone, Copy, Debug)]
pub struct MassChange<'a> {
    /// Whether the body gains mass.
    pub gains: bool,
    /// The matter that joins or leaves.
    pub name: &'a str,
    /// The mass per unit time.
    pub flow: Option<&'a Term>,
    /// The whole mass.
    pub mass: Option<&'a Term>,
    /// The velocity with which it arrives, where it has any along the axis.
    pub velocity: Option<&'a Term>,
}

impl MassChange<'_> {
    /// The key that tells it in a problem file.
    #[must_use]
    pub fn key(&self) -> &'static str {
        if self.gains { "gains" } else { "loses" }
    }
}

/// How a stage changes the mass of a body.
#[derive(Clone, Copy, Debug)]
pub enum ChangeOfMass<'a> {
    /// Mass joins it or leaves it, which makes a name for the mass at the end.
    Steady,
    /// It burns fuel, and the burn tells its masses.
    Burn(&'a BurningMass),
}

/// The mass of a body at an instant, where a stage makes it.
#[derive(Clone, Copy, Debug)]
pub enum StageMass<'a> {
    /// It has the name of the body and this instant, from which on the body has it.
    Since(usize),
    /// A burn says it.
    Burn {
        /// The position of the burn among the stages.
        stage: usize,
        /// Whether it is the mass at its start (0) or at its end (1).
        side: usize,
        /// The rate or the mass in all.
        term: &'a Term,
    },
}
