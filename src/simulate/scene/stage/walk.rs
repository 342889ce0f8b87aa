//! A walk on something that is free to move: the feet push the body forwards and what it walks on backwards, then the reverse.

use crate::scene::Axis;
use crate::scene::stage::Walk;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{times, unit};

use core::f64::consts::TAU;

impl Bench<'_> {
    pub(super) fn walk(&mut self, stage: &Walk) -> Result<(), NothingToSimulate> {
        let masses = [self.values.mass(&stage.body)?, self.values.mass(&stage.on)?];
        let distance = self.values.term(&stage.distance)?;
        // One step a second, with a push of 1 N; how far that leads says how strong the pushes have to be.
        let tried = self.walked(masses, 1.0)?;
        let strength = distance / (tried[0] - tried[1]);
        let [ahead, back] = self.walked(masses, strength)?;
        self.film_walk([&stage.body, &stage.on], masses, strength)?;
        self.note_here(&format!("s_{}", stage.body), ahead, 0.0);
        self.note_here(&format!("s_{}", stage.on), back, 0.0);
        self.note_term(Some(&stage.distance), ahead - back, 0.0);
        Ok(())
    }

    /// Where both are after a walk from rest to rest, with pushes so strong.
    fn walked(&mut self, masses: [f64; 2], strength: f64) -> Result<[f64; 2], NothingToSimulate> {
        let integrator = self.integrator(0.1);
        let end = integrator.until(0.0, [0.0; 4], 1.0, &|time, state| pushed(masses, strength, time, state))?;
        Ok([end[0], end[2]])
    }

    fn film_walk(&mut self, names: [&str; 2], masses: [f64; 2], strength: f64) -> Result<(), NothingToSimulate> {
        let slope = |time: f64, state: &[f64; 4]| pushed(masses, strength, time, state);
        let along = self.values.axes().first().map_or(unit(Axis::X), |axis| unit(*axis));
        let split = |value: f64| self.values.split(times(value, along));
        let look = |time: f64, state: &[f64; 4]| Look {
            bodies: (0..2)
                .map(|body| Seen {
                    mass: masses[body],
                    place: split(state[2 * body]),
                    velocity: split(state[2 * body + 1]),
                })
                .collect(),
            power: strength * libm::sin(TAU * time) * (state[1] - state[3]),
            ..Look::default()
        };
        let (names, components, start) = (&names, self.values.components(), (0.0, [0.0; 4]));
        self.film(&Motion { names, components, start, end: 1.0, slope: &slope, look: &look })?;
        self.remark(
            "The duration is not given: one second is assumed. Each position is measured from the starting point of its body.",
        );
        Ok(())
    }
}

/// Places and velocities of both under a push that comes and goes back within a second.
fn pushed(masses: [f64; 2], strength: f64, time: f64, state: &[f64; 4]) -> [f64; 4] {
    let push = strength * libm::sin(TAU * time);
    [state[1], push / masses[0], state[3], -push / masses[1]]
}
