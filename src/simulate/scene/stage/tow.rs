//! Two bodies in a row, with a coupling between them.

use momentous_scene::stage::Tow;

use crate::scene::floor::Slope;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{dot, size, times, unit};

impl StageRun<'_> {
    pub(super) fn tow(&mut self, stage: &Tow) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        let along = unit(axis);
        let slope = match &stage.incline {
            Some(_) => self.values.slope(stage.incline.as_ref())?,
            None => match self.values.gravity(axis)? {
                0.0 => Slope { along: 0.0, across: 1.0 },
                falls => Slope { along: falls.signum(), across: 0.0 },
            },
        };
        let bodies = stage.both().map(|towed| towed.body.as_str());
        let start = bodies.iter().find_map(|body| self.values.velocity_before(body, axis).ok());
        let start = start.ok_or(NothingToSimulate::ValueMissing)?;
        let mut system = System::<12>::new(self.values.frame(), Vec::new());
        let mut scale = 0.0;
        for (side, towed) in stage.both().into_iter().enumerate() {
            let (mass, gravity) = (self.values.mass(&towed.body)?, self.values.named("g"));
            // Weight need not be known where it has no part in anything.
            let weight = |share: f64| if share == 0.0 { Ok(0.0) } else { Ok(share * mass * gravity?) };
            let friction = weight(self.values.or_zero(towed.friction.as_ref())? * slope.across)?;
            let driven = self.values.or_zero(towed.force.as_ref())? - friction;
            let falls = times(weight(slope.along)? / mass, along);
            system.particles.push(Particle { falls, ..Particle::free(&towed.body, mass, times(start, along)) });
            system.forces.push(Force::steady(side, times(driven, along)));
            scale += (mass * size(falls)).abs() + driven.abs();
        }
        system.constraint = Some(Constraint::Length(vec![(0, times(-1.0, along)), (1, along)]));
        let distance = self.values.known(stage.distance.as_ref());
        let finish = self.values.finish(stage.until.is_some(), distance, stage.duration.as_ref())?;
        let end = self.go_along(&system, (0, along), finish)?;
        self.remark("Each position is measured from the starting point of its body.");
        for (side, body) in bodies.into_iter().enumerate() {
            self.note_velocity(body, velocity(&end.state, side), start);
            self.note_place(body, place(&end.state, side));
        }
        self.note_here("tension", system.tension(end.time, &end.state), scale);
        self.note_term(stage.distance.as_ref(), dot(place(&end.state, 0), along), 0.0);
        self.note_duration(stage.duration.as_ref(), end.time);
        Ok(())
    }
}
