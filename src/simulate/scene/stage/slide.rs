//! A slide over a floor or along a slope, against kinetic friction.

use momentous_scene::stage::{Slide, UpOrDown};

use crate::scene::floor::Slope;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{dot, times, unit};

/// The slope of a ramp of any shape: 45°.
const RAMP: f64 = core::f64::consts::FRAC_1_SQRT_2;

impl StageRun<'_> {
    pub(super) fn slide(&mut self, stage: &Slide) -> Result<(), NothingToSimulate> {
        if let Some(on) = &stage.on {
            return self.slide_on(stage, on);
        }
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let body = stage.body.as_str();
        let slope = match (&stage.incline, &stage.height, stage.way) {
            (None, Some(_), Some(UpOrDown::Up)) => Slope { along: -RAMP, across: RAMP },
            (None, Some(_), _) => Slope { along: RAMP, across: RAMP },
            _ => self.values.slope(stage.incline.as_ref())?,
        };
        let sense = self.values.sense(stage.direction.as_ref(), axis)?;
        // A ramp of any shape goes up or down along the motion.
        let slope = if stage.incline.is_none() { Slope { along: slope.along * sense, ..slope } } else { slope };
        let friction = self.values.or_zero(stage.friction.as_ref())?;
        let gravity = if friction == 0.0 && slope.along == 0.0 { 0.0 } else { self.values.named("g")? };
        let (speed, mass) = (self.values.velocity_before(body, axis)?, self.values.any_mass(body));
        let ahead = times(if speed == 0.0 { sense } else { speed.signum() }, unit(axis));
        let falls = times(slope.along * gravity, unit(axis));
        let slides = Particle { falls, ..Particle::free(body, mass, times(speed, unit(axis))) };
        let grip = Force::steady(0, times(-mass * friction * slope.across * gravity, ahead));
        let system = System::<6> { forces: vec![grip], ..System::new(self.values.frame(), vec![slides]) };
        let climbs = self.values.known(stage.height.as_ref()).map(|height| height / slope.along.abs());
        let way = self.values.known(stage.distance.as_ref()).or(climbs);
        let finish = self.values.finish(stage.until.is_some(), way, stage.duration.as_ref())?;
        let end = self.go_along(&system, (0, ahead), finish)?;
        let way = dot(ahead, place(&end.state, 0)).abs();
        self.note_velocity(body, velocity(&end.state, 0), speed);
        if stage.incline.is_some() || stage.height.is_none() {
            self.note_place(body, place(&end.state, 0));
        }
        self.note_duration(stage.duration.as_ref(), end.time);
        self.note_term(stage.distance.as_ref(), way, 0.0);
        self.note_term(stage.height.as_ref(), (way * slope.along).abs(), 0.0);
        if let Ok(mass) = self.values.mass(body)
            && gravity > 0.0
        {
            self.note_here(&format!("N_{body}"), mass * gravity * slope.across, 0.0);
        }
        Ok(())
    }
}
