//! How forces accelerate the bodies of a world, and when they change their laws.

use super::force::{Force, Strength};
use super::state::{State, Vector};
use super::world::World;

impl<const D: usize> World<D> {
    /// The accelerations of all bodies in a state, in m/s².
    #[must_use]
    pub fn accelerations(&self, state: &State<D>) -> Vec<Vector<D>> {
        let mut all = Vec::new();
        self.accelerate(state, &mut all);
        all
    }

    /// The accelerations of all bodies in a state, written to a list that is used again.
    pub(super) fn accelerate(&self, state: &State<D>, all: &mut Vec<Vector<D>>) {
        all.clear();
        all.resize(self.bodies.len(), self.gravity);
        for force in &self.forces {
            let body = force.body();
            let mass = self.bodies[body].mass;
            all[body] += force.acceleration(mass, state.time, &state.positions[body], &state.velocities[body]);
        }
    }

    /// The times at which a force changes its law, in order.
    pub(super) fn breakpoints(&self) -> Vec<f64> {
        let mut times: Vec<f64> = Vec::new();
        for force in &self.forces {
            if let Force::Varying { strength: Strength::Pieces(pieces), .. } = force {
                times.extend(pieces.iter().map(|piece| piece.until).filter(|until| until.is_finite() && *until > 0.0));
            }
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}
