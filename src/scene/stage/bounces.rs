//! Repeated bounces on a floor.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body bounces on a smooth floor, again and again. Where a fall came before, the body was dropped from rest; otherwise it arrives
/// with the velocity that it then has.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bounces {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// The coefficient of restitution at each bounce.
    pub restitution: Term,
    /// How many bounces `h_n`, `v_n`, `t_n`, `dt_n`, `path_n`, `x_n` and `range_n` refer to.
    #[serde(default)]
    pub count: Option<Term>,
    /// The slope of the floor, where the first axis runs along it and the second away from it: `alpha` where the first axis points up
    /// or down the slope, else `alpha above +x`. Default: a level floor.
    #[serde(default)]
    pub incline: Option<Term>,
}

impl Bounces {
    /// The surface on which the body bounces, in a sentence.
    #[must_use]
    pub fn surface(&self) -> &'static str {
        if self.incline.is_some() { "the slope" } else { "the floor" }
    }
}
