//! A slide over a floor or along a slope, against kinetic friction.

use std::sync::Arc;

use crate::scene::stage::{self, Way};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::floor::{Slide, Sliding, Slope, Until};
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::vector::{times, unit};

/// The slope of a ramp of any shape: 45°.
const RAMP: f64 = core::f64::consts::FRAC_1_SQRT_2;

impl Bench<'_> {
    pub(super) fn slide(&mut self, stage: &stage::Slide) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let body = stage.body.as_str();
        let slope = match (&stage.incline, &stage.height, stage.way) {
            (None, Some(_), Some(Way::Up)) => Slope { along: -RAMP, across: RAMP },
            (None, Some(_), _) => Slope { along: RAMP, across: RAMP },
            _ => self.values.slope(stage.incline.as_ref())?,
        };
        let sense = self.values.sense(stage.direction.as_ref(), axis)?;
        // A ramp of any shape goes up or down along the motion.
        let slope = if stage.incline.is_none() { Slope { along: slope.along * sense, ..slope } } else { slope };
        let friction = stage.friction.as_ref().map_or(Ok(0.0), |term| self.values.term(term))?;
        let gravity = if friction == 0.0 && slope.along == 0.0 { 0.0 } else { self.values.named("g")? };
        let (drive, grip) = (slope.along * gravity, friction * slope.across * gravity);
        let speed = self.values.velocity_before(body, axis)?;
        let slide = Slide {
            drive: Arc::new(move |_| drive),
            grip: Arc::new(move |_| grip),
            changes: Vec::new(),
            start: 0.0,
            speed,
            body: Some(Sliding { name: body.to_owned(), mass: self.values.any_mass(body), axis, weight: drive }),
        };
        let told = |term: &Option<crate::scene::Term>| term.as_ref().and_then(|term| self.values.term(term).ok());
        let time = told(&stage.duration).or_else(|| self.values.duration().ok());
        let way = told(&stage.distance).or_else(|| told(&stage.height).map(|height| height / slope.along.abs()));
        let until = match (stage.until, time, way) {
            (Some(_), ..) => Until::Rest,
            (None, _, Some(way)) => Until::Way(way),
            (None, Some(time), None) => Until::Time(time),
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        let slid = slide.run(self, sense, until)?;
        self.note_velocity(body, times(slid.speed, unit(axis)), speed);
        self.note_duration(stage.duration.as_ref(), slid.time);
        self.note_term(stage.distance.as_ref(), slid.way.abs(), 0.0);
        self.note_term(stage.height.as_ref(), (slid.way * slope.along).abs(), 0.0);
        if let Ok(mass) = self.values.mass(body)
            && gravity > 0.0
        {
            self.note_here(&format!("N_{body}"), mass * gravity * slope.across, 0.0);
        }
        Ok(())
    }
}
