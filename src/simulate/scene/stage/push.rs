//! Forces of known law on bodies: for a time, over a distance, until it is at rest; against dry friction where there is any.

use momentous_scene::stage::{During, Push, Resistance};
use momentous_scene::{Axis, Force, Friction, Pull, Strength};

use crate::scene::course::Until;
use crate::scene::floor::Finish;
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force as Acting, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, ZERO, across, add, dot, less, part, size, times, unit};

/// Pushes and pulls in the time of the stage, each with its direction; and when one of them changes its law.
type Pulls = (Vec<(Vector, InTime)>, Vec<f64>);

/// How many times the mass by the coefficient of a resistance leave next to nothing of a velocity.
const LONG: f64 = 40.0;

impl StageRun<'_> {
    pub(super) fn push(&mut self, stage: &Push) -> Result<(), NothingToSimulate> {
        let Some(body) = stage.pushed().next().filter(|_| !stage.is_of_several()) else {
            return self.push_system(stage);
        };
        if let Some(change) = stage.mass_change() {
            return self.push_changing(stage, &change, body);
        }
        if matches!(self.values.axes()[..], [axis] if stage.depends_on_place(axis.letter())) {
            return self.push_by_place(stage, body);
        }
        let friction = stage.forces.iter().find_map(|force| match force {
            Force::Friction(entry) => Some(&entry.friction),
            Force::Pull(_) => None,
        });
        if friction.is_some() || stage.incline.is_some() || stage.over.is_some() || stage.until.is_some() {
            return self.push_along(stage, body, friction);
        }
        let rated = self.note_rates(stage)?;
        self.push_freely(stage, body, rated)?;
        Ok(())
    }

    /// A body on which nothing but known forces acts; its impulse, where it is told how long they act.
    pub(super) fn push_freely(
        &mut self,
        stage: &Push,
        body: &str,
        rated: bool,
    ) -> Result<Option<Vector>, NothingToSimulate> {
        let [start, end] = match self.during(stage.during.as_ref()) {
            // How long the forces act may be left open where only what they begin with is used.
            Err(NothingToSimulate::ValueMissing) if rated => return Ok(None),
            during => during?,
        };
        let before = self.values.moving(body)?;
        let mut reached = Vec::new();
        let mut displaced = ZERO;
        // What is gained from rest, in the velocity that the body has anyhow, is the impulse; not where its velocity matters.
        let alike = stage.resistance.is_none();
        for moves in [before, ZERO].into_iter().take(1 + usize::from(alike)) {
            let mut system = self.pulled(stage, body, ZERO, moves)?;
            system.start = start;
            let integrator = self.integrator((end - start) / 4.0);
            let is_seen = reached.is_empty();
            let last = if is_seen {
                self.go(&system, integrator, &Until::Time(end))?
            } else {
                self.try_out(&system, integrator, &Until::Time(end))?
            };
            if is_seen {
                if let Some(resistance) = &stage.resistance {
                    self.note_terminal(&system, resistance)?;
                }
                // A force that is told up to the end still acts just before it.
                self.note_ends(body, &system, [(start, &system.state()), (end.next_down(), &last.state)]);
                displaced = place(&last.state, 0);
            }
            reached.push(velocity(&last.state, 0));
        }
        self.note_velocity(body, reached[0], size(before));
        self.note_place(body, displaced);
        let gained = if alike { reached[1] } else { less(reached[0], before) };
        let impulse = times(self.values.mass(body)?, gained);
        let strongest = self.pulled(stage, body, ZERO, ZERO)?.strongest([start, end]);
        self.note_impulse_by_forces(body, impulse, strongest, end - start);
        self.note_duration(None, end - start);
        Ok(Some(impulse))
    }

    /// Notes acceleration and net force at both ends of a push.
    fn note_ends(&mut self, body: &str, system: &System<'_, 6>, ends: [(f64, &[f64; 6]); 2]) {
        let (scene, index) = (self.values.scene, self.values.index);
        let first = usize::from(scene.follows_a_force(index, body));
        // What vanishes at an end is as sure as the force in between is large.
        let [(start, state), (end, _)] = ends;
        let between = [0.0, 0.3, 0.5, 1.0].map(|share| system.slope(start + share * (end - start), state));
        let largest = between.iter().map(|slope| size(velocity(slope, 0))).fold(0.0, f64::max);
        for (instant, (time, state)) in (index + 1..).zip(ends).skip(first) {
            // Until it slides, static friction balances what acts on it.
            let held = time < system.start;
            let acceleration = if held { ZERO } else { velocity(&system.slope(time, state), 0) };
            for axis in self.values.axes() {
                let (letter, along) = (self.values.letter(axis), part(acceleration, axis));
                self.note(&format!("a_{body}{instant}{letter}"), along, largest);
                if let Ok(mass) = self.values.mass(body) {
                    self.note(&format!("F_{body}{instant}{letter}"), mass * along, mass * largest);
                }
            }
        }
    }

    /// Notes where a body is after the stage, where it is known where it was before.
    pub(super) fn note_place(&mut self, body: &str, displaced: Vector) {
        for axis in self.values.axes() {
            self.note_place_along(body, axis, part(displaced, axis), size(displaced));
        }
    }

    /// The same along one axis, for a part of a way of that length.
    pub(super) fn note_place_along(&mut self, body: &str, axis: Axis, displaced: f64, length: f64) {
        if let Ok(from) = self.values.place_before(body, axis) {
            let name = self.values.place_name(body, self.values.index + 2, axis);
            self.note(&name, from + displaced, from.abs().max(length));
        }
    }

    /// Notes the impulse on a body in so many seconds, and the average force, where forces as strong as that acted on it.
    fn note_impulse_by_forces(&mut self, body: &str, impulse: Vector, strongest: f64, time: f64) {
        self.note_vector_of(&format!("J_{body}"), impulse, strongest * time);
        self.note_vector_of(&format!("F_avg_{body}"), times(1.0 / time, impulse), strongest);
    }

    /// The body under its weight and all pushes and pulls, at a place and with a velocity.
    pub(super) fn pulled<'s>(
        &self,
        stage: &Push,
        body: &'s str,
        place: Vector,
        velocity: Vector,
    ) -> Result<System<'s, 6>, NothingToSimulate> {
        let (pulls, changes) = self.pulls(stage, body)?;
        let guide = match self.values.axes()[..] {
            [only] => Some(unit(only)),
            _ => self.values.guide(body).transpose()?,
        };
        let free = Particle::free(body, self.values.mass(body)?, velocity);
        let particle = Particle { place, falls: self.values.falling()?, guide, ..free };
        let mut forces: Vec<Acting> =
            pulls.into_iter().map(|(towards, strength)| Acting::in_time(vec![(0, towards)], strength)).collect();
        if let Some(resistance) = &stage.resistance {
            let coefficients = match resistance {
                Resistance::Linear(term) => [self.values.term(term)?, 0.0],
                Resistance::Quadratic(term) => [0.0, self.values.term(term)?],
            };
            forces.extend(self.values.axes().into_iter().map(|axis| Acting::resistance(0, unit(axis), coefficients)));
        }
        Ok(System { forces, changes, ..System::new(self.values.frame(), vec![particle]) })
    }

    /// When the forces act, on their own clock.
    pub(super) fn during(&self, during: Option<&During>) -> Result<[f64; 2], NothingToSimulate> {
        Ok(match during {
            Some(During::For(term)) => [0.0, self.values.term(term)?],
            Some(During::Between([from, to])) => [self.values.term(from)?, self.values.term(to)?],
            None => [0.0, self.values.duration()?],
        })
    }

    pub(super) fn pulls(&self, stage: &Push, body: &str) -> Result<Pulls, NothingToSimulate> {
        let (mut all, mut changes): Pulls = (Vec::new(), Vec::new());
        for (_, force) in stage.forces_on(body) {
            let Force::Pull(Pull { value, direction, .. }) = force else { continue };
            if let Strength::Components(components) = value {
                for (axis, term) in components.axes().filter_map(|axis| Some((axis, components.get(axis)?))) {
                    all.push((unit(axis), InTime::always(self.values.law(term)?)));
                }
                continue;
            }
            let (strength, jumps) = self.values.strength(value)?;
            changes.extend(jumps);
            all.push((self.values.towards(direction.as_ref())?, strength));
        }
        changes.sort_by(f64::total_cmp);
        Ok((all, changes))
    }

    /// Notes the velocity at which a body ends up against a resistance in proportion to the speed, whatever it starts with; or the
    /// speed at which one in proportion to its square is as large as what acts on a body at rest.
    pub(super) fn note_terminal(
        &mut self,
        system: &System<'_, 6>,
        resistance: &Resistance,
    ) -> Result<(), NothingToSimulate> {
        let mass =
            system.particles.first().and_then(|particle| particle.mass).ok_or(NothingToSimulate::ValueMissing)?;
        let term = match resistance {
            Resistance::Linear(term) => term,
            Resistance::Quadratic(term) => {
                let still = mass * size(velocity(&system.slope(system.start, &[0.0; 6]), 0));
                if still > 0.0 {
                    self.note_here("w", libm::sqrt(still / self.values.term(term)?), 0.0);
                }
                return Ok(());
            }
        };
        let time = mass / self.values.term(term)?;
        let integrator = self.integrator(time / 4.0);
        let last = self.try_out(system, integrator, &Until::Time(system.start + LONG * time))?;
        let ends = velocity(&last.state, 0);
        for axis in self.values.axes() {
            self.note_here(&format!("w{}", self.values.letter(axis)), part(ends, axis), size(ends));
        }
        Ok(())
    }

    /// When next to nothing is left of a motion that only a resistance in proportion to the speed slows, so that it never ends.
    fn fading(&self, stage: &Push, body: &str, system: &System<'_, 6>) -> Result<Option<f64>, NothingToSimulate> {
        let Some(Resistance::Linear(term)) = &stage.resistance else { return Ok(None) };
        let still = velocity(&system.slope(system.start, &[0.0; 6]), 0);
        Ok((size(still) == 0.0).then_some(LONG * self.values.mass(body)? / self.values.term(term)?))
    }

    /// Along one axis, on a floor or a slope.
    fn push_along(&mut self, stage: &Push, body: &str, friction: Option<&Friction>) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (along, mass) = (unit(axis), self.values.mass(body)?);
        let slope = self.values.slope(stage.incline.as_ref())?;
        let needs_weight = friction.is_some() || stage.incline.is_some();
        let gravity = if needs_weight { self.values.named("g")? } else { 0.0 };
        let at_rest = friction.and_then(|friction| friction.at_rest.as_ref());
        let moves = match self.values.moving(body) {
            // What is not told to move rests on its floor.
            Err(NothingToSimulate::ValueMissing) if at_rest.is_some() => ZERO,
            moves => moves?,
        };
        let mut system = self.pulled(stage, body, ZERO, moves)?;
        system.particles[0].falls = add(system.particles[0].falls, times(gravity * slope.along, along));
        let (lifts, _) = self.pulls(stage, body)?;
        let pressed = mass * gravity * slope.across;
        let lifted = lifts.into_iter().map(|(towards, strength)| (-dot(towards, across(along)), strength));
        let normal = InTime::sum(&[(1.0, InTime::steady(pressed))].into_iter().chain(lifted).collect::<Vec<_>>());
        let span = self.during(stage.during.as_ref());
        let finish = match (stage.until, &span, self.values.known(stage.over.as_ref())) {
            (Some(_), ..) => self.fading(stage, body, &system)?.map_or(Finish::Rest, Finish::Time),
            (None, Ok([_, end]), _) => Finish::Time(*end),
            (None, Err(_), Some(way)) => Finish::Procedure(way),
            (None, Err(missing), None) => return Err(*missing),
        };
        let begun = span.map_or(0.0, |[start, _]| start);
        let mut begins = begun;
        let mut sense = part(moves, axis);
        if sense == 0.0 {
            sense = self.values.sense(stage.direction.as_ref(), axis)?;
        }
        if let Some(term) = at_rest {
            let (threshold, Finish::Time(end)) = (self.values.term(term)?, finish) else {
                return Err(NothingToSimulate::NoMethod);
            };
            let still = system.state();
            let driven = |time: f64| mass * part(velocity(&system.slope(time, &still), 0), axis);
            let holds = |time: f64| threshold * normal.at(time) - driven(time).abs();
            if part(moves, axis) != 0.0 {
                begins = begun;
            } else if holds(begun) > 0.0 {
                let integrator = self.integrator((end - begun) / 64.0);
                let held = integrator.run(begun, [0.0], end, &|_, _| [0.0], &|time, _| holds(time))?;
                if !held.stopped {
                    self.note(&self.values.velocity_after(body, axis), 0.0, 0.0);
                    self.note_place(body, ZERO);
                    system.start = f64::INFINITY;
                    self.note_ends(body, &system, [(begun, &still), (end, &still)]);
                    return Ok(());
                }
                begins = held.time;
            }
            if part(moves, axis) == 0.0 {
                sense = driven(begins);
            }
            self.note_here("t_start", begins, 0.0);
        }
        let ahead = times(sense.signum(), along);
        system.start = begins;
        if let Some(friction) = friction {
            let grip = times(-self.values.term(&friction.kinetic)?, ahead);
            system.forces.push(Acting::in_time(vec![(0, grip)], normal.clone()));
        }
        if let Some(resistance) = &stage.resistance {
            self.note_terminal(&system, resistance)?;
        }
        let end = self.go_along(&system, (0, ahead), finish)?;
        self.note_ends(body, &system, [(begun, &system.state()), (end.time.next_down(), &end.state)]);
        self.note_place(body, place(&end.state, 0));
        self.note_velocity(body, velocity(&end.state, 0), size(moves));
        let time = end.time - begun;
        if time > 0.0 {
            let impulse = times(mass, less(velocity(&end.state, 0), moves));
            // A change of velocity is as sure as the velocities of which it is the difference.
            let strongest = system.strongest([begun, end.time]) + mass * (gravity + size(moves) / time);
            self.note_impulse_by_forces(body, impulse, strongest, time);
        }
        self.note_term(stage.over.as_ref(), dot(ahead, place(&end.state, 0)).abs(), 0.0);
        if !matches!((stage.until, finish), (Some(_), Finish::Time(_))) {
            self.note_duration(stage.duration(), time);
        }
        if needs_weight {
            self.note_here(&format!("N_{body}"), normal.at(begins), 0.0);
        }
        Ok(())
    }
}
