//! A spring that a body runs into or is pushed away by, or a spring between two bodies.

use momentous_scene::Axis;
use momentous_scene::stage::{Ends, Spring};

use crate::scene::course::{Goal, Until};
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{dot, less, size, times, unit};

impl StageRun<'_> {
    pub(super) fn spring(&mut self, stage: &Spring) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let along = unit(axis);
        let stiffness = self.values.term(&stage.stiffness)?;
        let from = self.deformed(stage, stiffness)?;
        let to = self.values.known(stage.to.as_ref());
        let rises = self.rises_from_rest(stage, axis)?;
        let sense = if rises || stage.releases() || to.is_some_and(|to| to < from) { -1.0 } else { 1.0 };
        match stage.ends().ok_or(NothingToSimulate::NoStage)? {
            Ends::Fixed(body) => {
                let mass = self.values.mass(body)?;
                let way = times(self.values.sense(stage.direction.as_ref(), axis)?, along);
                let slope = self.values.slope(stage.incline.as_ref())?;
                let friction = self.values.or_zero(stage.friction.as_ref())?;
                let level = friction == 0.0 && stage.incline.is_none();
                let gravity = if level { 0.0 } else { self.values.named("g")? };
                let falls = times(self.values.gravity(axis)? + slope.along * gravity, along);
                let moves = times(self.values.velocity_before(body, axis)?, along);
                let mut system = System::<6>::new(
                    self.values.frame(),
                    vec![Particle { falls, ..Particle::free(body, mass, moves) }],
                );
                system.forces.push(Force::spring(vec![(0, times(sense, way))], stiffness, from));
                system.forces.push(Force::steady(0, times(-mass * friction * slope.across * gravity, way)));
                self.run_spring(stage, &system, sense, &|state| sense * dot(way, velocity(state, 0)))
            }
            Ends::Free(first, second) => {
                let mut particles = Vec::new();
                for body in [first, second] {
                    let moves = times(self.values.velocity_before(body, axis)?, along);
                    particles.push(Particle::free(body, self.values.mass(body)?, moves));
                }
                let mut system = System::<12>::new(self.values.frame(), particles);
                let lines = vec![(0, along), (1, times(-1.0, along))];
                system.forces.push(Force::spring(lines, stiffness, from));
                let deforms = |state: &[f64; 12]| dot(along, less(velocity(state, 0), velocity(state, 1)));
                self.run_spring(stage, &system, sense, &deforms)?;
                self.remark("Each position is measured from the starting point of its body.");
                Ok(())
            }
        }
    }

    /// Lets the particles go that the first force, the spring, acts on; `deforms` is how fast it is deformed further.
    fn run_spring<const N: usize>(
        &mut self,
        stage: &Spring,
        system: &System<'_, N>,
        sense: f64,
        deforms: &dyn Fn(&[f64; N]) -> f64,
    ) -> Result<(), NothingToSimulate> {
        let deformed = |state: &[f64; N]| system.forces[0].deformation(state).unwrap_or(0.0);
        let from = deformed(&system.state());
        // What is pressed gets shorter until somebody says it is short enough; what is let go, until it is relaxed.
        let ways = if stage.carried.is_some() { sense } else { 1.0 };
        let travel = self.values.known(stage.travel.as_ref()).map(|travel| from + ways * travel);
        let to = travel.or_else(|| self.values.known(stage.to.as_ref())).or(stage.releases().then_some(0.0));
        let lightest = system.particles.iter().filter_map(|particle| particle.mass).fold(f64::INFINITY, f64::min);
        let period = libm::sqrt(lightest / self.values.term(&stage.stiffness)?);
        let integrator = self.integrator(0.1 * period);
        let goes = |state: &[f64; N]| sense * deforms(state);
        let end = match to.filter(|_| stage.until.is_none()) {
            Some(goal) => {
                let left = |state: &[f64; N]| sense * (goal - deformed(state));
                let goal = Goal { left: &left, closing: &goes, whole: (goal - from).abs(), time: period };
                self.go_to(system, integrator, &goal)?
            }
            None => self.go(system, integrator, &Until::Event(&goes))?,
        };
        let scale = system.particles.iter().map(|particle| size(particle.velocity)).sum();
        for (index, particle) in system.particles.iter().enumerate() {
            self.note_velocity(particle.name, velocity(&end.state, index), scale);
        }
        let to = deformed(&end.state);
        let stiffness = self.values.term(&stage.stiffness)?;
        self.note_stored([from, to], |deformed| stiffness * deformed);
        self.note_term(stage.to.as_ref(), to, from);
        self.note_term(stage.travel.as_ref(), ways * (to - from), to);
        self.note_duration(None, end.time);
        Ok(())
    }

    /// Notes the energy of a spring at both ends: its mean force on the way, that at half the deformation, times the deformation.
    pub(super) fn note_stored(&mut self, deformations: [f64; 2], force: impl Fn(f64) -> f64) {
        let suffix = self.values.suffix();
        for (side, deformed) in deformations.into_iter().enumerate() {
            let name = format!("V_spring{}", self.values.index + 1 + side);
            for name in [format!("{name}{suffix}"), name] {
                self.note(&name, force(deformed / 2.0) * deformed, 0.0);
            }
        }
    }

    /// Whether a body moves up from where the spring carried it at rest, which relaxes the spring first.
    fn rises_from_rest(&self, stage: &Spring, axis: Axis) -> Result<bool, NothingToSimulate> {
        let along = self.values.sense(stage.direction.as_ref(), axis)?;
        Ok(stage.carried.is_some() && self.values.gravity(axis)? * along < 0.0)
    }

    /// By how much the spring is deformed at the start: told, or under the weight of what it carried at rest.
    fn deformed(&self, stage: &Spring, stiffness: f64) -> Result<f64, NothingToSimulate> {
        match (&stage.from, &stage.carried) {
            (Some(term), _) => self.values.term(term),
            (None, Some(pan)) => Ok(self.values.mass(pan)? * self.values.named("g")? / stiffness),
            (None, None) => Ok(0.0),
        }
    }
}
