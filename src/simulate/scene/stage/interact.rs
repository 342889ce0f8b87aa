//! Bodies that act on each other only: springs between them, which stand for whatever the forces are.

use momentous_scene::Axis;
use momentous_scene::stage::Interact;

use crate::scene::course::Until;
use crate::scene::in_time::InTime;
use crate::scene::measure::{self, Asked, centre, turning};
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, ZERO, add, cross, less, part, size, times, unit};

/// The most bodies.
const MOST: usize = 4;

/// For how long they are looked at, in units of the time in which they pass each other.
const WATCHED: f64 = 2.0;

impl StageRun<'_> {
    pub(super) fn interact(&mut self, stage: &Interact) -> Result<(), NothingToSimulate> {
        if let Some(friction) = &stage.friction {
            return self.rub(stage, friction);
        }
        let bodies: Vec<&str> = stage.between.iter().map(String::as_str).collect();
        if bodies.len() > MOST {
            return Err(NothingToSimulate::NoMethod);
        }
        let axes: Vec<Vector> = self.values.axes().into_iter().map(unit).collect();
        let placed: Result<Vec<Vector>, _> = bodies.iter().map(|body| measure::place(self.values, body)).collect();
        let mut particles = Vec::new();
        for (index, body) in bodies.iter().enumerate() {
            // Where no places are used, they stand in a row.
            #[allow(clippy::cast_precision_loss, reason = "a handful of bodies")]
            let place = placed.as_ref().map_or([index as f64, 0.0, 0.0], |placed| placed[index]);
            let velocity = if stage.at_rest { ZERO } else { measure::velocity(self.values, body)? };
            let guide = self.values.guide(body).transpose()?;
            particles.push(Particle { place, guide, ..Particle::free(body, self.values.mass(body)?, velocity) });
        }
        let wide = particles.iter().map(|particle| size(less(particle.place, particles[0].place))).fold(0.0, f64::max);
        let fast = particles.iter().map(|particle| size(particle.velocity)).fold(0.0, f64::max);
        if stage.at_rest || stage.during.is_some() {
            self.displaced(stage, &particles, placed.is_ok())?;
        }
        if wide == 0.0 || fast == 0.0 {
            // Nothing is turned or carried along by bodies that stand still.
            return if stage.at_rest { Ok(()) } else { Err(NothingToSimulate::ValueMissing) };
        }
        let guides: Vec<Vector> = particles.iter().filter_map(|particle| particle.guide).collect();
        let masses: Vec<f64> = particles.iter().filter_map(|particle| particle.mass).collect();
        let lightest = masses.iter().copied().fold(f64::INFINITY, f64::min);
        let stiffness = lightest * (fast / wide) * (fast / wide);
        let mut system = System::<{ 6 * MOST }>::new(self.values.frame(), particles);
        for (one, other) in (1..bodies.len()).flat_map(|one| (0..one).map(move |other| (one, other))) {
            let pulls = axes.iter().map(|along| vec![(one, *along), (other, times(-1.0, *along))]);
            system.forces.extend(pulls.map(|lines| Force::spring(lines, stiffness, 0.0)));
        }
        let time = WATCHED * wide / fast;
        let integrator = self.integrator(time / 32.0);
        let end = self.go(&system, integrator, &Until::Time(time))?.state;
        self.remark("The forces between the bodies are not given: they are replaced by springs between all bodies.");
        let momenta: Vec<Vector> =
            masses.iter().enumerate().map(|(index, mass)| times(*mass, velocity(&end, index))).collect();
        let total = momenta.iter().copied().fold(ZERO, add);
        let scale = momenta.iter().map(|momentum| size(*momentum)).fold(0.0, f64::max);
        let instant = self.values.index + 2;
        // Across a guide the sum is what the guide makes of it, which differs with the forces between the bodies.
        let is_free = |axis: &Axis| guides.iter().all(|along| (part(*along, *axis).abs() - 1.0).abs() < f64::EPSILON);
        for axis in self.values.axes().into_iter().filter(is_free) {
            let letter = self.values.letter(axis);
            self.note_sum(&format!("p_{instant}{letter}"), part(total, axis), scale);
        }
        let inside: Vec<&str> = bodies.iter().flat_map(|body| self.values.scene.members(body)).collect();
        let is_all = self.values.scene.bodies.keys().all(|body| inside.contains(&body.as_str()));
        if placed.is_err() || !guides.is_empty() {
            return Ok(());
        }
        for point in self.values.scene.points.keys() {
            let Some(point_of_view) = centre(self.values, &bodies, point, &|_| None) else { continue };
            let moments = momenta
                .iter()
                .enumerate()
                .map(|(index, momentum)| cross(less(place(&end, index), point_of_view), *momentum));
            let all = moments.fold(ZERO, add);
            let letters: &[Option<&str>] = match self.values.axes().len() {
                2 => &[None],
                3 => &[Some("x"), Some("y"), Some("z")],
                _ => &[],
            };
            for component in letters {
                let asked = Asked { base: "H", subject: point, instant, component: *component };
                let letter = component.map_or_else(String::new, |letter| format!(".{letter}"));
                if let Some(moment) = turning(self.values, asked, all) {
                    let name = format!("H_{point}{instant}{letter}");
                    if is_all {
                        self.note(&name, moment, wide * scale);
                    }
                    self.note_sum(&name, moment, wide * scale);
                }
            }
        }
        Ok(())
    }
    /// The centre of mass while the bodies push each other for as long as they do, or for a second.
    fn displaced(
        &mut self,
        stage: &Interact,
        particles: &[Particle<'_>],
        placed: bool,
    ) -> Result<(), NothingToSimulate> {
        let time = stage.during.as_ref().map_or(Ok(1.0), |term| self.values.term(term))?;
        let mut system = System::<{ 6 * MOST }>::new(self.values.frame(), particles.to_vec());
        let lightest = particles.iter().filter_map(|particle| particle.mass).fold(f64::INFINITY, f64::min);
        for (first, axis) in
            (1..particles.len()).flat_map(|index| self.values.axes().into_iter().map(move |axis| (index, axis)))
        {
            let lines = vec![(first, unit(axis)), (first - 1, times(-1.0, unit(axis)))];
            #[allow(clippy::cast_precision_loss, reason = "a handful of bodies")]
            let strength = lightest * first as f64 / (time * time);
            system.forces.push(Force::in_time(lines, InTime::waves(strength, 1.0, time)));
        }
        let integrator = self.integrator(time / 8.0);
        let end = self.try_out(&system, integrator, &Until::Time(time))?.state;
        let whole: f64 = particles.iter().filter_map(|particle| particle.mass).sum();
        let mean = |vector: &dyn Fn(usize, &Particle<'_>) -> Vector| {
            let moved =
                particles.iter().enumerate().filter_map(|(index, particle)| Some((index, particle, particle.mass?)));
            moved.fold(ZERO, |all, (index, particle, mass)| add(all, times(mass / whole, vector(index, particle))))
        };
        let [from, to] = [mean(&|_, particle| particle.place), mean(&|index, _| place(&end, index))];
        let wide = particles.iter().map(|particle| size(particle.place)).fold(size(less(to, from)), f64::max);
        let inside: Vec<&str> = stage.between.iter().flat_map(|body| self.values.scene.members(body)).collect();
        let all = self.values.scene.bodies.keys().all(|body| inside.contains(&body.as_str()));
        for axis in self.values.axes() {
            let letter = self.values.letter(axis);
            let [before, after] = [1, 2].map(|end| format!("r_G{}{letter}", self.values.index + end));
            if placed {
                self.note_sum(&after, part(to, axis), wide);
            }
            let start = if placed { Ok(part(from, axis)) } else { self.values.named(&before) };
            if let Ok(start) = start.map(|start| start + part(less(to, from), axis))
                && all
            {
                self.note(&after, start, wide);
            }
        }
        Ok(())
    }
}
