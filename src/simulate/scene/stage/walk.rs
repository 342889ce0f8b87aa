//! A walk on something that is free to move: the feet push the body forwards and what it walks on backwards, then the reverse.

use crate::scene::stage::Walk;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;

use core::f64::consts::TAU;

impl Bench<'_> {
    pub(super) fn walk(&mut self, stage: &Walk) -> Result<(), NothingToSimulate> {
        let masses = [self.values.mass(&stage.body)?, self.values.mass(&stage.on)?];
        let distance = self.values.term(&stage.distance)?;
        // One step a second, with a push of 1 N; how far that leads says how strong the pushes have to be.
        let tried = self.walked(masses, 1.0)?;
        let [ahead, back] = self.walked(masses, distance / (tried[0] - tried[1]))?;
        self.note_here(&format!("s_{}", stage.body), ahead, 0.0);
        self.note_here(&format!("s_{}", stage.on), back, 0.0);
        self.note_term(Some(&stage.distance), ahead - back, 0.0);
        Ok(())
    }

    /// Where both are after a walk from rest to rest, with pushes so strong.
    fn walked(&mut self, masses: [f64; 2], strength: f64) -> Result<[f64; 2], NothingToSimulate> {
        let integrator = self.integrator(0.1);
        let end = integrator.until(0.0, [0.0; 4], 1.0, &|time, state| {
            let push = strength * libm::sin(TAU * time);
            [state[1], push / masses[0], state[3], -push / masses[1]]
        })?;
        Ok([end[0], end[2]])
    }
}
