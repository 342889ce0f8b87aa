//! The figure on a problem sheet: the bodies, and nothing but what is given.

mod angle;
mod bowl;
mod carried;
mod central;
mod conical;
mod contact;
mod dimension;
mod fall;
mod launch;
mod line;
mod moving;
mod pulley;
mod ramp;
mod ride;
mod space;
mod strung;
mod swing;
mod vane;

pub use angle::AngleMark;
pub use bowl::{Bowl, Wall};
pub use carried::{Carried, CarriedBy, CarriedEnd};
pub(super) use central::draw_centre;
pub use central::{Central, CentralPath, Moment};
pub use conical::{Across, Conical};
pub use contact::{Contact, Partner};
pub use fall::{Fall, Ground, Height};
pub use launch::{Depth, Launch, Resisted, Target};
pub use line::{Exhaust, Grains, Line, LineSpring, Tie};
pub use moving::{Moving, MovingBody};
pub(super) use moving::{Scales, draw_vector};
pub use pulley::{Pulley, PulleySide, Rest};
pub use ramp::Ramp;
pub use ride::{Face, Ride};
pub use space::Space;
pub use strung::Strung;
pub use swing::{Swing, SwingBy, SwingEnd};
pub use vane::Vane;

use super::Drawing;
use super::arm::Arm;
use super::input::{AxisMark, Wording};
use super::panels::draw_axes;
use super::place::Canvas;

/// The figure on a problem sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Situation {
    /// Title, description, caption.
    pub wording: Wording,
    /// The bodies and how they lie to each other.
    pub layout: Layout,
    /// The axes to name.
    pub axes: Vec<AxisMark>,
}

/// How the bodies lie to each other.
#[derive(Clone, Debug, PartialEq)]
pub enum Layout {
    /// Apart, along a straight line.
    Line(Line),
    /// At the moment of contact.
    Contact(Contact),
    /// One body about a fixed centre.
    Central(Central),
    /// A body that falls, and perhaps bounces.
    Fall(Fall),
    /// A body at the start of a free flight.
    Launch(Launch),
    /// A body on a cord.
    Swing(Swing),
    /// Two bodies on a string over a pulley.
    Pulley(Pulley),
    /// A body on another one that can give way.
    Ride(Ride),
    /// A body that rises or sinks on another one, which gives way.
    Carried(Carried),
    /// A body on a ramp of any shape.
    Ramp(Ramp),
    /// Particles on an arm.
    Arm(Arm),
    /// A body inside a cone or a bowl.
    Bowl(Bowl),
    /// A body on a cord that moves round a level circle.
    Conical(Conical),
    /// A body at a place in space.
    Space(Space),
    /// Bodies joined by strings.
    Strung(Strung),
    /// A jet that a vane turns.
    Vane(Vane),
}

impl Situation {
    /// The drawing.
    ///
    /// ```
    /// use momentous_expr::Math;
    /// use momentous_figure::{Layout, Line, LabelledVector, Moving, MovingBody, Situation, Wording, overlaps};
    ///
    /// let cart = |name: &str, speed| {
    ///     let velocity = LabelledVector::known(Math::subscripted("v", name), [speed, 0.0]);
    ///     MovingBody::new(Math::Identifier(name.into())).with(Moving::velocity(velocity))
    /// };
    /// let line = Line { bodies: vec![cart("A", 3.0), cart("B", -2.0)], floor: true, ..Line::default() };
    /// let situation = Situation { wording: Wording::default(), layout: Layout::Line(line), axes: Vec::new() };
    /// assert!(overlaps(&situation.drawing()).is_empty());
    /// ```
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let mut canvas = Canvas::default();
        match &self.layout {
            Layout::Line(line) => line.draw(&mut canvas),
            Layout::Contact(contact) => contact.draw(&mut canvas),
            Layout::Central(central) => central.draw(&mut canvas),
            Layout::Fall(fall) => fall.draw(&mut canvas),
            Layout::Launch(launch) => launch.draw(&mut canvas),
            Layout::Swing(swing) => swing.draw(&mut canvas),
            Layout::Pulley(pulley) => pulley.draw(&mut canvas),
            Layout::Ride(ride) => ride.draw(&mut canvas),
            Layout::Carried(carried) => carried.draw(&mut canvas),
            Layout::Ramp(ramp) => ramp.draw(&mut canvas),
            Layout::Arm(arm) => arm.draw(&mut canvas),
            Layout::Bowl(bowl) => bowl.draw(&mut canvas),
            Layout::Conical(conical) => conical.draw(&mut canvas),
            Layout::Space(space) => space.draw(&mut canvas),
            Layout::Strung(strung) => strung.draw(&mut canvas),
            Layout::Vane(vane) => vane.draw(&mut canvas),
        }
        // The axes go below everything, labels included.
        let mut canvas = canvas.settled();
        draw_axes(&mut canvas, &self.axes);
        self.wording.drawing(canvas)
    }
}
