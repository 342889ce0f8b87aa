//! Springs, whose energy gets a name once somebody asks for it.

use momentous_expr::Expr;
use momentous_scene::Scene;
use momentous_scene::Stage;

use super::Name;

/// The spring as it stands in names: `V_spring1`.
const SPRING: &str = "spring";

/// A spring in a stage, with its deformation at both ends.
#[derive(Clone, Debug)]
pub(super) struct Stored {
    pub stage: usize,
    /// Its name in a sentence.
    pub called: String,
    pub stiffness: Expr,
    pub deformations: [Expr; 2],
}

/// Whether a name says the energy of a spring that the scene has.
pub(super) fn is_spring(scene: &Scene, name: &Name) -> bool {
    let is_sprung = |stage: &Stage| {
        matches!(stage, Stage::Spring(_)) || matches!(stage, Stage::Central(central) if central.spring.is_some())
    };
    name.subject == SPRING && !scene.bodies.contains_key(SPRING) && scene.stages.iter().any(is_sprung)
}
