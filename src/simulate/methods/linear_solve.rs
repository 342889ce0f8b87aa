//! The linear solve: the impact of bodies that touch, as one system of equations. No motion, no time.

use crate::budget::Budget;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::trajectory::{Ending, Trajectory};
use crate::world::World;

/// Solves the impact that happens at time 0 between bodies that touch; several at once where the laws determine them.
#[derive(Clone, Copy, Debug, Default)]
pub struct LinearSolve;

impl<const D: usize> Method<D> for LinearSolve {
    fn name(&self) -> &'static str {
        "linear solve"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        world.check()?;
        let mut state = world.start();
        let touching = world.touching(&world.contacts(), &state);
        let impacts = world.collide(&touching, &mut state.velocities)?;
        if impacts.is_empty() {
            return Err(Refusal::NothingTouches);
        }
        let mut run = Trajectory::begin(state);
        for impact in impacts {
            run.note(impact, budget);
        }
        run.steps = 1;
        run.evaluations = 1;
        run.ending = Ending::Impacts;
        Ok(run)
    }
}
