//! Particles on an arm about a fixed point.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Strength, Term};

use super::During;

/// A particle is held on a light arm or a string about a fixed point, or several are on one arm.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rotate {
    /// A name for the stage, used in brackets: `dt[spin]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The particle, where there is one.
    #[serde(default)]
    pub body: Option<String>,
    /// Several particles on one arm that turns as a whole, each with its distance from the point: `{ A: L, B: [r_1, r_2] }`.
    #[serde(default)]
    pub bodies: BTreeMap<String, Arm>,
    /// A body with a moment of inertia that turns about the point and carries the particles: a roundabout, a disc, a rod.
    #[serde(default)]
    pub rotor: Option<String>,
    /// The fixed point.
    pub about: String,
    /// The distance of the one particle from the point: one term, or the distances before and after: `[r_1, r_2]`.
    #[serde(default)]
    pub arm: Option<Arm>,
    /// The moment about the point: a term that may contain the time `t`, pieces or a graph. Default: none.
    #[serde(default)]
    pub moment: Option<Strength>,
    /// Forces on the particles along their path, at right angles to the arm, which keeps its length.
    #[serde(default)]
    pub forces: Vec<AlongPath>,
    /// How long the moment and the forces act. Default: `dt`.
    #[serde(default)]
    pub during: Option<During>,
}

/// A force on a particle along its path.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AlongPath {
    /// How the force is called in a sentence: `the push of the child`. Default: "the force".
    #[serde(default)]
    pub name: Option<String>,
    /// The particle on which it acts, where there are several.
    #[serde(default)]
    pub on: Option<String>,
    /// Its strength, counted as the axis is: a term that may contain the time `t`, pieces or a graph.
    pub value: Strength,
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

impl Rotate {
    /// Whether what turns is an arm with one angular velocity, not one particle on a string.
    #[must_use]
    pub fn is_arm(&self) -> bool {
        self.rotor.is_some() || self.held().len() != 1
    }

    /// All that turns: the particles, and what carries them where that has a moment of inertia.
    #[must_use]
    pub fn turning(&self) -> Vec<&str> {
        self.held().into_iter().map(|(body, _)| body).chain(self.rotor.as_deref()).collect()
    }

    /// Whether something changes its angular momentum.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        self.moment.is_some() || !self.forces.is_empty()
    }

    /// The forces along the path, each with the particle on which it acts and the distance of that from the point; none of a
    /// force that says no particle of the stage.
    pub fn driving(&self) -> impl Iterator<Item = (&AlongPath, Option<(&str, &Arm)>)> {
        let held = self.held();
        self.forces.iter().map(move |force| {
            let on_arm = match (&force.on, &held[..]) {
                (None, [only]) => Some(*only),
                (None, _) => None,
                (Some(on), held) => held.iter().find(|(body, _)| body == on).copied(),
            };
            (force, on_arm)
        })
    }

    /// The bodies that are held, each with its distance from the point.
    #[must_use]
    pub fn held(&self) -> Vec<(&str, &Arm)> {
        let one = self.body.as_deref().zip(self.arm.as_ref());
        one.into_iter().chain(self.bodies.iter().map(|(body, arm)| (body.as_str(), arm))).collect()
    }
}

impl Arm {
    /// Whether it has one length throughout.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        matches!(self, Self::Constant(_))
    }

    /// The lengths before and after.
    #[must_use]
    pub fn ends(&self) -> [&Term; 2] {
        match self {
            Self::Constant(term) => [term, term],
            Self::Changing([before, after]) => [before, after],
        }
    }
}
