//! A body on another one that gives way: a walk along a boat, a slide down a wedge on wheels.

use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::Face;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Moving;
use momentous_figure::Ride;
use momentous_figure::Role;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_model::above_or_below;
use momentous_model::is_reversed;
use momentous_scene::Term;
use momentous_scene::stage::Interact;
use momentous_scene::stage::SlideOff;
use momentous_scene::stage::Walk;

use super::super::super::wording::capitalised;
use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::SKETCHED;
use super::super::quantities::Scope;
use super::super::words::sentences;

/// Before a walk, with its way along the other body; in a solution with the displacement of each.
pub(in super::super) fn walk(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Walk,
) -> Option<Drawing> {
    let distance = quantities.term(&stage.distance).and_then(|term| quantities.evaluate(&term));
    let sense = compass.place([1.0, 0.0])[0];
    let displacement = |body: &str| {
        let name = quantities.staged(&format!("s_{body}"), index);
        let value = quantities.named(&name).filter(|_| quantities.scope() == Scope::Solved)?;
        let vector = LabelledVector::known(name_math(&name), compass.place([value, 0.0]));
        Some(Moving { role: Role::Length, ..Moving::velocity(vector) })
    };
    let [rider, carrier] =
        [&stage.body, &stage.on].map(|body| quantities.body(body, displacement(body).into_iter().collect()));
    if quantities.scope() == Scope::Solved && rider.vectors.is_empty() && carrier.vectors.is_empty() {
        return None;
    }
    let way = quantities.label_of(&stage.distance);
    let told = way.as_ref().map(|way| format!("the distance along it is {}", way.plain()));
    let moved =
        (quantities.scope() == Scope::Solved).then(|| "the arrows are the displacements relative to the ground".into());
    // The displacements take the place of the way in a solution.
    let face = Face::Deck {
        way: way.filter(|_| quantities.scope() == Scope::Given),
        rightwards: distance.unwrap_or(1.0) * sense >= 0.0,
        floor: false,
    };
    let wording = on_another(quantities, [&stage.body, &stage.on], told.into_iter().chain(moved.clone()), moved);
    Some(Situation { wording, layout: Layout::Ride(Ride { rider, carrier, face }), axes: compass.marks() }.drawing())
}

/// Before a body slides on another one, with their velocities.
pub(in super::super) fn rub(quantities: &Quantities<'_>, compass: &Compass, stage: &Interact) -> Option<Drawing> {
    let bodies = [stage.between.first()?.as_str(), stage.between.get(1)?.as_str()];
    let rightwards = compass.place([1.0, 0.0])[0] > 0.0;
    let backwards = quantities.is_backwards(stage.direction.as_ref());
    let [rider, carrier] = bodies.map(|body| quantities.body(body, quantities.motion(compass, body, 1)));
    let arrows = (!rider.vectors.is_empty() || !carrier.vectors.is_empty())
        .then(|| "the arrows are the velocities at the start".to_owned());
    let wording = on_another(quantities, bodies, arrows.clone(), arrows);
    let face = Face::Deck { way: None, rightwards: rightwards != backwards, floor: true };
    Some(Situation { wording, layout: Layout::Ride(Ride { rider, carrier, face }), axes: compass.marks() }.drawing())
}

/// Before a slide.
pub(in super::super) fn slide(quantities: &Quantities<'_>, compass: &Compass, stage: &SlideOff) -> Drawing {
    let (angle, label, rightwards) = face(quantities, compass, stage);
    let height = quantities.label_of(&stage.height);
    let told = |what: &str, label: &Option<Math>| label.as_ref().map(|label| format!("{what} {}", label.plain()));
    let said = [told("the angle of its face is", &label), told("the height is", &height)];
    let [rider, carrier] = [&stage.body, &stage.on].map(|body| quantities.body(body, Vec::new()));
    let wording = on_another(quantities, [&stage.body, &stage.on], said.into_iter().flatten(), None);
    let face = Face::Slope { angle, label, rightwards, height };
    Situation { wording, layout: Layout::Ride(Ride { rider, carrier, face }), axes: compass.marks() }.drawing()
}

/// The angle of the face against the level, how it is written, and whether the face falls to the right.
fn face(quantities: &Quantities<'_>, compass: &Compass, stage: &SlideOff) -> (f64, Option<Math>, bool) {
    let words = stage.direction.0.trim();
    let Some((angle, _, axis)) = above_or_below(words) else {
        // A face that ends level, such as a bowl's.
        return (SKETCHED, None, compass.place([if is_reversed(words) { -1.0 } else { 1.0 }, 0.0])[0] > 0.0);
    };
    let angle = quantities.term(&Term(angle.to_owned()));
    let (angle, label) = angle.map_or((SKETCHED, None), |angle| quantities.angle_or_sketch(&angle));
    let along = if is_reversed(axis) { -1.0 } else { 1.0 };
    (angle, label, compass.place([along, 0.0])[0] > 0.0)
}

fn on_another(
    quantities: &Quantities<'_>,
    bodies: [&str; 2],
    told: impl IntoIterator<Item = String>,
    more: Option<String>,
) -> Wording {
    let [rider, carrier] = bodies.map(|body| quantities.called(body));
    let what = format!("{rider} on {carrier}");
    Wording {
        title: capitalised(&what),
        description: sentences([what.clone()].into_iter().chain(told)),
        caption: sentences([what].into_iter().chain(more)),
    }
}
