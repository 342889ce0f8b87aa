//! Forces of known law on a body: for a time, over a distance, until it is at rest; against dry friction where there is any.

use std::sync::Arc;

use crate::scene::stage::{During, Push};
use crate::scene::{Axis, Force, Friction, Pull, Strength};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::floor::{Slide, Sliding, Until};
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::values::OfTime;
use crate::simulate::scene::vector::{Vector, ZERO, across, add, dot, part, times, unit};

/// What a body feels along an axis and across it, upwards: forces in the time of the stage.
pub(super) struct Felt {
    pub along: OfTime,
    lifted: OfTime,
    changes: Vec<f64>,
}

impl Bench<'_> {
    pub(super) fn push(&mut self, stage: &Push) -> Result<(), NothingToSimulate> {
        let friction = stage.forces.iter().find_map(|force| match force {
            Force::Friction(entry) => Some(&entry.friction),
            Force::Pull(_) => None,
        });
        if friction.is_some() || stage.incline.is_some() || stage.over.is_some() || stage.until.is_some() {
            return self.push_along(stage, friction);
        }
        let rated = self.note_rates(stage)?;
        let [start, end] = match self.during(stage.during.as_ref()) {
            // How long the forces act may be left open where only what they begin with is used.
            Err(NothingToSimulate::ValueMissing) if rated => return Ok(()),
            during => during?,
        };
        let mass = self.values.mass(&stage.body)?;
        let mut impulse = ZERO;
        for axis in self.values.axes() {
            let felt = self.felt(stage, unit(axis))?;
            let weight = mass * self.values.gravity(axis)?;
            let along = felt.along;
            let drive: OfTime = Arc::new(move |time| (along(time) + weight) / mass);
            let before = self.values.velocity_before(&stage.body, axis)?;
            let rest: OfTime = Arc::new(|_| 0.0);
            let slide = Slide { drive, grip: rest, changes: felt.changes, start, speed: before, body: None };
            // What is gained from rest, in the velocity that the body has anyhow, is the impulse.
            let gained = Slide {
                speed: 0.0,
                drive: Arc::clone(&slide.drive),
                grip: Arc::clone(&slide.grip),
                changes: slide.changes.clone(),
                start,
                body: None,
            }
            .run(self, 1.0, Until::Time(end))?;
            let slid = slide.run(self, 1.0, Until::Time(end))?;
            self.note(&self.values.velocity_after(&stage.body, axis), slid.speed, before);
            impulse = add(impulse, times(mass * gained.speed, unit(axis)));
        }
        self.note_impulse(&stage.body, impulse, None);
        self.note_duration(None, end - start);
        Ok(())
    }

    /// When the forces act, on their own clock.
    pub(super) fn during(&self, during: Option<&During>) -> Result<[f64; 2], NothingToSimulate> {
        Ok(match during {
            Some(During::For(term)) => [0.0, self.values.term(term)?],
            Some(During::Between([from, to])) => [self.values.term(from)?, self.values.term(to)?],
            None => [0.0, self.values.duration()?],
        })
    }

    /// What pushes and pulls make up along a direction, and at right angles to it.
    pub(super) fn felt(&self, stage: &Push, along: Vector) -> Result<Felt, NothingToSimulate> {
        let mut all: Vec<(Vector, OfTime)> = Vec::new();
        let mut changes: Vec<f64> = Vec::new();
        for force in &stage.forces {
            let Force::Pull(Pull { value, direction, .. }) = force else { continue };
            if let Strength::Components(components) = value {
                for (axis, term) in components.axes().filter_map(|axis| Some((axis, components.get(axis)?))) {
                    all.push((unit(axis), self.values.of_time(term)?));
                }
                continue;
            }
            let towards = match direction {
                Some(term) => self.values.direction(&term.0)?,
                None => self.values.axes().first().map_or(unit(Axis::X), |axis| unit(*axis)),
            };
            let (strength, own) = self.values.strength(value)?;
            changes.extend(own);
            all.push((towards, strength));
        }
        changes.sort_by(f64::total_cmp);
        let sum = |of: Vector| -> OfTime {
            let parts: Vec<(f64, OfTime)> =
                all.iter().map(|(towards, strength)| (dot(*towards, of), Arc::clone(strength))).collect();
            Arc::new(move |time| parts.iter().map(|(part, strength)| part * strength(time)).sum())
        };
        Ok(Felt { along: sum(along), lifted: sum(across(along)), changes })
    }

    /// Along one axis, on a floor or a slope.
    fn push_along(&mut self, stage: &Push, friction: Option<&Friction>) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (body, mass) = (stage.body.as_str(), self.values.mass(&stage.body)?);
        let slope = self.values.slope(stage.incline.as_ref())?;
        let needs_weight = friction.is_some() || stage.incline.is_some();
        let gravity = if needs_weight { self.values.named("g")? } else { 0.0 };
        let Felt { along, lifted, changes } = self.felt(stage, unit(axis))?;
        let weight = mass * (gravity * slope.along + self.values.gravity(axis)?);
        let pressed = mass * gravity * slope.across;
        let normal: OfTime = Arc::new(move |time| pressed - lifted(time));
        let drive: OfTime = Arc::new(move |time| (along(time) + weight) / mass);
        let kinetic = friction.map_or(Ok(0.0), |own| self.values.term(&own.kinetic))?;
        let pressing = Arc::clone(&normal);
        let grip: OfTime = Arc::new(move |time| kinetic * pressing(time) / mass);
        let sense = self.values.sense(stage.direction.as_ref(), axis)?;
        let span = self.during(stage.during.as_ref());
        let over = stage.over.as_ref().and_then(|term| self.values.term(term).ok());
        let until = match (stage.until, &span, over) {
            (Some(_), ..) => Until::Rest,
            (None, Ok([_, end]), _) => Until::Time(*end),
            (None, Err(_), Some(way)) => Until::Way(way),
            (None, Err(missing), None) => return Err(*missing),
        };
        let mut start = span.map_or(0.0, |[start, _]| start);
        let begun = start;
        let at_rest = friction.and_then(|own| own.at_rest.as_ref());
        let speed = if at_rest.is_some() { 0.0 } else { self.velocity_or_rest(body, axis)? };
        if let Some(term) = at_rest {
            let threshold = self.values.term(term)?;
            let holds = |time: f64| threshold * normal(time) / mass - drive(time).abs();
            let Until::Time(end) = until else { return Err(NothingToSimulate::NoMethod) };
            if holds(start) > 0.0 {
                let integrator = self.integrator((end - start) / 64.0);
                let still = integrator.run(start, [0.0], end, &|_, _| [0.0], &|time, _| holds(time))?;
                if !still.stopped {
                    self.note(&self.values.velocity_after(body, axis), 0.0, 0.0);
                    return Ok(());
                }
                start = still.time;
            }
            self.note_here("t_start", start, 0.0);
        }
        let sense = if at_rest.is_some() { drive(start).signum() } else { sense };
        let pulled = Sliding { name: body.to_owned(), mass, axis, weight: weight / mass };
        let slide = Slide { drive, grip, changes, start, speed, body: Some(pulled) };
        let slid = slide.run(self, sense, until)?;
        self.note(&self.values.velocity_after(body, axis), slid.speed, speed);
        self.note_term(stage.over.as_ref(), slid.way.abs(), 0.0);
        let term = match &stage.during {
            Some(During::For(term)) => Some(term),
            _ => None,
        };
        self.note_duration(term, slid.time + start - begun);
        if needs_weight {
            self.note_here(&format!("N_{body}"), normal(start), 0.0);
        }
        Ok(())
    }

    fn velocity_or_rest(&self, body: &str, axis: Axis) -> Result<f64, NothingToSimulate> {
        Ok(part(self.values.moving(body)?, axis))
    }
}
