//! Newton's second law for particles under forces and a constraint, all of them together.

use super::component::Frame;
use super::integrate::End;
use super::particles::{Constraint, Force, Particle, SharedLines, Strength, place, velocity};
use super::recorded_motion::{Look, SeenBody};
use super::vector::{Vector, ZERO, add, dot, size, times};

/// Particles, and all that acts on them. A state holds place and velocity of each particle, and behind them the impulses of the
/// first forces, as many as it has room for: its length `N` is six for each particle, and one for each impulse.
pub(super) struct System<'a, const N: usize> {
    pub frame: Frame,
    pub particles: Vec<Particle<'a>>,
    pub forces: Vec<Force>,
    pub constraint: Option<Constraint>,
    /// When the motion starts.
    pub start: f64,
    /// Times at which a force changes its law.
    pub changes: Vec<f64>,
    /// The energy that was lost before.
    pub lost: f64,
}

impl<'a, const N: usize> System<'a, N> {
    /// Particles on which nothing acts.
    pub(super) fn new(frame: Frame, particles: Vec<Particle<'a>>) -> Self {
        Self { frame, particles, forces: Vec::new(), constraint: None, start: 0.0, changes: Vec::new(), lost: 0.0 }
    }

    /// Starts again where it ended.
    pub(super) fn go_on_from(&mut self, end: &End<N>) {
        self.start = end.time;
        for (index, particle) in self.particles.iter_mut().enumerate() {
            (particle.place, particle.velocity) = (place(&end.state, index), velocity(&end.state, index));
        }
    }

    /// The state at the start.
    pub(super) fn state(&self) -> [f64; N] {
        let mut state = [0.0; N];
        for (part, particle) in state.chunks_exact_mut(6).zip(&self.particles) {
            part[..3].copy_from_slice(&particle.place);
            part[3..].copy_from_slice(&particle.velocity);
        }
        state
    }

    /// How the state changes.
    pub(super) fn slope(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        let mut slope = self.free(time, state);
        if let Some((lines, pull)) = self.pull(state, &slope) {
            self.push(&mut slope, &lines, pull);
        }
        slope
    }

    /// How velocities change by weight alone.
    pub(super) fn falling(&self) -> [f64; N] {
        let mut slope = [0.0; N];
        for (part, particle) in slope.chunks_exact_mut(6).zip(&self.particles) {
            part[3..].copy_from_slice(&particle.let_through(particle.falls));
        }
        self.held(slope)
    }

    /// How velocities change by a unit of a force alone.
    pub(super) fn answer(&self, force: usize) -> [f64; N] {
        let mut slope = [0.0; N];
        self.push(&mut slope, &self.forces[force].on, 1.0);
        self.held(slope)
    }

    /// What a constraint of particles at rest makes of accelerations.
    fn held(&self, mut slope: [f64; N]) -> [f64; N] {
        if let Some((lines, pull)) = self.pull(&[0.0; N], &slope) {
            self.push(&mut slope, &lines, pull);
        }
        slope
    }

    /// How strong the forces are together, whatever their directions, at the strongest of a few moments between two times: what they come
    /// to is a difference of such sizes.
    pub(super) fn strongest(&self, [start, end]: [f64; 2]) -> f64 {
        let state = self.state();
        let together = |time: f64| -> f64 {
            let lines = |force: &Force| force.on.iter().map(|(_, along)| size(*along)).sum::<f64>();
            self.forces.iter().map(|force| force.strength(time, &state).abs() * lines(force)).sum()
        };
        [0.0, 0.3, 0.5, 1.0].into_iter().map(|share| together(start + share * (end - start))).fold(0.0, f64::max)
    }

    /// How strongly the constraint acts along its lines: the tension of a cord that pulls along unit vectors.
    pub(super) fn tension(&self, time: f64, state: &[f64; N]) -> f64 {
        self.pull(state, &self.free(time, state)).map_or(0.0, |(_, pull)| pull)
    }

    /// How the state would change without the constraint.
    fn free(&self, time: f64, state: &[f64; N]) -> [f64; N] {
        let mut slope = [0.0; N];
        for (index, (part, particle)) in slope.chunks_exact_mut(6).zip(&self.particles).enumerate() {
            part[..3].copy_from_slice(&velocity(state, index));
            part[3..].copy_from_slice(&particle.let_through(particle.falls));
        }
        for (place_of_force, force) in self.forces.iter().enumerate() {
            let strength = force.strength(time, state);
            self.push(&mut slope, &force.on, strength);
            if let Some(impulse) = slope.get_mut(6 * self.particles.len() + place_of_force) {
                *impulse = strength;
            }
        }
        slope
    }

    /// Adds the accelerations by a force.
    fn push(&self, slope: &mut [f64; N], on: &[(usize, Vector)], strength: f64) {
        for (index, along) in on {
            let (gained, _) = self.particles[*index].yields(times(strength, *along));
            let changed = add(velocity(slope, *index), gained);
            slope[6 * index + 3..6 * index + 6].copy_from_slice(&changed);
        }
    }

    /// The lines of the constraint, and how strongly it acts along them so that the particles stay where it holds them.
    fn pull(&self, state: &[f64; N], free: &[f64; N]) -> Option<(SharedLines<'_>, f64)> {
        let (lines, mut missing) = self.constraint.as_ref()?.lines(state);
        let mut gained = 0.0;
        for (index, along) in lines.iter() {
            missing -= dot(*along, velocity(free, *index));
            gained += dot(*along, self.particles[*index].yields(*along).0);
        }
        Some((lines, missing / gained))
    }

    /// The look of the system at a time.
    pub(super) fn look(&self, time: f64, state: &[f64; N]) -> Look {
        let now = |(index, particle): (usize, &Particle<'a>)| {
            (Particle { place: place(state, index), velocity: velocity(state, index), ..*particle }, ZERO, 0.0)
        };
        let mut look = self.frame.look(self.particles.iter().enumerate().map(now));
        let mut outside = ZERO;
        for force in &self.forces {
            let strength = force.strength(time, state);
            outside = add(outside, self.unbalanced(&force.on, strength));
            match (&force.strength, force.deformation(state)) {
                (Strength::Spring { stiffness, .. }, Some(deformation)) => {
                    look.potential += stiffness * deformation * deformation / 2.0;
                    // What a spring takes from an end that nothing moves.
                    look.power -= strength * self.grows(&force.on, state, false);
                }
                _ => look.power += strength * self.grows(&force.on, state, true),
            }
        }
        if let Some((lines, pull)) = self.pull(state, &self.free(time, state)) {
            outside = add(outside, self.unbalanced(&lines, pull));
            // What keeps its length or its shape does no work.
            if matches!(&self.constraint, Some(Constraint::Surface(surface)) if surface.changes != 0.0) {
                look.power += pull * self.grows(&lines, state, true);
            }
        }
        for (sum, part) in look.outside.iter_mut().zip(self.frame.split(outside)) {
            *sum += part;
        }
        Look { lost: self.lost, ..look }
    }

    /// The force on all particles together: nothing where it acts between them, but for what guides take up.
    fn unbalanced(&self, on: &[(usize, Vector)], strength: f64) -> Vector {
        let movable = on.iter().filter(|(index, _)| self.particles[*index].mass.is_some());
        movable.fold(ZERO, |all, (index, along)| add(all, self.particles[*index].let_through(times(strength, *along))))
    }

    /// How fast that gets longer which lies along lines, by the motion of what can be moved or of what cannot.
    fn grows(&self, on: &[(usize, Vector)], state: &[f64; N], movable: bool) -> f64 {
        let acting = on.iter().filter(|(index, _)| self.particles[*index].mass.is_some() == movable);
        acting.map(|(index, along)| dot(*along, velocity(state, *index))).sum()
    }
}

impl Frame {
    /// The look of particles, each with the force from outside on it besides its weight, and the power of all but its weight.
    pub(super) fn look<'a>(&self, all: impl Iterator<Item = (Particle<'a>, Vector, f64)>) -> Look {
        let (mut outside, mut look) = (ZERO, Look::default());
        for (moving, force, power) in all {
            let Some(mass) = moving.mass else { continue };
            outside = add(outside, add(force, times(mass, moving.let_through(moving.falls))));
            look.potential -= mass * dot(moving.falls, moving.place);
            look.power += power;
            look.bodies.push(SeenBody { mass, place: self.split(moving.place), velocity: self.split(moving.velocity) });
        }
        look.outside = self.split(outside);
        look
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::particles::Surface;

    /// At rest on a cone of 45°, half of the weight is felt along the wall: the acceleration is that of a slope.
    #[test]
    fn a_cone_is_a_slope_for_what_does_not_turn() {
        let rests = Particle { place: [1.0, 0.0, 1.0], falls: [0.0, 0.0, -10.0], ..Particle::free("A", 2.0, ZERO) };
        let cone = Some(Constraint::Surface(Surface::cone(1.0)));
        let system = System::<6> { constraint: cone, ..System::new(Frame::upright_space(), vec![rests]) };
        let slope = system.slope(0.0, &system.state());
        assert!(
            (slope[3] + 5.0).abs() < 1e-12 && (slope[5] + 5.0).abs() < 1e-12 && slope[..3] == [0.0; 3],
            "{slope:?}"
        );
    }

    /// 1 kg and 3 kg on one string, the heavier hanging: both with 7.5 m/s², a tension of 7.5 N, and what falls gains energy.
    #[test]
    fn a_cord_pulls_both_ends_alike() {
        let ahead = [1.0, 0.0, 0.0];
        let hangs = Particle { falls: [10.0, 0.0, 0.0], ..Particle::free("B", 3.0, ahead) };
        let mut system = System::<12>::new(Frame::line("s"), vec![Particle::free("A", 1.0, ahead), hangs]);
        system.constraint = Some(Constraint::Length(vec![(0, ahead), (1, times(-1.0, ahead))]));
        let (slope, look) = (system.slope(0.0, &system.state()), system.look(0.0, &system.state()));
        assert!((slope[3] - 7.5).abs() < 1e-12 && (slope[9] - 7.5).abs() < 1e-12, "{slope:?}");
        assert!((system.tension(0.0, &system.state()) - 7.5).abs() < 1e-12);
        assert!((look.outside[0] - 30.0).abs() < 1e-12 && look.power.abs() < 1e-12, "the tension is from inside");
    }
}
