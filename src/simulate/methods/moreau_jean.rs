//! Time stepping after Moreau and Jean: contacts are conditions on the velocity at the end of a step, found closed at its middle.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, closed, march, push_apart};

/// Time stepping with contact as complementarity: an impulse pushes, or the gap opens, never both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoreauJean {
    /// The step in s.
    pub step: f64,
}

impl<const D: usize> Method<D> for MoreauJean {
    fn name(&self) -> &'static str {
        "Moreau-Jean"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        let mut scheme = Scheme { contacts: world.contacts(), accelerations: Vec::new() };
        march(world, budget, self.step, &mut scheme)
    }
}

/// The rounds after which the iteration for the impulses gives up.
const ROUNDS: usize = 1000;

struct Scheme<const D: usize> {
    contacts: Vec<Contact>,
    accelerations: Vec<Vector<D>>,
}

impl<const D: usize> Step<D> for Scheme<D> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal> {
        for body in 0..world.bodies.len() {
            let velocity = state.velocities[body];
            state.positions[body] += velocity * (step / 2.0);
        }
        state.time += step / 2.0;
        world.accelerate(state, &mut self.accelerations);
        let group = closed(world, &self.contacts, state);
        let before: Vec<f64> = group.iter().map(|struck| struck.rate).collect();
        for body in 0..world.bodies.len() {
            state.velocities[body] += self.accelerations[body] * step;
        }
        let impacts = push_apart(world, &group, &before, ROUNDS, &mut state.velocities);
        for body in 0..world.bodies.len() {
            let velocity = state.velocities[body];
            state.positions[body] += velocity * (step / 2.0);
        }
        Ok(impacts)
    }
}
