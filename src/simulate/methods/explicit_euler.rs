//! Explicit Euler: position and velocity move on by what held at the start of the step. Order 1, and energy grows on orbits.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, march, strike_once};

/// Euler's method, with Newton's law at contacts that are found closed after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExplicitEuler {
    /// The step in s.
    pub step: f64,
}

impl<const D: usize> Method<D> for ExplicitEuler {
    fn name(&self) -> &'static str {
        "explicit Euler"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        let mut scheme = Scheme { contacts: world.contacts(), accelerations: Vec::new() };
        march(world, budget, self.step, &mut scheme)
    }
}

struct Scheme<const D: usize> {
    contacts: Vec<Contact>,
    accelerations: Vec<Vector<D>>,
}

impl<const D: usize> Step<D> for Scheme<D> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal> {
        world.accelerate(state, &mut self.accelerations);
        for body in 0..world.bodies.len() {
            let velocity = state.velocities[body];
            state.positions[body] += velocity * step;
            state.velocities[body] += self.accelerations[body] * step;
        }
        state.time += step;
        Ok(strike_once(world, &self.contacts, state))
    }
}
