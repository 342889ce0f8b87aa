//! Particles on an arm: their motion along circles while the arm keeps its lengths, or while some are drawn in.

use core::f64::consts::{PI, TAU};

use momentous_scene::stage::Rotate;

use crate::scene::component::Frame;
use crate::scene::filming::Motion;
use crate::scene::formula::{ARM, Course};
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::recorded_motion::{Look, SeenBody};
use crate::scene::stage_run::StageRun;
use crate::scene::vector::{times, unit};

/// A particle on the arm, with its distances at both ends.
struct Held<'a> {
    body: &'a str,
    mass: f64,
    ends: [f64; 2],
}

impl Held<'_> {
    /// The distance at a share of the time, with its first and second derivatives by that share.
    fn radius(&self, share: f64) -> [f64; 3] {
        let half = (self.ends[1] - self.ends[0]) / 2.0;
        let (sin, cos) = (libm::sin(PI * share), libm::cos(PI * share));
        [self.ends[0] + half * (1.0 - cos), half * PI * sin, half * PI * PI * cos]
    }
}

/// The particles in the plane of their circles, so long after the start of a span, with what holds and drives them.
fn seen(held: &[Held<'_>], state: &[f64; 3], [rate, gain, power]: [f64; 3], [time, span]: [f64; 2]) -> Look {
    let (sin, cos) = (libm::sin(state[0]), libm::cos(state[0]));
    let pointed = |out: f64, round: f64| [out * cos - round * sin, out * sin + round * cos];
    let (mut bodies, mut outside) = (Vec::new(), vec![0.0; 2]);
    for each in held {
        let [radius, speed, gained] = each.radius(time / span);
        let (speed, gained) = (speed / span, gained / (span * span));
        let place = pointed(radius, 0.0).into();
        bodies.push(SeenBody { mass: each.mass, place, velocity: pointed(speed, radius * rate).into() });
        let acceleration = pointed(gained - radius * rate * rate, radius * gain + 2.0 * speed * rate);
        for (sum, part) in outside.iter_mut().zip(acceleration) {
            *sum += each.mass * part;
        }
    }
    Look { bodies, outside, power, ..Look::default() }
}

/// The course of an arm from a state on: by its moment, where it keeps its lengths.
fn turned(held: &[Held<'_>], moment: &InTime, (begun, start): (f64, [f64; 3])) -> Course<3> {
    if held.iter().any(|held| held.ends[0].total_cmp(&held.ends[1]).is_ne()) {
        return Course::Equations(ARM);
    }
    let resists: f64 = held.iter().map(|held| held.mass * held.ends[0] * held.ends[0]).sum();
    moment.course(begun).map(move |now, [given, turned]| {
        let rate = start[1] + given / resists;
        let angle = start[0] + start[1] * (now - begun) + turned / resists;
        [angle, rate, start[2] + given * f64::midpoint(start[1], rate)]
    })
}

impl StageRun<'_> {
    /// The moment of all that turns the arm, and when something in it changes its law.
    fn turned_by(&self, stage: &Rotate) -> Result<(InTime, Vec<f64>), NothingToSimulate> {
        let (mut all, mut changes): (Vec<(f64, InTime)>, Vec<f64>) = (Vec::new(), Vec::new());
        if let Some(moment) = &stage.moment {
            let (strength, jumps) = self.values.strength(moment)?;
            all.push((1.0, strength));
            changes.extend(jumps);
        }
        for (force, on) in stage.driving() {
            let (_, arm) = on.ok_or(NothingToSimulate::Unread)?;
            let (strength, jumps) = self.values.strength(&force.value)?;
            all.push((self.values.term(arm.ends()[0])?, strength));
            changes.extend(jumps);
        }
        changes.sort_by(f64::total_cmp);
        Ok((InTime::sum(&all), changes))
    }

    pub(super) fn rotate(&mut self, stage: &Rotate) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        let first = self.values.index + 1;
        let mut held = Vec::new();
        for (body, arm) in stage.held() {
            let [from, to] = arm.ends();
            // What one particle does alone, without a moment, is the same whatever its mass.
            let lone = !stage.is_driven() && stage.bodies.len() < 2 && stage.rotor.is_none();
            let mass = if lone { self.values.any_mass(body) } else { self.values.mass(body)? };
            held.push(Held { body, mass, ends: [self.values.term(from)?, self.values.term(to)?] });
        }
        let weighed = held.iter().all(|held| self.values.mass(held.body).is_ok());
        let turning = |held: &Held<'_>| Ok(self.values.velocity_before(held.body, axis)? / held.ends[0]);
        let turning_of = held.first().filter(|_| !stage.is_arm()).map_or("", |held| held.body);
        // A period says nothing of the sense, so it comes last.
        let period = || Ok(TAU / self.values.named(&format!("period_{turning_of}{first}"))?);
        let started = self.values.named(&format!("omega_{turning_of}{first}"));
        let before = held.iter().fold(started, |known, held| known.or_else(|_| turning(held))).or_else(|_| period())?;
        // What carries the particles is one more, of so much mass that its moment of inertia is the same.
        if let Some(rotor) = &stage.rotor {
            let arm = held.first().map_or(1.0, |held| held.ends[0]);
            let mass = self.values.inertia(Some(rotor))? / (arm * arm);
            held.push(Held { body: rotor, mass, ends: [arm, arm] });
        }
        let (moment, changes) = self.turned_by(stage)?;
        // Without a moment how long it takes does not matter: about as long as an eighth of a turn.
        let [start, end] = match (stage.is_driven(), &stage.during) {
            (false, None) => [0.0, 1.0 / before.abs()],
            (_, during) => self.during(during.as_ref())?,
        };
        let span = end - start;
        // The angle, its rate, and the work of what holds and drives the particles: across the arm they share the moment, and
        // the arm's change turns them; along it each is held or drawn.
        let slope = |time: f64, state: &[f64; 3]| {
            let (mut resisting, mut driving, mut drawing) = (0.0, moment.at(time), 0.0);
            let rate = state[1];
            for each in &held {
                let [radius, speed, gained] = each.radius((time - start) / span);
                let (speed, gained) = (speed / span, gained / (span * span));
                resisting += each.mass * radius * radius;
                driving -= 2.0 * each.mass * radius * speed * rate;
                drawing += each.mass * (gained - radius * rate * rate) * speed;
            }
            [rate, driving / resisting, drawing + moment.at(time) * rate]
        };
        let integrator = self.integrator(span / 32.0);
        let names: Vec<&str> = held.iter().map(|held| held.body).collect();
        let (mut time, mut state, mut fastest) = (start, [0.0, before, 0.0], before.abs());
        for next in changes.into_iter().filter(|change| *change > start && *change < end).chain([end]) {
            let within = |at: f64, state: &[f64; 3]| slope(if at >= next { next.next_down() } else { at }, state);
            let look = |at: f64, state: &[f64; 3]| seen(&held, state, within(at, state), [at - start, span]);
            let (components, begun) = (Frame::plane(false).components, (time, state));
            let course = &self.course(|| turned(&held, &moment, begun));
            let start = begun;
            self.film(&Motion { names: &names, components, start, end: next, slope: &within, course, look: &look })?;
            self.about(vec![0.0; 2], false);
            let reached = integrator.run(time, state, next, &within, &|_, _| 1.0)?;
            (state, time, fastest) = (reached.state, next, fastest.max(reached.largest[1]));
        }
        if held.len() > 1 {
            self.remark(
                "The positions of the particles on their circles are not given: all are drawn on one side of the centre.",
            );
        }
        if stage.rotor.is_some() {
            self.remark("What carries the particles is shown as a particle with the same moment of inertia.");
        }
        let [_, after, work] = state;
        let resists = |side: usize| held.iter().map(|held| held.mass * held.ends[side] * held.ends[side]).sum::<f64>();
        let energy = resists(0) * before * before / 2.0;
        self.note_here("work", work, energy);
        if stage.is_driven() {
            let (from, to) = (resists(0) * before, resists(1) * after);
            self.note_angular_impulse("", to - from, resists(1) * fastest);
        }
        let all = self.values.scene.bodies.len() == stage.turning().len();
        for (instant, side, rate) in [(first, 0, before), (first + 1, 1, after)] {
            if weighed && all {
                self.note(&format!("H_{}{instant}", stage.about), resists(side) * rate, resists(side) * fastest);
                self.note(&format!("T_{instant}"), resists(side) * rate * rate / 2.0, resists(side) * rate * fastest);
            }
            self.note(&format!("omega_{turning_of}{instant}"), rate, fastest);
            self.note(&format!("period_{turning_of}{instant}"), TAU / rate.abs(), TAU * fastest / (rate * rate));
            for each in held.iter().filter(|held| stage.rotor.as_deref() != Some(held.body)) {
                let [towards, scale] = [rate, fastest].map(|other| each.ends[side] * rate * other);
                self.note(&format!("a_{}{instant}.n", each.body), towards, scale);
                if weighed {
                    self.note(&format!("tension_{}{instant}", each.body), each.mass * towards, each.mass * scale);
                }
            }
        }
        for each in held.iter().filter(|held| stage.rotor.as_deref() != Some(held.body)) {
            self.note(&self.values.start_name(each.body, axis), each.ends[0] * before, 0.0);
            self.note_velocity(each.body, times(each.ends[1] * after, unit(axis)), each.ends[1] * fastest);
        }
        Ok(())
    }
}
