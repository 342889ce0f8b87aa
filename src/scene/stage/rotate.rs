//! A particle on an arm about a fixed point.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::{Strength, Term};

use super::During;

/// A particle is held on a light arm or a string about a fixed point.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rotate {
    /// A name for the stage, used in brackets: `dt[spin]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The particle.
    pub body: String,
    /// The fixed point.
    pub about: String,
    /// Its distance from the point: one term, or the distances before and after: `[r_1, r_2]`.
    pub arm: Arm,
    /// The moment about the point: a term that may contain the time `t`, pieces or a graph. Default: none.
    #[serde(default)]
    pub moment: Option<Strength>,
    /// How long the moment acts.
    #[serde(default)]
    pub during: Option<During>,
}

/// The length of the arm.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Arm {
    /// Before and after.
    Changing([Term; 2]),
    /// The same throughout.
    Constant(Term),
}
