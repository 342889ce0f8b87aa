//! A particle on an arm: its motion along the circle while the arm keeps its length, or is drawn in.

use std::sync::Arc;

use core::f64::consts::PI;

use crate::scene::stage::Rotate;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::direction::unit;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen, plane};
use crate::simulate::scene::values::OfTime;

impl Bench<'_> {
    pub(super) fn rotate(&mut self, stage: &Rotate) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        // Several particles on one arm push each other through it.
        let [(body, arm)] = stage.held()[..] else { return Err(NothingToSimulate::NoMethod) };
        let [from, to] = arm.ends();
        let [short, long] = [self.values.term(from)?, self.values.term(to)?];
        let before = self.values.velocity_before(body, axis)?;
        let (moment, changes): (OfTime, Vec<f64>) = match &stage.moment {
            Some(moment) => self.values.strength(moment)?,
            None => (Arc::new(|_| 0.0), Vec::new()),
        };
        let mass = if stage.moment.is_some() { self.values.mass(body)? } else { self.values.any_mass(body) };
        // Without a moment how long it takes does not matter: about as long as an eighth of a turn.
        let [start, end] = match (&stage.moment, &stage.during) {
            (None, None) => [0.0, short / before.abs()],
            (_, during) => self.during(during.as_ref())?,
        };
        let arm = |time: f64| {
            let phase = PI * (time - start) / (end - start);
            let (half, quick) = ((long - short) / 2.0, PI / (end - start));
            let (sin, cos) = (libm::sin(phase), libm::cos(phase));
            // Its length, and how that changes, first and second.
            [short + half * (1.0 - cos), half * sin * quick, half * cos * quick * quick]
        };
        // The angle and its rate: across the arm a particle feels the moment, and the arm's change turns it.
        let slope = |time: f64, state: &[f64; 2]| {
            let [radius, drawn, _] = arm(time);
            [state[1], (moment(time) / (mass * radius) - 2.0 * drawn * state[1]) / radius]
        };
        // In the plane of the circle: the arm and the moment act.
        let look = |time: f64, state: &[f64; 2]| {
            let [radius, drawn, jerked] = arm(time);
            let [angle, rate] = *state;
            let across = moment(time) / radius;
            let along = mass * (jerked - radius * rate * rate);
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let turned = |out: f64, round: f64| vec![out * cos - round * sin, out * sin + round * cos];
            Look {
                bodies: vec![Seen { mass, place: turned(radius, 0.0), velocity: turned(drawn, radius * rate) }],
                outside: turned(along, across),
                power: along * drawn + across * radius * rate,
                ..Look::default()
            }
        };
        let integrator = self.integrator((end - start) / 32.0);
        let (mut time, mut state) = (start, [0.0, before / short]);
        for next in changes.into_iter().filter(|change| *change > start && *change < end).chain([end]) {
            let held = |at: f64, state: &[f64; 2]| slope(if at >= next { next.next_down() } else { at }, state);
            let (names, components, start) = (&[body], plane(false), (time, state));
            self.film(&Motion { names, components, start, end: next, slope: &held, look: &look })?;
            (state, time) = (integrator.until(time, state, next, &held)?, next);
        }
        let [angle, rate] = state;
        let first = self.values.index + 1;
        for (instant, radius, drawn, angle, rate) in
            [(first, short, 0.0, 0.0, before / short), (first + 1, long, arm(time)[1], angle, rate)]
        {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let place = [radius * cos, radius * sin];
            let velocity = [drawn * cos - radius * rate * sin, drawn * sin + radius * rate * cos];
            let moment = place[0] * velocity[1] - place[1] * velocity[0];
            if self.values.mass(body).is_ok() {
                self.note(&format!("H_{}{instant}", stage.about), mass * moment, 0.0);
            }
            self.note(&format!("omega_{body}{instant}"), rate, 0.0);
            self.note(&format!("a_{body}{instant}.n"), radius * rate * rate, 0.0);
        }
        self.note(&self.values.start_name(body, axis), before, 0.0);
        self.note_velocity(body, unit(axis).map(|own| own * long * rate), before);
        Ok(())
    }
}
