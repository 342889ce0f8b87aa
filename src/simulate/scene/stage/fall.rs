//! A fall from a height.

use crate::scene::Axis;
use crate::scene::stage::Fall;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::vector::{Vector, part, times, unit};

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
}
