//! The contents of a scene: bodies, axes, surfaces, points and a timeline of stages. Data only; no law is known here.

mod agreement;
mod axes;
mod body;
mod components;
mod force;
mod instant;
mod pulley;
pub mod stage;
mod term;
mod wording;

pub use agreement::is_plural;
pub use axes::{Axes, Axis, Sense, Senses};
pub use body::{Body, Guide, Plane, Point, Surface};
pub use components::Components;
pub use force::{Force, Friction, Graph, Piece, Pull, Strength};
pub use instant::Instant;
pub use stage::Stage;
pub use term::Term;
pub use wording::list;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use stage::ChangeOfMass;
use stage::StageMass;

/// The bodies, the axes and the timeline of a problem.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// The axes, each with the direction in which it points: `{ x: to the right }`, `{ x: east, y: north }`; or `polar`.
    pub axes: Axes,
    /// Whether the drawing's plane is `horizontal` (weight does not act in it) or `vertical` (it does). Default: horizontal.
    #[serde(default)]
    pub plane: Plane,
    /// The bodies, each under a short name that ends in a letter: `A`, `ball`.
    pub bodies: BTreeMap<String, Body>,
    /// Fixed or moving smooth surfaces that bodies strike: `floor: { normal: up }`.
    #[serde(default)]
    pub surfaces: BTreeMap<String, Surface>,
    /// Fixed points about which moments are taken: `O: { name: the pivot }`.
    #[serde(default)]
    pub points: BTreeMap<String, Point>,
    /// What happens, in order. Instants 1, 2, 3, ... lie before, between and after the stages. None: a single instant.
    #[serde(default)]
    pub stages: Vec<Stage>,
    /// The instants by name, in order: `[before, after]` lets `v_A@after` be written; with words that say when they are,
    /// `[before, top: at the top]`.
    #[serde(default)]
    pub instants: Vec<Instant>,
}

impl Scene {
    /// Tells what the author left out because it follows from the rest: the mass with which a body begins to burn.
    pub fn tell_defaults(&mut self) {
        for stage in &mut self.stages {
            if let Stage::Thrust(thrust) = stage {
                let mass = self.bodies.get(&thrust.body).and_then(|body| body.mass.clone());
                thrust.mass.tell(|| mass.unwrap_or_else(|| Term(format!("m_{}", thrust.body))));
            }
        }
    }

    /// The bodies with a moment of inertia.
    pub fn rotors(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().filter(|(_, body)| body.inertia.is_some()).map(|(name, _)| name.as_str())
    }

    /// The parts of a body that is not declared because a stage makes it, or divides it; empty for any other body.
    #[must_use]
    pub fn parts_of(&self, whole: &str) -> Vec<&str> {
        if self.bodies.contains_key(whole) {
            return Vec::new();
        }
        let parts = self.stages.iter().filter_map(Stage::whole_and_parts).find(|(other, _)| *other == whole);
        parts.into_iter().flat_map(|(_, parts)| parts).map(String::as_str).filter(|part| *part != whole).collect()
    }

    /// The parts into which a body comes apart, whether it is declared or not; empty where it does not.
    #[must_use]
    pub fn division_of(&self, whole: &str) -> Vec<&str> {
        let separations = self.stages.iter().filter(|stage| matches!(stage, Stage::Separate(_)));
        let mut divisions = separations.filter_map(Stage::whole_and_parts);
        let parts = divisions.find(|(other, _)| *other == whole);
        parts.into_iter().flat_map(|(_, parts)| parts).map(String::as_str).collect()
    }

    /// Whether the stage before pushes the body. A force may jump between the two: that at the instant between them is the one at
    /// the end of the push.
    #[must_use]
    pub fn follows_a_push(&self, index: usize, body: &str) -> bool {
        let before = self.stage_before(index);
        matches!(before, Some(Stage::Push(push)) if push.pushed().any(|pushed| pushed == body))
            || matches!(before, Some(Stage::Thrust(burn)) if burn.body == body && burn.is_free())
    }

    /// Whether the stage before says the force on the body at the instant between the two.
    #[must_use]
    pub fn follows_a_force(&self, index: usize, body: &str) -> bool {
        self.follows_a_push(index, body)
            || matches!(self.stage_before(index), Some(Stage::Motion(motion)) if motion.body == body)
    }

    /// The instant since which a body has the mass that a stage has made of its own, as it has it at `instant`; none where it has kept
    /// the mass that it began with, or a term says it.
    #[must_use]
    pub fn mass_since(&self, body: &str, instant: usize) -> Option<usize> {
        match self.stage_mass(body, instant)? {
            StageMass::Since(since) => Some(since),
            StageMass::Burn { .. } => None,
        }
    }

    /// The term that says the mass of a body at an instant; none where a name does.
    #[must_use]
    pub fn mass_term(&self, body: &str, instant: usize) -> Option<&Term> {
        match self.stage_mass(body, instant) {
            Some(StageMass::Since(_)) => None,
            Some(StageMass::Burn { term, .. }) => Some(term),
            None => self.bodies.get(body)?.mass.as_ref(),
        }
    }

    /// The mass of a body at an instant as a stage states it: the last that changed it; or, of a body without a mass of
    /// its own, the first that will, if it is a burn.
    #[must_use]
    pub fn stage_mass(&self, body: &str, instant: usize) -> Option<StageMass<'_>> {
        let past = instant.checked_sub(1)?.min(self.stages.len());
        let change = |index: usize| Some((index, self.stages.get(index)?.change_of_mass(body)?));
        if let Some((stage, change)) = (0..past).rev().find_map(change) {
            let end = match change {
                ChangeOfMass::Steady => None,
                ChangeOfMass::Burn(mass) => mass.at_end(),
            };
            return Some(end.map_or(StageMass::Since(stage + 2), |term| StageMass::Burn { stage, side: 1, term }));
        }
        self.bodies.get(body).filter(|body| body.mass.is_none())?;
        match (past..self.stages.len()).find_map(change)? {
            (stage, ChangeOfMass::Burn(mass)) => Some(StageMass::Burn { stage, side: 0, term: mass.at_start() }),
            (_, ChangeOfMass::Steady) => None,
        }
    }

    fn stage_before(&self, index: usize) -> Option<&Stage> {
        self.stages.get(index.checked_sub(1)?)
    }

    /// The declared bodies that a body consists of; of a declared body, itself.
    #[must_use]
    pub fn members<'a>(&'a self, body: &'a str) -> Vec<&'a str> {
        let parts = self.parts_of(body);
        if parts.is_empty() { vec![body] } else { parts.into_iter().flat_map(|part| self.members(part)).collect() }
    }

    /// The words for the two directions across the guide of a body, the positive one a quarter of a turn counter-clockwise from it; none
    /// where neither axis runs along the guide.
    #[must_use]
    pub fn across_guide(&self, body: &str) -> Option<Senses> {
        let guide = self.members(body).into_iter().find_map(|member| self.bodies.get(member)?.guide.as_ref())?;
        let (along, sign) = self.axes.pointed(&guide.along.0)?;
        let (other, senses) = self.axes.rectangular().into_iter().find(|(axis, _)| *axis != along)?;
        let turned = if other > along { sign } else { -sign };
        Some(if turned > 0 { senses } else { Senses { positive: senses.negative, negative: senses.positive } })
    }

    /// How a body is called in a sentence: `the boat`, `Ana, Ben and the boat together`.
    #[must_use]
    pub fn called(&self, body: &str) -> String {
        let names: Vec<&str> = self
            .members(body)
            .into_iter()
            .map(|member| self.bodies.get(member).map_or(member, |entry| &entry.name))
            .collect();
        if names.len() > 1 { format!("{} together", list(&names)) } else { names.concat() }
    }

    /// How a point is called in a sentence: `the pivot`.
    #[must_use]
    pub fn point<'s>(&'s self, point: &'s str) -> &'s str {
        self.points.get(point).map_or(point, |entry| &entry.name)
    }

    /// A body as it does something, the verb for one body and for several: `the boat moves`, `the arrow and the target
    /// together move`.
    #[must_use]
    pub fn does(&self, body: &str, verb: [&str; 2]) -> String {
        let called = self.called(body);
        let several = self.members(body).len() > 1 || is_plural(&called);
        format!("{called} {}", verb[usize::from(several)])
    }
}
