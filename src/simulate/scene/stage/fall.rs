//! A fall from a height.

use momentous_scene::stage::Fall;

use crate::scene::course::Until;
use crate::scene::integrate::End;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{dot, less, part, size, times, unit};

impl StageRun<'_> {
    pub(super) fn fall(&mut self, stage: &Fall) -> Result<(), NothingToSimulate> {
        let height = self.values.term(&stage.height)?;
        for axis in self.values.axes() {
            let falls = times(self.values.sinking(&stage.body, axis)?, unit(axis));
            let name = self.values.velocity_after(&stage.body, axis);
            let before = self.values.velocity_before(&stage.body, axis);
            if part(falls, axis) == 0.0 {
                // Across the fall nothing changes, so that it need not be known.
                if let Ok(before) = before {
                    self.note(&name, before, 0.0);
                }
                continue;
            }
            let body = Particle { falls, ..Particle::free(&stage.body, 1.0, times(before?, unit(axis))) };
            // Across the fall it is not followed.
            let end = if self.values.axes().len() > 1 {
                self.unwatched(|bench| bench.fall_through(body, height))?
            } else {
                self.fall_through(body, height)?
            };
            let fallen = velocity(&end.state, 0);
            self.note_place_along(&stage.body, axis, height * part(falls, axis).signum(), height);
            self.note(&name, part(fallen, axis), 0.0);
            if let (Ok(mass), Ok(before)) =
                (self.values.mass(&stage.body), self.values.velocity_before(&stage.body, axis))
            {
                self.note_impulse(&stage.body, times(mass, less(fallen, times(before, unit(axis)))), None);
            }
            self.note_duration(None, end.time);
        }
        Ok(())
    }

    /// A particle that falls through a height.
    pub(super) fn fall_through(&mut self, body: Particle<'_>, height: f64) -> Result<End<6>, NothingToSimulate> {
        let (speed, gravity) = (size(body.velocity), size(body.falls));
        let down = times(1.0 / gravity, body.falls);
        let high = Particle { place: times(-height, down), ..body };
        let system = System::<6>::new(self.values.frame(), vec![high]);
        let integrator = self.integrator(height / (speed + libm::sqrt(height * gravity)));
        self.go(&system, integrator, &Until::Event(&|state| -dot(down, place(state, 0))))
    }
}
