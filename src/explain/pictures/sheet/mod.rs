//! The figure of the problem sheet, by what happens first.

pub(super) mod central;
pub(super) mod contact;
pub(super) mod fall;
pub(super) mod flight;
pub(super) mod given;
pub(super) mod line;
pub(super) mod pulley;
pub(super) mod ramp;
pub(super) mod revolution;
pub(super) mod ride;
pub(super) mod stream;
pub(super) mod swing;

use crate::figure::Drawing;
use crate::scene::Force;
use crate::scene::Stage;
use crate::scene::Strength;
use crate::scene::stage::Push;

use super::arm;
use super::compass::Compass;
use super::moment;
use super::plot;
use super::quantities::Quantities;
use super::snapshot;

/// The figure; none where nothing that is given can be drawn.
pub(super) fn drawing(quantities: &Quantities<'_>, compass: &Compass) -> Option<Drawing> {
    match quantities.scene().stages.first() {
        None | Some(Stage::Interact(_)) => snapshot::drawing(quantities, compass),
        Some(Stage::Impact(impact)) => {
            contact::drawing(quantities, compass, impact).or_else(|| line::drawing(quantities, compass, 0))
        }
        Some(Stage::Push(push)) if is_graph(push) => plot::force_plot(quantities, 0),
        Some(Stage::Push(_)) => {
            snapshot::in_space(quantities, compass).or_else(|| line::drawing(quantities, compass, 0))
        }
        Some(Stage::Slide(slide)) if slide.is_ramp() => Some(ramp::drawing(quantities, compass, 0, slide)),
        Some(Stage::Taut(taut)) if taut.over.is_some() => Some(pulley::taut(quantities, 0, taut)),
        Some(
            Stage::Slide(_)
            | Stage::Spring(_)
            | Stage::Taut(_)
            | Stage::Tow(_)
            | Stage::Blow(_)
            | Stage::Motion(_)
            | Stage::Separate(_)
            | Stage::Drift(_),
        ) => line::drawing(quantities, compass, 0),
        Some(Stage::Flight(flight)) => {
            flight::drawing(quantities, compass, flight).or_else(|| line::drawing(quantities, compass, 0))
        }
        Some(Stage::Rotate(rotate)) => central::on_arm(quantities, rotate),
        Some(Stage::Central(stage)) => central::under_force(quantities, stage),
        Some(Stage::Swing(swing)) => Some(swing::drawing(quantities, compass, 0, swing)),
        Some(Stage::Connected(connected)) => Some(pulley::connected(quantities, 0, connected)),
        Some(Stage::SlideOff(slide)) => Some(ride::slide(quantities, compass, slide)),
        Some(Stage::Walk(walk)) => ride::walk(quantities, compass, 0, walk),
        Some(Stage::Moment(stage)) => Some(moment::sheet(quantities, compass, stage)),
        Some(Stage::Strike(stage)) => Some(arm::strike_sheet(quantities, stage)),
        Some(Stage::Conical(stage)) => Some(revolution::conical(quantities, stage)),
        Some(Stage::Bowl(stage)) => Some(revolution::bowl(quantities, stage)),
        Some(Stage::Fall(fall)) => fall::drawing(quantities, compass, fall),
        Some(Stage::Stream(stream)) => stream::drawing(quantities, compass, 0, stream),
        Some(Stage::Thrust(thrust)) => stream::rocket(quantities, compass, 0, thrust),
        Some(Stage::Bounces(bounces)) => fall::bouncing(quantities, bounces),
    }
}

/// Whether a force is read from a graph, which the figure has to show.
fn is_graph(push: &Push) -> bool {
    push.forces.iter().any(|force| matches!(force, Force::Pull(pull) if matches!(pull.value, Strength::Graph(_))))
}
