//! A spring that a body runs into or is pushed away by, or a spring between two bodies.

use crate::scene::Axis;
use crate::scene::stage::{Ends, Spring};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{times, unit};

impl Bench<'_> {
    pub(super) fn spring(&mut self, stage: &Spring) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let stiffness = self.values.term(&stage.stiffness)?;
        let from = self.deformed(stage, stiffness)?;
        let told = |term: &Option<crate::scene::Term>| term.as_ref().and_then(|term| self.values.term(term).ok());
        // What is pressed gets shorter until somebody says it is short enough; what is let go, until it is relaxed.
        let to = match (told(&stage.to), told(&stage.travel)) {
            (_, Some(travel)) => Some(from + travel),
            (Some(to), None) => Some(to),
            (None, None) => stage.releases().then_some(0.0),
        };
        let sense = if stage.releases() { -1.0 } else { 1.0 };
        let stops = stage.until.is_some();
        let left = |deformation: f64| sense * (to.unwrap_or(f64::INFINITY) - deformation);
        match stage.ends().ok_or(NothingToSimulate::NoStage)? {
            Ends::Fixed(body) => {
                let mass = self.values.mass(body)?;
                let way = self.values.sense(stage.direction.as_ref(), axis)?;
                let slope = self.values.slope(stage.incline.as_ref())?;
                let friction = stage.friction.as_ref().map_or(Ok(0.0), |term| self.values.term(term))?;
                let level = friction == 0.0 && stage.incline.is_none();
                let gravity = if level { 0.0 } else { self.values.named("g")? };
                let drive = way * (self.values.gravity(axis)? + slope.along * gravity);
                let grip = friction * slope.across * gravity;
                let start = [from, way * self.values.velocity_before(body, axis)?];
                let split = |value: f64| self.values.split(times(way * value, unit(axis)));
                let look = |_: f64, &[deformed, speed]: &[f64; 2]| {
                    let gone = sense * (deformed - from);
                    Look {
                        bodies: vec![Seen { mass, place: split(gone), velocity: split(speed) }],
                        outside: split(mass * (drive - grip) - sense * stiffness * deformed),
                        potential: stiffness * deformed * deformed / 2.0 - mass * drive * gone,
                        power: -mass * grip * speed,
                        ..Look::default()
                    }
                };
                let slope = |_: f64, state: &[f64; 2]| {
                    let push = stiffness * state[0] / mass;
                    [sense * state[1], drive - grip - sense * push]
                };
                let integrator = self.integrator(0.1 * libm::sqrt(mass / stiffness));
                let stop = |_: f64, state: &[f64; 2]| if stops { state[1] } else { left(state[0]) };
                let (time, end) = integrator.event(0.0, start, &slope, &stop)?;
                let (names, components) = (&[body], self.values.components());
                self.film(&Motion { names, components, start: (0.0, start), end: time, slope: &slope, look: &look })?;
                let velocity = if stops { 0.0 } else { way * end[1] };
                self.note_velocity(body, times(velocity, unit(axis)), start[1]);
                self.note_spring(stage, from, end[0]);
                self.note_duration(None, time);
            }
            Ends::Free(first, second) => {
                let masses = [self.values.mass(first)?, self.values.mass(second)?];
                let [a, b] = [self.values.velocity_before(first, axis)?, self.values.velocity_before(second, axis)?];
                let slope = |_: f64, state: &[f64; 3]| {
                    let push = stiffness * state[0];
                    [state[1] - state[2], -push / masses[0], push / masses[1]]
                };
                let integrator = self.integrator(0.1 * libm::sqrt(masses[0].min(masses[1]) / stiffness));
                let stop = |_: f64, state: &[f64; 3]| if stops { state[1] - state[2] } else { left(state[0]) };
                let (time, end) = integrator.event(0.0, [from, a, b], &slope, &stop)?;
                self.film_between([first, second], masses, (time, [from, a, b], stiffness), axis)?;
                for (body, velocity) in [(first, end[1]), (second, end[2])] {
                    self.note_velocity(body, times(velocity, unit(axis)), a.abs() + b.abs());
                }
                self.note_spring(stage, from, end[0]);
                self.note_duration(None, time);
            }
        }
        Ok(())
    }

    /// The motion of both bodies, from where each of them starts.
    fn film_between(
        &mut self,
        names: [&str; 2],
        masses: [f64; 2],
        (end, [from, a, b], stiffness): (f64, [f64; 3], f64),
        axis: Axis,
    ) -> Result<(), NothingToSimulate> {
        let slope = |_: f64, &[deformed, one, other, ..]: &[f64; 5]| {
            let push = stiffness * deformed;
            [one - other, -push / masses[0], push / masses[1], one, other]
        };
        let split = |value: f64| self.values.split(times(value, unit(axis)));
        let look = |_: f64, &[deformed, one, other, here, there]: &[f64; 5]| Look {
            bodies: vec![
                Seen { mass: masses[0], place: split(here), velocity: split(one) },
                Seen { mass: masses[1], place: split(there), velocity: split(other) },
            ],
            potential: stiffness * deformed * deformed / 2.0,
            ..Look::default()
        };
        let (names, components, start) = (&names, self.values.components(), (0.0, [from, a, b, 0.0, 0.0]));
        self.film(&Motion { names, components, start, end, slope: &slope, look: &look })?;
        self.remark("Each position is measured from the starting point of its body.");
        Ok(())
    }

    /// By how much the spring is deformed at the start: told, or under the weight of what it carried at rest.
    fn deformed(&self, stage: &Spring, stiffness: f64) -> Result<f64, NothingToSimulate> {
        match (&stage.from, &stage.carried) {
            (Some(term), _) => self.values.term(term),
            (None, Some(pan)) => Ok(self.values.mass(pan)? * self.values.named("g")? / stiffness),
            (None, None) => Ok(0.0),
        }
    }

    fn note_spring(&mut self, stage: &Spring, from: f64, to: f64) {
        self.note_term(stage.to.as_ref(), to, 0.0);
        self.note_term(stage.travel.as_ref(), to - from, to);
    }
}
