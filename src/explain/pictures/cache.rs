//! The parts that the figures of all variants share which go the same way: where directions point, and the plans of the diagrams.

use std::sync::OnceLock;

use momentous_scene::Scene;

use super::compass::Compass;
use super::diagram_plan::Plan;

/// The shared parts, each worked out when it is first needed.
#[derive(Default)]
pub(crate) struct PictureCache {
    compass: OnceLock<Compass>,
    /// One for each stage.
    diagrams: Vec<OnceLock<Plan>>,
}

impl PictureCache {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self { compass: OnceLock::new(), diagrams: scene.stages.iter().map(|_| OnceLock::new()).collect() }
    }

    /// The directions of the scene on drawings.
    pub(super) fn compass(&self, scene: &Scene) -> &Compass {
        self.compass.get_or_init(|| Compass::of(scene))
    }

    /// The plan of the diagram of momenta and impulses of a stage.
    pub(super) fn diagram(&self, stage: usize, plan: impl FnOnce() -> Plan) -> Option<&Plan> {
        self.diagrams.get(stage).map(|kept| kept.get_or_init(plan))
    }
}
