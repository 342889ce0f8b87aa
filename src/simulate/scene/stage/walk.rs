//! A walk on something that is free to move: the feet push the body forwards and what it walks on backwards, then the reverse.

use momentous_scene::stage::Walk;

use crate::scene::course::Until;
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{ZERO, dot, times};

impl StageRun<'_> {
    pub(super) fn walk(&mut self, stage: &Walk) -> Result<(), NothingToSimulate> {
        let names = [stage.body.as_str(), stage.on.as_str()];
        let distance = self.values.term(&stage.distance)?;
        let along = self.values.towards(None)?;
        let mut particles = Vec::new();
        for name in names {
            particles.push(Particle::free(name, self.values.mass(name)?, ZERO));
        }
        // One step a second.
        let steps = |strength: f64| {
            let lines = vec![(0, along), (1, times(-1.0, along))];
            let push = Force::in_time(lines, InTime::waves(strength, 2.0, 1.0));
            System::<12> { forces: vec![push], ..System::new(self.values.frame(), particles.clone()) }
        };
        let (once, with_a_newton) = (&Until::Time(1.0), steps(1.0));
        let integrator = self.integrator(0.1);
        // How far a push of 1 N leads says how strong it has to be.
        let tried = self.try_out(&with_a_newton, integrator, once)?.state;
        let apart = dot(along, place(&tried, 0)) - dot(along, place(&tried, 1));
        let end = self.go(&steps(distance / apart), integrator, once)?.state;
        self.remark(
            "The duration is not given: one second is assumed. Each position is measured from the starting point of its body.",
        );
        let [ahead, back] = [0, 1].map(|side| dot(along, place(&end, side)));
        for (name, way) in names.into_iter().zip([ahead, back]) {
            self.note_here(&format!("s_{name}"), way, 0.0);
            self.note_place(name, times(way, along));
        }
        self.note_term(Some(&stage.distance), ahead - back, 0.0);
        Ok(())
    }
}
