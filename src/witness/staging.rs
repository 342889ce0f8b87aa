//! The stages of a variant as worlds, for whoever wants to watch them.

use momentous_problem::Problem;
use momentous_problem::Variant;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::RecordedMotion;
use momentous_simulate::scene::Staged;
use momentous_simulate::scene::follow;
use momentous_simulate::scene::follow_least;
use momentous_simulate::scene::translate;

use super::TOLERANCES;
use super::case::Case;
use super::simulation::Witness;

/// The motions of a stage that is integrated in time as it is, counted from 0; or why there are none.
///
/// # Errors
/// There is nothing to watch: why.
pub fn followed(
    problem: &Problem,
    variant: &Variant,
    stage: usize,
    tolerance: f64,
) -> Result<Vec<RecordedMotion>, NothingToSimulate> {
    let scene = &problem.loaded().draft.scene;
    let case = Case { problem, scene, variant, replaced: Vec::new(), known: None };
    let witness = Witness::new(&case, TOLERANCES[0]);
    follow(scene, stage, &|name| witness.value(name), tolerance)
}

/// The motions of a stage, counted from 0, each by its formula where it has one, and else integrated; from its numbers times one
/// more share, which tells how what is rounded grows.
///
/// # Errors
/// There is nothing to watch: why.
pub fn followed_least(
    problem: &Problem,
    variant: &Variant,
    stage: usize,
    tolerance: f64,
    share: f64,
) -> Result<Vec<RecordedMotion>, NothingToSimulate> {
    let scene = &problem.loaded().draft.scene;
    let case = Case { problem, scene, variant, replaced: Vec::new(), known: None };
    let witness = Witness::new(&case, TOLERANCES[0]);
    // Names that follow each other go different ways.
    let sign = |name: &str| if name.bytes().fold(0, |sum, byte| sum ^ byte) % 2 == 0 { 1.0 } else { -1.0 };
    let value = |name: &str| witness.value(name).map(|value| value * (1.0 + share * sign(name)));
    follow_least(scene, stage, &value, tolerance)
}

/// The simulator of each stage, from what is stated of its start, or else from where the stage before ended; or why
/// there is none.
#[must_use]
pub fn staged(problem: &Problem, variant: &Variant) -> Vec<Result<Staged, NothingToSimulate>> {
    let scene = &problem.loaded().draft.scene;
    let case = Case { problem, scene, variant, replaced: Vec::new(), known: None };
    let witness = Witness::new(&case, TOLERANCES[0]);
    (0..scene.stages.len()).map(|stage| translate(scene, stage, &|name| witness.value(name))).collect()
}
