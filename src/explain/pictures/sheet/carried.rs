//! A body that rises or sinks on another one which gives way: where it starts, and in a solution where it ends, with the velocities.

use momentous_expr::Math;
use momentous_figure::Carried;
use momentous_figure::CarriedBy;
use momentous_figure::CarriedEnd;
use momentous_figure::Drawing;
use momentous_figure::Layout;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_scene::stage::Halt;
use momentous_scene::stage::Slide;
use momentous_scene::stage::Swing;
use momentous_scene::stage::UpOrDown;

use super::super::super::wording::capitalised;
use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::SKETCHED;
use super::super::quantities::Scope;
use super::super::words::sentences;
use super::swing;

/// On the face of another body.
pub(in super::super) fn on_face(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Slide,
    on: &str,
) -> Drawing {
    let bodies = [stage.body.as_str(), on];
    let rises = stage.way == Some(UpOrDown::Up);
    let rightwards = (compass.place([1.0, 0.0])[0] > 0.0) != quantities.is_backwards(stage.direction.as_ref());
    let [passenger, carrier] = bodies.map(|body| quantities.velocity(body, index + 1));
    let brow = if rises { stage.until != Some(Halt::Together) } else { carrier.is_some() && passenger != carrier };
    let angle = |side: usize| if (side == 1) == rises { SKETCHED } else { 0.0 };
    let carried = Carried {
        ends: [0, 1].map(|side| end(quantities, compass, bodies, index + 1 + side, (angle(side), None))).to_vec(),
        by: CarriedBy::Face { rightwards: rightwards == rises, brow, step: false },
        height: stage.height.as_ref().and_then(|height| quantities.label_of(height)),
    };
    let [name, other] = bodies.map(|body| quantities.called(body));
    let place = format!("{name} on {other}");
    let holds = format!("{name} on the smooth face of {other}, which can move along the floor");
    drawing(quantities, compass, index, carried, [place, holds, format!("{name} and {other}")])
}

/// On a cord from another body, or on the circular track in it.
pub(in super::super) fn on_circle(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Swing,
    on: &str,
) -> Drawing {
    let bodies = [stage.body.as_str(), on];
    let ends = [0, 1].map(|side| {
        let angle = swing::angle(quantities, compass, index, stage, side);
        end(quantities, compass, bodies, index + 1 + side, angle)
    });
    let told = stage.arm().and_then(|term| quantities.label_of(term));
    let long = |what: &str| told.as_ref().map_or_else(String::new, |told| format!(" of {what} {}", told.plain()));
    let [name, other] = bodies.map(|body| quantities.called(body));
    let rightwards = ends.iter().any(|end| end.angle > 0.0);
    let (by, place, holds) = if stage.radius.is_some() {
        let holds = format!("{name} on a circular track{} in {other}, which can move along the floor", long("radius"));
        (CarriedBy::Face { rightwards, brow: false, step: true }, format!("{name} on the circular track"), holds)
    } else {
        let holds = format!("{name} hangs on a cord{} from {other}, which can move along its track", long("length"));
        (CarriedBy::Cord(told.clone()), format!("{name} on the cord"), holds)
    };
    let carried = Carried { ends: ends.to_vec(), by, height: swing::height(quantities, index, stage) };
    drawing(quantities, compass, index, carried, [place, holds, format!("{name} and {other}")])
}

/// The two bodies at an instant, with their velocities.
fn end(
    quantities: &Quantities<'_>,
    compass: &Compass,
    bodies: [&str; 2],
    instant: usize,
    (angle, label): (f64, Option<Math>),
) -> CarriedEnd {
    let [rider, carrier] = bodies.map(|body| quantities.body(body, quantities.motion(compass, body, instant)));
    CarriedEnd { rider, carrier, angle, label }
}

/// The end is shown beside the start where something is told of it.
fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    carried: Carried,
    [place, holds, both]: [String; 3],
) -> Drawing {
    let is_told = |moving: &MovingBody| !moving.vectors.is_empty();
    let tells = |end: &CarriedEnd| {
        let height = end.angle != 0.0 && carried.height.is_some();
        height || end.label.is_some() || is_told(&end.rider) || is_told(&end.carrier)
    };
    let solved = quantities.scope() == Scope::Solved;
    let shown = if solved || carried.ends.get(1).is_some_and(tells) { 2 } else { 1 };
    let height = carried.height.as_ref().map_or_else(String::new, |height| {
        format!("the difference in height between the start and the end is {}", height.plain())
    });
    let phrase = quantities.model().phrase(quantities.scene(), index);
    let velocities = format!("{phrase}: the velocities of {both} at its start and at its end");
    let beside = if shown > 1 { "the start is on the left, the end on the right".to_owned() } else { String::new() };
    let wording = Wording {
        title: capitalised(&place),
        description: sentences([holds, height, beside.clone()]),
        caption: sentences([if solved { velocities } else { place }, beside]),
    };
    let layout = Layout::Carried(Carried { ends: carried.ends.into_iter().take(shown).collect(), ..carried });
    Situation { wording, layout, axes: compass.marks() }.drawing()
}
