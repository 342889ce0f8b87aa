//! Symplectic Euler: first the velocity, then the position by the new velocity. Order 1, but the energy of an orbit stays.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, march, strike_once};

/// The semi-implicit method of Euler, with Newton's law at contacts that are found closed after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymplecticEuler {
    /// The step in s.
    pub step: f64,
}

impl<const D: usize> Method<D> for SymplecticEuler {
    fn name(&self) -> &'static str {
        "symplectic Euler"
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
            state.velocities[body] += self.accelerations[body] * step;
            let velocity = state.velocities[body];
            state.positions[body] += velocity * step;
        }
        state.time += step;
        Ok(strike_once(world, &self.contacts, state))
    }
}
