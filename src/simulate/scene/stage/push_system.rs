//! Known forces on several bodies at the same time: each body by itself, then all of them together.

use momentous_scene::stage::Push;

use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::velocity;
use crate::scene::stage_run::StageRun;
use crate::scene::vector::{ZERO, add, part, size, times};

impl StageRun<'_> {
    pub(super) fn push_system(&mut self, stage: &Push) -> Result<(), NothingToSimulate> {
        let rated = self.note_rates(stage)?;
        let mut total = Some((ZERO, 0.0));
        for body in stage.pushed() {
            let impulse = self.push_freely(stage, body, rated)?;
            total = total.zip(impulse).map(|((all, scale), part)| (add(all, part), scale + size(part)));
        }
        if let Some((total, scale)) = total {
            self.note_vector_of("J", total, scale);
        }
        let (scene, index) = (self.values.scene, self.values.index);
        let first = usize::from(stage.pushed().any(|body| scene.follows_a_force(index, body)));
        // How long the forces act may be left open.
        let ends = self.during(stage.during.as_ref()).map_or_else(|_| vec![0.0], |ends| ends.to_vec());
        for (instant, time) in (index + 1..).zip(ends).skip(first) {
            self.note_system_at(stage, instant, time)?;
        }
        Ok(())
    }

    /// Notes how fast the momentum of the system changes at an instant, and the acceleration of its centre of mass.
    fn note_system_at(&mut self, stage: &Push, instant: usize, time: f64) -> Result<(), NothingToSimulate> {
        let (mut rate, mut scale) = (ZERO, 0.0);
        for body in stage.pushed() {
            let system = self.pulled(stage, body, ZERO, ZERO)?;
            let rate_of_body = times(self.values.mass(body)?, velocity(&system.slope(time, &system.state()), 0));
            (rate, scale) = (add(rate, rate_of_body), scale + size(rate_of_body));
        }
        let masses = self.values.scene.bodies.keys().map(|body| self.values.mass(body));
        let whole = masses.sum::<Result<f64, _>>();
        for axis in self.values.axes() {
            let (letter, along) = (self.values.letter(axis), part(rate, axis));
            self.note(&format!("p_rate_{instant}{letter}"), along, scale);
            if let Ok(whole) = whole {
                self.note(&format!("a_G{instant}{letter}"), along / whole, scale / whole);
            }
        }
        Ok(())
    }
}
