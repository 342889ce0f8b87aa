//! Impacts: velocities event driven, the two phases and the impulses by a contact that lasts.

use momentous_scene::stage::{Impact, Partners};

use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::Particle;
use crate::scene::pushed::Pushed;
use crate::scene::stage_run::{StageRun, kinetic};
use crate::scene::touch::{Parted, Touch};
use crate::scene::vector::{Vector, across, add, dot, less, part, size, times, unit};

/// The share of the energy before at which a search for the coefficient of restitution ends.
const CLOSE: f64 = 1e-14;

/// Halvings of that search.
const HALVINGS: usize = 60;

impl StageRun<'_> {
    pub(super) fn impact(&mut self, stage: &Impact) -> Result<(), NothingToSimulate> {
        match stage.partners() {
            Some(Partners::Bodies(first, second)) if stage.plastic => self.stick(stage, [first, second]),
            Some(Partners::Bodies(first, second)) => self.collide(stage, [first, second]),
            Some(Partners::Surface(body, surface)) => self.rebound(stage, body, surface),
            None => Err(NothingToSimulate::NoStage),
        }
    }

    fn collide(&mut self, stage: &Impact, bodies: [&str; 2]) -> Result<(), NothingToSimulate> {
        let normal = match &stage.line_of_impact {
            Some(term) => self.values.direction(&term.0)?,
            None => match self.values.axes()[..] {
                [only] => unit(only),
                _ => return Err(NothingToSimulate::NoLineOfImpact),
            },
        };
        let parties = [self.values.particle(bodies[0])?, self.values.particle(bodies[1])?];
        let touch = Touch { parties, normal, restitution: 0.0 };
        let touch = Touch { restitution: self.restitution(stage, &touch)?, ..touch };
        let parted = touch.watched(self)?;
        if stage.loss.is_none() && parties.iter().all(|party| party.guide.is_none()) {
            self.take(&self.values.impact(stage)?)?;
        } else {
            self.note_velocities(&parted.bodies);
        }
        self.note_parting(stage, &touch, &parted, &parted.bodies);
        Ok(())
    }

    /// The coefficient of restitution: given, or found by trying which one loses the energy that is given.
    fn restitution(&mut self, stage: &Impact, touch: &Touch<'_>) -> Result<f64, NothingToSimulate> {
        let Some(term) = &stage.loss else { return self.values.coefficient(stage) };
        let loss = self.values.term(term)?;
        let energy = |velocities: [Vector; 2]| -> f64 {
            let each = touch.parties.iter().zip(velocities);
            // What does not move has no mass.
            each.filter_map(|(party, velocity)| Some(kinetic(party.mass?, velocity))).sum()
        };
        let start = energy(touch.parties.map(|party| party.velocity));
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            let lost = start - energy(Touch { restitution: middle, ..*touch }.run(self)?.bodies.map(|body| body.after));
            if (lost - loss).abs() <= CLOSE * start {
                return Ok(middle);
            }
            if lost > loss { low = middle } else { high = middle }
        }
        Ok(f64::midpoint(low, high))
    }

    fn rebound(&mut self, stage: &Impact, body: &str, surface: &str) -> Result<(), NothingToSimulate> {
        let entry = self.values.scene.surfaces.get(surface).ok_or(NothingToSimulate::NoStage)?;
        let outward = self.values.direction(&entry.normal.0)?;
        let moves = self.values.or_zero(entry.velocity.as_ref())?;
        let is_guided = self.values.guide(body).is_some();
        if stage.include.is_empty() && !is_guided {
            self.take(&self.values.impact(stage)?)?;
        }
        // Without a mass nothing but velocities can be spoken of.
        let Ok(mass) = self.values.mass(body) else { return Ok(()) };
        let wall = Particle { mass: None, ..Particle::free(surface, 0.0, times(moves, outward)) };
        let parties = [self.values.particle(body)?, wall];
        let normal = times(-1.0, outward);
        let touch = Touch { parties, normal, restitution: self.values.coefficient(stage)? };
        // A contact that is watched shows no weight.
        let mut parted = if stage.include.is_empty() { touch.watched(self)? } else { touch.run(self)? };
        // Along the outward normal, or along the only axis.
        let counted = if let [axis] = self.values.axes()[..] { part(outward, axis) } else { 1.0 };
        parted.common *= -counted;
        // What is given of the contact is what it does together with weight.
        let weight = self.weight_in_contact(mass, &stage.include, stage.duration.as_ref())?;
        let [bounced, _] = &mut parted.bodies;
        bounced.impulse = less(bounced.impulse, times(dot(weight, outward), outward));
        let along = less(weight, times(dot(weight, outward), outward));
        bounced.after = add(bounced.after, times(1.0 / mass, along));
        if is_guided || !stage.include.is_empty() {
            self.note_velocity(body, bounced.after, size(bounced.body.velocity));
        }
        self.note_parting(stage, &touch, &parted, &parted.bodies[..1]);
        Ok(())
    }

    /// Bodies that stay together: what holds them takes up their relative motion along each axis.
    fn stick(&mut self, stage: &Impact, bodies: [&str; 2]) -> Result<(), NothingToSimulate> {
        let parties = [self.values.particle(bodies[0])?, self.values.particle(bodies[1])?];
        let guide = parties.iter().find_map(|party| party.guide);
        let lines: Vec<Vector> = match guide {
            Some(along) => vec![along, across(along)],
            None => self.values.axes().into_iter().map(unit).collect(),
        };
        if guide.is_none() {
            self.take(&self.values.impact(stage)?)?;
        }
        let mut held = parties.map(Pushed::new);
        for along in lines {
            let closing = dot(less(held[0].after, held[1].after), along);
            if closing == 0.0 {
                continue;
            }
            let now = held.map(|body| Particle { velocity: body.after, ..body.body });
            let touch = Touch { parties: now, normal: times(closing.signum(), along), restitution: 0.0 };
            for (body, parted) in held.iter_mut().zip(touch.run(self)?.bodies) {
                *body = Pushed { after: parted.after, impulse: add(body.impulse, parted.impulse), ..*body };
            }
        }
        self.note_pushed(&held, stage.duration.as_ref());
        let scale = parties.iter().map(|party| size(party.velocity)).fold(0.0, f64::max);
        for body in parties.iter().filter(|party| party.guide.is_some()) {
            let whole = stage.becomes.as_deref().unwrap_or(body.name);
            self.note_velocity(whole, held[0].after, scale);
        }
        Ok(())
    }

    fn note_parting(&mut self, stage: &Impact, touch: &Touch<'_>, parted: &Parted<'_>, bodies: &[Pushed<'_>]) {
        self.note_pushed(bodies, stage.duration.as_ref());
        for body in bodies {
            self.note_here(&format!("J_{}.n", body.body.name), dot(touch.normal, body.impulse), 0.0);
        }
        // Along a single axis it has the sign of that axis, not of the line of impact.
        let sign = match self.values.axes()[..] {
            [only] => dot(touch.normal, unit(only)),
            _ => 1.0,
        };
        self.note_here("v_common", parted.common * sign, 0.0);
        self.note_here("J_def", parted.phases[0], 0.0);
        self.note_here("J_rest", parted.phases[1], parted.phases[0]);
    }
}
