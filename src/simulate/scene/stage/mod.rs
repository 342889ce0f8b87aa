//! What simulates each kind of stage: one file each, as in the scene.

mod blow;
mod bounces;
mod bowl;
#[cfg(test)]
mod by_hand;
mod central;
mod conical;
mod connected;
mod fall;
mod flight;
mod impact;
mod interact;
mod moment;
mod motion;
mod push;
mod push_by_place;
mod rates;
mod rotate;
mod separate;
mod slide;
mod slide_off;
mod spring;
mod stream;
mod strike;
mod swing;
mod taut;
mod thrust;
mod tow;
mod walk;

use crate::scene::Stage;

use super::bench::Bench;
use super::nothing::NothingToSimulate;

impl Bench<'_> {
    /// Simulates a stage, whatever its kind.
    pub(super) fn stage(&mut self, stage: &Stage) -> Result<(), NothingToSimulate> {
        match stage {
            Stage::Impact(stage) => self.impact(stage),
            Stage::Push(stage) => self.push(stage),
            Stage::Slide(stage) => self.slide(stage),
            Stage::Spring(stage) => self.spring(stage),
            Stage::Swing(stage) => self.swing(stage),
            Stage::Taut(stage) => self.taut(stage),
            Stage::Connected(stage) => self.connected(stage),
            Stage::Blow(stage) => self.blow(stage),
            Stage::Rotate(stage) => self.rotate(stage),
            Stage::Central(stage) => self.central(stage),
            Stage::Moment(stage) => self.moment(stage),
            Stage::Strike(stage) => self.strike(stage),
            Stage::Conical(stage) => self.conical(stage),
            Stage::Bowl(stage) => self.bowl(stage),
            Stage::Interact(stage) => self.interact(stage),
            Stage::Fall(stage) => self.fall(stage),
            Stage::Bounces(stage) => self.bounces(stage),
            Stage::Stream(stage) => self.stream(stage),
            Stage::Thrust(stage) => self.thrust(stage),
            Stage::Tow(stage) => self.tow(stage),
            Stage::Drift(stage) => self.drift(stage),
            Stage::Separate(stage) => self.separate(stage),
            Stage::SlideOff(stage) => self.slide_off(stage),
            Stage::Walk(stage) => self.walk(stage),
            Stage::Flight(stage) => self.flight(stage),
            Stage::Motion(stage) => self.motion(stage),
        }
    }
}
