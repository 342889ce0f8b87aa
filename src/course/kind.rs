//! Kinds of problems: those that one page of own numbers, or one simulator, solves alike.

use std::mem::{Discriminant, discriminant};

use momentous_problem::Loaded;
use momentous_scene::Stage;

/// A kind of problems: by the simulator that shows the scene, or by what happens in it, stage by stage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kind {
    simulator: Option<&'static str>,
    axes: usize,
    stages: Vec<Discriminant<Stage>>,
}

impl Kind {
    /// The kind of a problem.
    #[must_use]
    pub fn of(problem: &Loaded) -> Self {
        let scene = &problem.draft.scene;
        let stages: Vec<&Stage> = scene.stages.iter().collect();
        let axes = scene.axes.rectangular().len();
        let simulator = match stages.as_slice() {
            [Stage::Impact(impact)] if impact.between.is_some() && axes == 1 => Some("collision"),
            [Stage::Impact(impact)] if impact.between.is_some() && impact.line_of_impact.is_some() => Some("discs"),
            [Stage::Bounces(bounces)] if bounces.incline.is_none() => Some("restitution"),
            [Stage::Fall(_), Stage::Impact(impact)] if impact.against.is_some() => Some("restitution"),
            [Stage::Fall(_), Stage::Bounces(bounces)] if bounces.incline.is_none() => Some("restitution"),
            _ => None,
        };
        Self { simulator, axes, stages: stages.into_iter().map(discriminant).collect() }
    }

    /// The simulator that shows the scene, by its name, where one does: an assignment with such a problem can be answered by looking.
    #[must_use]
    pub fn simulator(&self) -> Option<&'static str> {
        self.simulator
    }

    /// Every simulator that solves such a problem: two discs that meet head on are two carts on a line.
    #[must_use]
    pub fn simulators(&self) -> &'static [&'static str] {
        match self.simulator {
            Some("collision" | "discs") => &["collision", "discs"],
            Some("restitution") => &["restitution"],
            _ => &[],
        }
    }

    /// Whether who can solve a problem of the one kind with own numbers can solve one of the other.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        let same_scene = !self.simulators().is_empty() && self.simulators() == other.simulators();
        same_scene || (self.axes, &self.stages) == (other.axes, &other.stages)
    }
}
