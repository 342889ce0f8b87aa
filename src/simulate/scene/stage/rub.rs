//! A body that slides on another one: an opposite pair of constant forces, until they move together.

use momentous_scene::Term;
use momentous_scene::stage::Interact;

use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, dot, less, size, times, unit};

impl StageRun<'_> {
    pub(super) fn rub(&mut self, stage: &Interact, friction: &Term) -> Result<(), NothingToSimulate> {
        let ([axis], [upper, lower]) = (&self.values.axes()[..], &stage.between[..]) else {
            return Err(NothingToSimulate::Unread);
        };
        let (along, bodies) = (unit(*axis), [upper.as_str(), lower.as_str()]);
        let mut particles = Vec::new();
        for body in bodies {
            let moves = times(self.values.velocity_before(body, *axis)?, along);
            particles.push(Particle::free(body, self.values.mass(body)?, moves));
        }
        let masses = [self.values.mass(upper)?, self.values.mass(lower)?];
        let moved: Vec<(f64, Vector)> =
            masses.into_iter().zip(particles.iter().map(|particle| particle.velocity)).collect();
        let slip = less(particles[0].velocity, particles[1].velocity);
        let scale: f64 = particles.iter().map(|particle| size(particle.velocity)).sum();
        let normal = masses[0] * self.values.named("g")?;
        let force = self.values.term(friction)? * normal;
        let ahead = times(dot(along, slip).signum(), along);
        let mut system = System::<12>::new(self.values.frame(), particles);
        system.forces.push(Force::steady(0, times(-force, ahead)));
        system.forces.push(Force::steady(1, times(force, ahead)));
        let slides = |state: &[f64; 12]| dot(ahead, less(velocity(state, 0), velocity(state, 1)));
        let slid = |state: &[f64; 12]| dot(ahead, less(place(state, 0), place(state, 1)));
        let stopping = size(slip) / (force / masses[0] + force / masses[1]);
        let integrator = self.integrator(stopping / 4.0);
        let end = match (stage.until, self.values.known(stage.distance.as_ref())) {
            (Some(_), _) => self.go(&system, integrator, &Until::Event(&slides))?,
            (None, Some(way)) => self.go(&system, integrator, &Until::Event(&|state| way - slid(state)))?,
            (None, None) => {
                let time = self.values.known(stage.during.as_ref()).map_or_else(|| self.values.duration(), Ok)?;
                self.go(&system, integrator, &Until::Time(time))?
            }
        };
        self.remark("Each position is measured from the starting point of its body.");
        let ends = [0, 1].map(|side| velocity(&end.state, side));
        for (index, body) in bodies.into_iter().enumerate() {
            self.note_velocity(body, ends[index], scale);
            self.note_impulse(body, times(masses[index], less(ends[index], moved[index].1)), None);
            let way = dot(along, place(&end.state, index));
            self.note_here(&format!("s_{body}"), way, scale * end.time);
            let letter = self.values.letter(*axis);
            let [from, to] = [1, 2].map(|side| format!("r_{body}{}{letter}", self.values.index + side));
            if let Ok(from) = self.values.named(&from) {
                self.note(&to, from + way, scale * end.time);
            }
        }
        let rest: Vec<(f64, Vector)> = masses.into_iter().zip(ends).collect();
        self.note_energy(&moved, &rest);
        self.note_here(&format!("N_{upper}"), normal, 0.0);
        self.note_term(stage.distance.as_ref(), slid(&end.state), scale * end.time);
        self.note_duration(stage.during.as_ref(), end.time);
        Ok(())
    }
}
