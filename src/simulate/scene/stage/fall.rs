//! A fall from a height, and the bounces that follow it.

use crate::scene::stage::{Bounces, Fall};
use crate::scene::{Axis, Stage};

use crate::simulate::scene::bench::{Bench, Way};
use crate::simulate::scene::integrate::Integrator;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::vector::{Vector, part, times, unit};

/// The share of the first height below which a bounce adds nothing.
const NOTHING: f64 = 1e-14;

/// Bounces after which a path is given up.
const MOST_BOUNCES: u32 = 2_000;

impl Bench<'_> {
    pub(super) fn fall(&mut self, stage: &Fall) -> Result<(), NothingToSimulate> {
        let height = self.values.term(&stage.height)?;
        for axis in self.values.axes() {
            let down = self.values.gravity(axis)?;
            let before = self.values.velocity_before(&stage.body, axis).or_else(|missing| {
                // Across the fall nothing changes, so that it need not be known.
                if down == 0.0 { Ok(0.0) } else { Err(missing) }
            })?;
            if down == 0.0 {
                self.note(&self.values.velocity_after(&stage.body, axis), before, 0.0);
                continue;
            }
            let typical = height / (before.abs() + libm::sqrt(height * down.abs()));
            let integrator = self.integrator(typical);
            let state = [height, before * down.signum()];
            let slope = |_: f64, state: &[f64; 2]| [-state[1], down.abs()];
            let (time, state) = integrator.event(0.0, state, &slope, &|_, state| state[0])?;
            let velocity = times(state[1] * down.signum(), unit(axis));
            self.note_velocity_along(&stage.body, axis, velocity);
            self.note_duration(None, time);
        }
        Ok(())
    }

    fn note_velocity_along(&mut self, body: &str, axis: Axis, velocity: Vector) {
        self.note(&self.values.velocity_after(body, axis), part(velocity, axis), 0.0);
    }

    pub(super) fn bounces(&mut self, stage: &Bounces) -> Result<(), NothingToSimulate> {
        self.take(&self.values.bounces(stage)?)?;
        self.by(Way::Integrated);
        let before = self.values.index.checked_sub(1).and_then(|before| self.values.scene.stages.get(before));
        let height = match before {
            Some(Stage::Fall(fall)) if fall.body == stage.body => self.values.term(&fall.height)?,
            _ => self.values.named("h_0")?,
        };
        let count = stage.count.as_ref().map(|term| self.values.term(term)).transpose()?;
        let (gravity, e) = (self.values.named("g")?, self.values.term(&stage.restitution)?);
        let mut path = height;
        let mut rise = height;
        for bounce in 1..=MOST_BOUNCES {
            rise = self.bounce(rise, gravity, e)?;
            path += 2.0 * rise;
            if count.is_some_and(|count| (count - f64::from(bounce)).abs() < 0.5) {
                self.note("h_n", rise, 0.0);
            }
            if rise <= NOTHING * height {
                self.note("path_total", path, 0.0);
                return Ok(());
            }
        }
        Ok(())
    }

    /// From one height to the floor, and up to the next.
    fn bounce(&self, from: f64, gravity: f64, e: f64) -> Result<f64, NothingToSimulate> {
        let integrator = Integrator { tolerance: self.tolerance, longest: 8.0 * libm::sqrt(from / gravity) };
        let slope = |_: f64, state: &[f64; 2]| [state[1], -gravity];
        let (time, down) = integrator.event(0.0, [from, 0.0], &slope, &|_, state| state[0])?;
        let (_, top) = integrator.event(time, [0.0, -e * down[1]], &slope, &|_, state| state[1])?;
        Ok(top[0])
    }
}
