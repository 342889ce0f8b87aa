//! The kinds of stage, one file each: what can happen between two instants.

#![deny(clippy::wildcard_enum_match_arm)]

mod blow;
mod bounces;
mod bowl;
mod central;
mod conical;
mod connected;
mod drift;
mod fall;
mod flight;
mod impact;
mod included;
mod interact;
mod mass_change;
mod moment;
mod motion;
mod push;
mod resistance;
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
mod until;
mod walk;

pub use blow::Blow;
pub use bounces::Bounces;
pub use bowl::{Bowl, Horizontal};
pub use central::{Central, CentralSpring, Orbit};
pub use conical::Conical;
pub use connected::{Connected, MOST_STRANDS, Strand};
pub use drift::Drift;
pub use fall::Fall;
pub use flight::Flight;
pub use impact::{Impact, Partners};
pub use included::Included;
pub use interact::{Interact, UntilTogether};
pub use mass_change::{ChangeOfMass, Gain, Loss, MassChange, StageMass};
pub use moment::Moment;
pub use motion::{Course, Motion};
pub use push::{During, Push, ToldBy};
pub use resistance::Resistance;
pub use rotate::{AlongPath, Arm, Rotate};
pub use separate::{Relative, Separate, When};
pub use slide::Slide;
pub use slide_off::SlideOff;
pub use spring::{Ends, Spring};
pub use stream::Stream;
pub use strike::Strike;
pub use swing::{Place, Swing, UpOrDown};
pub use taut::{JerkedString, Taut};
pub use thrust::{BurningMass, Exhaust, Jet, Thrust};
pub use tow::{Tow, Towed};
pub use until::{Halt, Until};
pub use walk::Walk;

use schemars::JsonSchema;
use serde::Deserialize;

/// What happens between one instant and the next.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Two bodies collide, or one strikes a surface.
    Impact(Impact),
    /// Forces of known law act on a body for a time.
    Push(Push),
    /// A body slides over a floor or along a slope.
    Slide(Slide),
    /// A spring acts on a body, or between two bodies.
    Spring(Spring),
    /// A body swings on a cord.
    Swing(Swing),
    /// A string between two bodies goes taut.
    Taut(Taut),
    /// Two bodies move on the ends of a taut string over a pulley.
    Connected(Connected),
    /// Two bodies in a row move together while forces act.
    Tow(Tow),
    /// A blow of unknown history: only its impulse, or its average force and duration, is considered.
    Blow(Blow),
    /// Particles are held on an arm about a fixed point, and a moment acts.
    Rotate(Rotate),
    /// A moment acts on all bodies, about a fixed point or the centre of mass.
    Moment(Moment),
    /// A body strikes an arm that carries particles.
    Strike(Strike),
    /// A body on a cord moves round a horizontal circle while the cord is drawn in.
    Conical(Conical),
    /// A body slides inside a smooth cone or bowl.
    Bowl(Bowl),
    /// Bodies act on each other only.
    Interact(Interact),
    /// A particle moves under a force that always points to a fixed point.
    Central(Central),
    /// A body falls freely through a height.
    Fall(Fall),
    /// A body bounces on a floor, again and again.
    Bounces(Bounces),
    /// A steady stream meets a body.
    Stream(Stream),
    /// A body is driven by mass that it throws away.
    Thrust(Thrust),
    /// Nothing acts: the bodies go on evenly, for a time or until something holds.
    Drift(Drift),
    /// A body comes apart: an explosion, a recoil, a jump, a shot.
    Separate(Separate),
    /// A body slides down another, which is free to move.
    #[serde(rename = "slide_off")]
    SlideOff(SlideOff),
    /// A body walks along another, which is free to move.
    Walk(Walk),
    /// Bodies move freely until something is so.
    Flight(Flight),
    /// A body moves as a function of time or place says.
    Motion(Motion),
}

impl Stage {
    /// The body that consists of others after it or before it, and these others.
    #[must_use]
    pub fn whole_and_parts(&self) -> Option<(&str, &[String])> {
        if let Self::Impact(Impact { becomes: Some(whole), between: Some(parts), .. }) = self {
            return Some((whole, parts));
        }
        if let Self::Separate(Separate { from: Some(whole), into, .. }) = self { Some((whole, into)) } else { None }
    }

    /// How it changes the mass of a body, if it does.
    pub(super) fn change_of_mass(&self, body: &str) -> Option<ChangeOfMass<'_>> {
        if let Self::Push(push) = self {
            let changes = push.mass_change().is_some() && push.pushed().any(|pushed| pushed == body);
            return changes.then_some(ChangeOfMass::Steady);
        }
        if let Self::Thrust(Thrust { body: burning, mass, .. }) = self
            && burning == body
        {
            return Some(ChangeOfMass::Burn(mass));
        }
        None
    }

    /// The body that rises or sinks on another one which gives way, and that one.
    #[must_use]
    pub fn carried(&self) -> Option<[&str; 2]> {
        if let Self::Slide(Slide { body, on: Some(on), .. }) | Self::Swing(Swing { body, on: Some(on), .. }) = self {
            return Some([body, on]);
        }
        None
    }

    /// Whether a body and the one which carries it move together at the end.
    #[must_use]
    pub fn ends_together(&self) -> bool {
        let swings_up = |swing: &Swing| swing.on.is_some() && swing.stops();
        matches!(self, Self::Slide(Slide { until: Some(Halt::Together), .. }))
            || matches!(self, Self::Swing(swing) if swings_up(swing))
    }

    /// The key that introduces the stage in a problem file.
    #[must_use]
    pub fn key(&self) -> &'static str {
        match self {
            Self::Impact(_) => "impact",
            Self::Push(_) => "push",
            Self::Slide(_) => "slide",
            Self::Spring(_) => "spring",
            Self::Swing(_) => "swing",
            Self::Taut(_) => "taut",
            Self::Connected(_) => "connected",
            Self::Tow(_) => "tow",
            Self::Blow(_) => "blow",
            Self::Rotate(_) => "rotate",
            Self::Moment(_) => "moment",
            Self::Strike(_) => "strike",
            Self::Conical(_) => "conical",
            Self::Bowl(_) => "bowl",
            Self::Interact(_) => "interact",
            Self::Central(_) => "central",
            Self::Fall(_) => "fall",
            Self::Bounces(_) => "bounces",
            Self::Stream(_) => "stream",
            Self::Thrust(_) => "thrust",
            Self::Drift(_) => "drift",
            Self::Separate(_) => "separate",
            Self::SlideOff(_) => "slide_off",
            Self::Walk(_) => "walk",
            Self::Flight(_) => "flight",
            Self::Motion(_) => "motion",
        }
    }

    /// Whether time passes in it: where none does, clocks and places stay as they were.
    #[must_use]
    pub fn takes_time(&self) -> bool {
        match self {
            Self::Impact(_) | Self::Blow(_) | Self::Strike(_) | Self::Taut(_) => false,
            Self::Separate(stage) => stage.lasts(),
            Self::Push(_)
            | Self::Slide(_)
            | Self::Spring(_)
            | Self::Swing(_)
            | Self::Connected(_)
            | Self::Tow(_)
            | Self::Rotate(_)
            | Self::Moment(_)
            | Self::Conical(_)
            | Self::Bowl(_)
            | Self::Interact(_)
            | Self::Central(_)
            | Self::Fall(_)
            | Self::Bounces(_)
            | Self::Stream(_)
            | Self::Thrust(_)
            | Self::Drift(_)
            | Self::SlideOff(_)
            | Self::Walk(_)
            | Self::Flight(_)
            | Self::Motion(_) => true,
        }
    }

    /// The name that the author gave the stage, used in brackets: `J_A[hit]`.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        let name = match self {
            Self::Impact(stage) => &stage.name,
            Self::Push(stage) => &stage.name,
            Self::Slide(stage) => &stage.name,
            Self::Spring(stage) => &stage.name,
            Self::Swing(stage) => &stage.name,
            Self::Taut(stage) => &stage.name,
            Self::Connected(stage) => &stage.name,
            Self::Tow(stage) => &stage.name,
            Self::Blow(stage) => &stage.name,
            Self::Rotate(stage) => &stage.name,
            Self::Moment(stage) => &stage.name,
            Self::Strike(stage) => &stage.name,
            Self::Conical(stage) => &stage.name,
            Self::Bowl(stage) => &stage.name,
            Self::Interact(stage) => &stage.name,
            Self::Central(stage) => &stage.name,
            Self::Fall(stage) => &stage.name,
            Self::Bounces(stage) => &stage.name,
            Self::Stream(stage) => &stage.name,
            Self::Thrust(stage) => &stage.name,
            Self::Drift(stage) => &stage.name,
            Self::Separate(stage) => &stage.name,
            Self::SlideOff(stage) => &stage.name,
            Self::Walk(stage) => &stage.name,
            Self::Flight(stage) => &stage.name,
            Self::Motion(stage) => &stage.name,
        };
        name.as_deref()
    }
}
