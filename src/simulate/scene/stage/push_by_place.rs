//! Forces that depend on the position: the energy that they give, added up along the way.

use momentous_scene::stage::{Push, Until};
use momentous_scene::{Force, Strength};

use crate::scene::nothing::NothingToSimulate;
use crate::scene::stage_run::{StageRun, kinetic};
use crate::scene::values::OfSeveral;
use crate::scene::vector::{across, dot, part, times, unit};

impl StageRun<'_> {
    pub(super) fn push_by_place(&mut self, stage: &Push, body: &str) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let index = self.values.index;
        let (mass, before) = (self.values.mass(body)?, self.values.velocity_before(body, axis)?);
        let from = self.values.place_before(body, axis)?;
        let mut strengths = Vec::new();
        let (mut grip, mut lifts) = (0.0, Vec::new());
        for force in &stage.forces {
            let pull = match force {
                Force::Pull(pull) => pull,
                Force::Friction(friction) => {
                    grip = self.values.term(&friction.friction.kinetic)?;
                    continue;
                }
            };
            let Strength::Term(term) = &pull.value else { return Err(NothingToSimulate::Unread) };
            let towards = self.values.towards(pull.direction.as_ref())?;
            let strength = self.values.of_several(&term.0, &[axis.letter().to_owned()])?;
            lifts.push((dot(towards, across(unit(axis))), strength.clone()));
            strengths.push((part(towards, axis), strength));
        }
        let falls = part(self.values.falling()?, axis);
        let slope = self.values.slope(stage.incline.as_ref())?;
        let needs_weight = slope.along != 0.0 || grip != 0.0;
        let gravity = if needs_weight { self.values.named("g")? } else { 0.0 };
        let mut ahead = before.signum();
        if before == 0.0 {
            ahead = self.values.sense(stage.direction.as_ref(), axis)?;
        }
        let all = |forces: &[(f64, OfSeveral)], place: f64| {
            forces.iter().map(|(towards, strength)| towards * strength(&[place])).sum::<f64>()
        };
        let force = |place: f64| {
            let presses = mass * gravity * slope.across - all(&lifts, place);
            all(&strengths, place) + mass * (falls + gravity * slope.along) - ahead * grip * presses
        };
        let begins = kinetic(mass, times(before, unit(axis)));
        let gains = |way: f64, _: &[f64; 1]| [ahead * force(from + ahead * way)];
        let known = self.values.known(stage.over.as_ref());
        let known = known
            .or_else(|| Some((self.values.named(&self.values.place_name(body, index + 2, axis)).ok()? - from).abs()));
        let (way, energy, most) = match (stage.until, known) {
            (Some(Until::Rest), _) => {
                let quick = force(from).abs().max(force(from + ahead).abs()).max(f64::MIN_POSITIVE);
                let integrator = self.integrator((begins / quick).clamp(1e-6, 100.0) / 4.0);
                let (way, _) = integrator.event(0.0, [begins], &gains, &|_, state| state[0])?;
                (way, 0.0, begins)
            }
            (None, Some(way)) => {
                // A body that comes to rest on the way gets no further; from rest, one that is driven back goes nowhere.
                let end = self.integrator(way / 64.0).run(0.0, [begins], way, &gains, &|_, state| state[0])?;
                let most = end.largest[0];
                match (begins == 0.0 && ahead * force(from) < 0.0, end.stopped) {
                    (true, _) => (0.0, 0.0, most),
                    (false, true) => (end.time, 0.0, most),
                    (false, false) => (way, end.state[0], most),
                }
            }
            (None, None) => return Err(NothingToSimulate::ValueMissing),
        };
        let after = ahead * libm::sqrt(2.0 * energy.max(0.0) / mass);
        // Near a place where it turns back, a small error of the energy is a large one of the velocity.
        let slow = libm::sqrt(2.0 * self.tolerance * most / mass);
        let scale = before.abs().max(if most > 0.0 { most / (mass * after.abs().max(slow)) } else { 0.0 });
        self.note(&self.values.velocity_after(body, axis), after, scale);
        self.note(&self.values.place_name(body, index + 2, axis), from + ahead * way, from.abs().max(way));
        self.note_term(stage.over.as_ref(), way, 0.0);
        if grip != 0.0 {
            self.note_here(&format!("N_{body}"), mass * gravity * slope.across - all(&lifts, from), 0.0);
        }
        self.note_vector_of(&format!("J_{body}"), times(mass * (after - before), unit(axis)), mass * scale);
        let ends = [from, from + ahead * way].map(force);
        let largest = [0.0, 0.3, 0.5, 1.0].map(|share| force(from + share * ahead * way).abs());
        let largest = largest.into_iter().fold(0.0, f64::max);
        let scene = self.values.scene;
        let first = usize::from(scene.follows_a_force(index, body));
        for (instant, force) in (index + 1..).zip(ends).skip(first) {
            self.note(&format!("F_{body}{instant}"), force, largest);
            self.note(&format!("a_{body}{instant}"), force / mass, largest / mass);
        }
        Ok(())
    }
}
