//! Sequential impulses, as game engines do it: contacts found at the start of a step, a few rounds of impulses, then the positions.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, closed, march, push_apart};

/// The method of game engines: ten rounds of impulses a step, whether they have settled or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SequentialImpulses {
    /// The step in s.
    pub step: f64,
}

impl<const D: usize> Method<D> for SequentialImpulses {
    fn name(&self) -> &'static str {
        "sequential impulses"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        let mut scheme = Scheme { contacts: world.contacts(), accelerations: Vec::new() };
        march(world, budget, self.step, &mut scheme)
    }
}

/// The rounds of impulses in a step, as engines have by default or near it.
const ROUNDS: usize = 10;

struct Scheme<const D: usize> {
    contacts: Vec<Contact>,
    accelerations: Vec<Vector<D>>,
}

impl<const D: usize> Step<D> for Scheme<D> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal> {
        world.accelerate(state, &mut self.accelerations);
        let group = closed(world, &self.contacts, state);
        let before: Vec<f64> = group.iter().map(|struck| struck.rate).collect();
        for body in 0..world.bodies.len() {
            state.velocities[body] += self.accelerations[body] * step;
        }
        let impacts = push_apart(world, &group, &before, ROUNDS, &mut state.velocities);
        for body in 0..world.bodies.len() {
            let velocity = state.velocities[body];
            state.positions[body] += velocity * step;
        }
        Ok(impacts)
    }
}
