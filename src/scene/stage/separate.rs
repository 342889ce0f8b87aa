//! A body that comes apart: an explosion, a recoil, a jump, a shot.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Strength, Term};

/// A body comes apart, or bodies that moved together part: an explosion, a recoil, a jump, a shot, a spring that is let go.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Separate {
    /// A name for the stage, used in brackets: `J_A[jump]`.
    #[serde(default)]
    pub name: Option<String>,
    /// What it is called, without an article: `jump`, `shot`, `burst`. Default: `separation`.
    #[serde(default)]
    pub called: Option<String>,
    /// The short name of the whole before: a body of the scene, or a name of its own, whose mass is the sum of the parts.
    /// Default: the parts are bodies before, too, and have the same velocity.
    #[serde(default)]
    pub from: Option<String>,
    /// The parts, two or more; in one dimension with `energy`, in the order in which they lie along the axis.
    pub into: Vec<String>,
    /// The energy that becomes kinetic energy of the parts: `E`, `5 kJ`, `0.6*E_0`.
    #[serde(default)]
    pub energy: Option<Term>,
    /// The velocity of one part relative to another; a list for several parts that leave at once.
    #[serde(default)]
    pub relative: Option<Relatives>,
    /// The force with which two parts push each other apart along one axis, the second forwards: a term in the time `t`, pieces, or
    /// points of a graph. It acts for the `duration`, by default `dt`.
    #[serde(default)]
    pub force: Option<Strength>,
    /// How long it takes, if a force is given or wanted.
    #[serde(default)]
    pub duration: Option<Term>,
}

impl Separate {
    /// Whether it lasts: the force that drives the parts apart acts for a time, in which they move.
    #[must_use]
    pub fn lasts(&self) -> bool {
        self.force.is_some()
    }

    /// The relative velocities.
    #[must_use]
    pub fn relatives(&self) -> &[Relative] {
        match &self.relative {
            Some(Relatives::One(relative)) => std::slice::from_ref(relative),
            Some(Relatives::Several(all)) => all,
            None => &[],
        }
    }

    /// Whether there is a list of them.
    #[must_use]
    pub fn lists_relatives(&self) -> bool {
        matches!(self.relative, Some(Relatives::Several(_)))
    }
}

/// The velocities of parts relative to others.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Relatives {
    /// Of one part.
    One(Relative),
    /// Of several parts that leave at once.
    Several(Vec<Relative>),
}

/// The velocity of one part relative to another: that of the first minus that of the second.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Relative {
    /// The part that moves off: `the person`.
    pub of: String,
    /// The part to which its velocity is relative: `the boat`.
    pub to: String,
    /// The relative velocity along `direction`: a name, a value or an expression.
    pub velocity: Term,
    /// Where it points: `to the left`, `30 deg above +x`. Default: along the first axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// Whether it is relative to the velocity that the other part has `after` the separation, or had `before`. Default: after.
    #[serde(default)]
    pub when: When,
}

/// One of the two ends of a stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum When {
    /// At the start.
    Before,
    /// At the end.
    #[default]
    After,
}
