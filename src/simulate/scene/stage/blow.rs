//! A blow: some force for some short time, whose history nobody knows. Any history with the impulse does the same.

use momentous_scene::stage::Blow;

use crate::scene::course::Until;
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, ZERO, add, dot, part, size, times, unit};

/// The place of the force's impulse in a state of one particle.
const IMPULSE: usize = 6;

impl StageRun<'_> {
    pub(super) fn blow(&mut self, stage: &Blow) -> Result<(), NothingToSimulate> {
        if self.values.axes().is_empty() {
            return self.blow_round(stage);
        }
        let body = stage.body.as_str();
        let particle = self.values.particle(body)?;
        let (mass, before) = (self.values.mass(body)?, particle.velocity);
        let weight = times(1.0 / mass, self.weight_in_contact(mass, &stage.include, stage.duration.as_ref())?);
        let end = 1.0 / self.shorter;
        let (integrator, until) = (self.integrator(end / 4.0), Until::Time(end));
        let values = self.values;
        let struck = |velocity: Vector, force: Vector| {
            let wave = Force::in_time(vec![(0, force)], InTime::waves(1.0, 1.0, end));
            let particle = Particle { velocity, ..particle };
            System { forces: vec![wave], ..System::<7>::new(values.frame(), vec![particle]) }
        };
        // What comes of a blow of 1 N says how strong it has to be.
        let newton = self.values.towards(None)?;
        let (one, mut force) = (struck(ZERO, newton), ZERO);
        let tried = self.try_out(&one, integrator, &until)?.state;
        for axis in self.values.axes() {
            let start = part(add(before, weight), axis);
            let letter = self.values.letter(axis);
            let impulse = self.values.named(&format!("J_{body}{letter}{}", self.values.suffix()));
            // A guide takes up what acts across it, so only the impulse itself tells how strong the blow is.
            let after = match particle.guide {
                Some(_) => Err(NothingToSimulate::ValueMissing),
                None => self.values.named(&self.values.velocity_after(body, axis)),
            };
            let strength = match (impulse, after) {
                (_, Ok(after)) => (after - start) / dot(newton, velocity(&tried, 0)),
                (Ok(impulse), Err(_)) => impulse / tried[IMPULSE],
                (Err(missing), Err(_)) => return Err(missing),
            };
            force = add(force, times(strength, unit(axis)));
        }
        let mut hit = struck(before, force);
        // Weight acts for as long as the force does.
        for particle in &mut hit.particles {
            particle.falls = times(1.0 / end, weight);
        }
        let reached = self.go(&hit, integrator, &until)?.state;
        self.remark("How the force varies is not given: it is drawn as half a sine wave of one second.");
        self.note_velocity(body, velocity(&reached, 0), size(before));
        self.note_impulse(body, times(reached[IMPULSE], force), stage.duration.as_ref());
        Ok(())
    }

    /// The same where the velocity is told along the radius from a centre and across it: the body stays where it is meanwhile, so that
    /// these are fixed directions.
    fn blow_round(&mut self, stage: &Blow) -> Result<(), NothingToSimulate> {
        let body = stage.body.as_str();
        let (mass, suffix, instant) = (self.values.mass(body)?, self.values.suffix(), self.values.index + 1);
        let end = 1.0 / self.shorter;
        let (integrator, until) = (self.integrator(end / 4.0), Until::Time(end));
        let values = self.values;
        let struck = |speed: f64, strength: f64| {
            let wave = Force::in_time(vec![(0, [strength, 0.0, 0.0])], InTime::waves(1.0, 1.0, end));
            let particle = Particle::free(body, mass, [speed, 0.0, 0.0]);
            System { forces: vec![wave], ..System::<7>::new(values.frame(), vec![particle]) }
        };
        let tried = self.try_out(&struck(0.0, 1.0), integrator, &until)?.state;
        let mut whole = ZERO;
        for (component, letter) in whole.iter_mut().zip(["r", "theta"]) {
            let before = values.named(&format!("v_{body}{instant}.{letter}"))?;
            let impulse = values.named(&format!("J_{body}.{letter}{suffix}"));
            let strength = match (impulse, values.named(&format!("v_{body}{}.{letter}", instant + 1))) {
                (_, Ok(after)) => (after - before) / velocity(&tried, 0)[0],
                (Ok(impulse), Err(_)) => impulse / tried[IMPULSE],
                (Err(missing), Err(_)) => return Err(missing),
            };
            let reached = self.try_out(&struck(before, strength), integrator, &until)?.state;
            *component = strength * reached[IMPULSE];
            self.note(&format!("v_{body}{}.{letter}", instant + 1), velocity(&reached, 0)[0], before.abs());
            self.note_here(&format!("J_{body}.{letter}"), *component, mass * before.abs());
        }
        self.note_here(&format!("J_{body}"), size(whole), size(whole));
        if let Some(time) = values.known(stage.duration.as_ref()) {
            self.note_here(&format!("F_avg_{body}"), size(whole) / time, size(whole) / time);
        }
        Ok(())
    }
}
