//! How much a run has to do, counted and not timed: what a method costs in a scene is its cost in the reference tasks times the
//! ratio of the two counts.

use crate::methods::{MethodKind, Setting};
use crate::trajectory::Trajectory;
use crate::world::World;

/// Everything that is looked at, once at the start and again in each step; an event is looked at alone.
#[must_use]
pub(super) fn work<const D: usize>(method: MethodKind, world: &World<D>, run: &Trajectory<D>) -> f64 {
    let scene = count(world.bodies.len() + world.reachable(world.contacts()).len());
    let each = match method.setting() {
        Setting::None => 1.0,
        Setting::Step | Setting::Tolerance => scene,
    };
    scene + each * count(run.steps)
}

#[allow(clippy::cast_precision_loss, reason = "counts of steps stay far below 2^53")]
fn count(number: usize) -> f64 {
    number as f64
}
