//! Simulators of each kind of stage: one file each, as in the scene. Whatever else the room asks of a kind of stage is answered
//! here as well.

mod blow;
mod bounces;
mod bowl;
#[cfg(test)]
mod by_hand;
mod carried;
mod central;
mod conical;
mod connected;
mod fall;
mod flight;
mod flight_resisted;
mod impact;
mod interact;
mod moment;
mod motion;
mod push;
mod push_by_place;
mod push_changing;
mod push_system;
mod rates;
mod rotate;
mod rub;
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

use momentous_scene::Stage;

use super::Staged;
use super::nothing::NothingToSimulate;
use super::stage_run::StageRun;
use super::values::Values;

impl StageRun<'_> {
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

impl Values<'_> {
    /// A stage for the numerical methods.
    pub(super) fn translated(&self, stage: &Stage) -> Result<Staged, NothingToSimulate> {
        match stage {
            Stage::Impact(impact) => self.impact(impact),
            Stage::Push(push) => self.push(push),
            Stage::Fall(fall) => self.fall(fall),
            Stage::Flight(flight) => self.flight(flight),
            Stage::Bounces(bounces) => self.bounces(bounces),
            Stage::Drift(_) | Stage::Walk(_) | Stage::Stream(_) => Err(NothingToSimulate::NothingChanges),
            Stage::Blow(_) => Err(NothingToSimulate::UnknownHistory),
            Stage::Slide(_)
            | Stage::Spring(_)
            | Stage::Swing(_)
            | Stage::Taut(_)
            | Stage::Connected(_)
            | Stage::Tow(_)
            | Stage::Rotate(_)
            | Stage::Moment(_)
            | Stage::Strike(_)
            | Stage::Conical(_)
            | Stage::Bowl(_)
            | Stage::Interact(_)
            | Stage::Central(_)
            | Stage::Thrust(_)
            | Stage::Separate(_)
            | Stage::SlideOff(_)
            | Stage::Motion(_) => Err(NothingToSimulate::NoMethod),
        }
    }
}

/// The body that was, before a stage, where a body is after it; none where the stage moves it.
pub(super) fn same_place<'a>(stage: &'a Stage, body: &'a str) -> Option<&'a str> {
    match stage {
        Stage::Impact(impact) => match (&impact.becomes, &impact.between) {
            (Some(union), Some([first, _])) if union == body => Some(first),
            _ => Some(body),
        },
        Stage::Separate(separate) => {
            let whole = separate.from.as_deref().filter(|_| separate.into.iter().any(|part| part == body));
            Some(whole.unwrap_or(body)).filter(|_| !separate.lasts())
        }
        Stage::Blow(_) | Stage::Stream(_) | Stage::Strike(_) => Some(body),
        Stage::Flight(flight) => flight.flying().all(|other| other != body).then_some(body),
        Stage::Fall(fall) => (fall.body != body).then_some(body),
        Stage::Push(_)
        | Stage::Slide(_)
        | Stage::Spring(_)
        | Stage::Swing(_)
        | Stage::Taut(_)
        | Stage::Connected(_)
        | Stage::Tow(_)
        | Stage::Rotate(_)
        | Stage::Moment(_)
        | Stage::Conical(_)
        | Stage::Bowl(_)
        | Stage::Interact(_)
        | Stage::Central(_)
        | Stage::Bounces(_)
        | Stage::Thrust(_)
        | Stage::Drift(_)
        | Stage::SlideOff(_)
        | Stage::Walk(_)
        | Stage::Motion(_) => None,
    }
}
