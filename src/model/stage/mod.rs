//! Each kind of stage, turned into equations: one file each, as in the scene.

#![deny(clippy::wildcard_enum_match_arm)]

mod along_path;
mod blow;
mod blow_round;
mod bounce_heights;
mod bounces;
mod bounces_on;
mod bowl;
mod carried;
mod central;
mod conical;
mod connected;
mod described;
mod displaced;
mod drift;
mod during_push;
mod fall;
mod flight;
mod guided;
mod impact;
mod interact;
mod line;
mod moment;
mod motion;
mod orbit;
mod order;
mod parted;
mod push;
mod push_at_rest;
mod push_by_place;
mod push_changing;
mod push_guided;
mod push_motion;
mod push_quadratic;
mod push_resisted;
mod push_system;
mod resisted;
mod rotate;
mod rub;
mod separate;
mod shapes;
mod slide;
mod slide_off;
mod spring;
mod stream;
mod stream_goes_on;
mod strike;
mod surface;
mod swing;
mod taut;
mod taut_together;
mod thrust;
mod thrust_motion;
mod tow;
mod walk;
mod whole_way;
mod works;

pub(crate) use along_path::holding_pull;
pub(crate) use along_path::is_holding_pull;
pub(crate) use bounce_heights::height_of_a_bounce;
pub(crate) use bounce_heights::is_height_of_a_bounce;
pub(crate) use described::Description;
pub(crate) use described::ROTOR;
pub(crate) use described::Span;
pub(crate) use push::{Acting, Pushed};
pub(crate) use push_at_rest::Sliding;
pub(crate) use push_system::pushing;
pub(crate) use push_system::total_impulse;
pub(crate) use rotate::angular_impulse_by_name;
pub(crate) use separate::place_of_relative;

use momentous_fault::Path;
use momentous_scene::Stage;

use super::Builder;

impl Builder<'_> {
    /// Adds the equations of every stage, in order.
    pub(crate) fn stages(&mut self) {
        self.masses_by_name();
        self.inertias_by_name();
        let scene = self.scene;
        for (index, stage) in scene.stages.iter().enumerate() {
            let path = Path::root().key("scene").key("stages").index(index).key(stage.key());
            self.begins = index + 1;
            let first = self.reasons.len();
            match stage {
                Stage::Impact(stage) => self.impact(index, stage, &path),
                Stage::Push(stage) => self.push(index, stage, &path),
                Stage::Slide(stage) => self.slide(index, stage, &path),
                Stage::Spring(stage) => self.spring(index, stage, &path),
                Stage::Swing(stage) => self.swing(index, stage, &path),
                Stage::Taut(stage) => self.taut(index, stage, &path),
                Stage::Connected(stage) => self.connected(index, stage, &path),
                Stage::Tow(stage) => self.tow(index, stage, &path),
                Stage::Blow(stage) => self.blow(index, stage, &path),
                Stage::Rotate(stage) => self.rotate(index, stage, &path),
                Stage::Moment(stage) => self.moment(index, stage, &path),
                Stage::Strike(stage) => self.strike(index, stage, &path),
                Stage::Conical(stage) => self.conical(index, stage, &path),
                Stage::Bowl(stage) => self.bowl(index, stage, &path),
                Stage::Interact(stage) => self.interact(index, stage, &path),
                Stage::Central(stage) => self.central(index, stage, &path),
                Stage::Fall(stage) => self.fall(index, stage, &path),
                Stage::Bounces(stage) => self.bounces(index, stage, &path),
                Stage::Stream(stage) => self.stream(index, stage, &path),
                Stage::Thrust(stage) => self.thrust(index, stage, &path),
                Stage::Drift(stage) => self.drift(index, stage, &path),
                Stage::Flight(stage) => self.flight(index, stage, &path),
                Stage::Motion(stage) => self.motion(index, stage, &path),
                Stage::SlideOff(stage) => self.slide_off(index, stage, &path),
                Stage::Walk(stage) => self.walk(index, stage, &path),
                Stage::Separate(stage) => self.separate(index, stage, &path),
            }
            self.leaves_others_unheld(index, stage);
            self.strings_hold(index, stage);
            self.order_on_the_line(index);
            self.stays_parted(index);
            self.reasons_of_stages.push(first..self.reasons.len());
        }
    }
}
