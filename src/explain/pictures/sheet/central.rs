//! A body about a fixed point: on an arm, or under a central force.

use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::Central;
use momentous_figure::CentralPath;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Moment;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_model::QuantityKind;
use momentous_scene::stage;
use momentous_scene::stage::Arm;
use momentous_scene::stage::Rotate;

use super::super::arm;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::sense::given_moment;
use super::super::words::about_wording;

/// The direction in which the body is drawn, seen from the centre, in radians.
const PLACE: f64 = 0.5;

/// A body on its arm at the start.
pub(in super::super) fn on_arm(quantities: &Quantities<'_>, rotate: &Rotate) -> Option<Drawing> {
    let held = rotate.held();
    let [(body, arm)] = held[..] else { return Some(arm::sheet(quantities, rotate)) };
    if rotate.is_arm() {
        return Some(arm::sheet(quantities, rotate));
    }
    let (Arm::Constant(arm) | Arm::Changing([arm, _])) = arm;
    let radius = quantities.label_of(arm);
    let name = quantities.velocity_name(body, 1);
    let moment = rotate.moment.as_ref().and_then(|strength| given_moment(quantities, strength, rotate.during.as_ref()));
    let forces = arm::along_path(quantities, rotate, body, PLACE);
    draw(quantities, [body, &rotate.about], radius, &name, forces, Some(CentralPath::Circle), moment)
}

/// A body under a central force at the first place.
pub(in super::super) fn under_force(quantities: &Quantities<'_>, central: &stage::Central) -> Option<Drawing> {
    let name = quantities.velocity_name(&central.body, 1);
    let radius = quantities.since(QuantityKind::Position, &central.body, 1).to_string();
    let radius = quantities.named(&radius).map(|_| name_math(&radius)).or_else(|| quantities.asked_name(&radius));
    let path = orbit(quantities, central, &name);
    draw(quantities, [&central.body, &central.about], radius, &format!("{name}.theta"), Vec::new(), path, None)
}

/// The orbit, where what is printed tells that the body is at its nearest or its farthest point.
fn orbit(quantities: &Quantities<'_>, central: &stage::Central, velocity: &str) -> Option<CentralPath> {
    let radius = quantities.named(&quantities.since(QuantityKind::Position, &central.body, 1).to_string())?;
    let [along, across] = ["r", "theta"].map(|letter| format!("{velocity}.{letter}"));
    // A scene that does not name the part along the radius has none.
    let is_across = quantities.model().symbol_of(&along).is_none() || quantities.named(&along) == Some(0.0);
    let across = quantities.named(&across).filter(|_| is_across && central.spring.is_none())?;
    if central.orbit == Some(stage::Orbit::Circle) {
        return Some(CentralPath::Circle);
    }
    let gravity = central.gravity.as_ref().and_then(|gravity| quantities.evaluate(&quantities.term(gravity)?));
    let nearest = match gravity {
        Some(gravity) => radius * across * across > gravity,
        None => goes_out(quantities, central, [radius, across])?,
    };
    Some(if nearest { CentralPath::Nearest } else { CentralPath::Farthest })
}

/// Whether what is printed of the second place lies farther out than the first one: its distance, or the slower motion about the centre.
fn goes_out(quantities: &Quantities<'_>, central: &stage::Central, [radius, across]: [f64; 2]) -> Option<bool> {
    let second = quantities.named(&quantities.since(QuantityKind::Position, &central.body, 2).to_string());
    let slower = || {
        let there = quantities.named(&format!("{}.theta", quantities.velocity_name(&central.body, 2)))?;
        Some(there.abs() < across.abs())
    };
    second.map(|second| second > radius).or_else(slower)
}

fn draw(
    quantities: &Quantities<'_>,
    [body, about]: [&str; 2],
    radius: Option<Math>,
    velocity: &str,
    forces: Vec<Moving>,
    path: Option<CentralPath>,
    moment: Option<Moment>,
) -> Option<Drawing> {
    let (sine, cosine) = (libm::sin(PLACE), libm::cos(PLACE));
    let across = |label, value: f64| Moving::velocity(LabelledVector::known(label, [-value * sine, value * cosine]));
    let told = quantities.named(velocity).map(|value| across(name_math(velocity), value));
    let velocity = told.or_else(|| Some(across(quantities.asked_name(velocity)?, 1.0).asked()));
    let vectors: Vec<Moving> = velocity.into_iter().chain(forces).collect();
    if radius.is_none() && vectors.is_empty() {
        return None;
    }
    let moving = MovingBody { vectors, ..MovingBody::new(body_math(body)) };
    let wording = about_wording(quantities, [body, about], radius.as_ref(), &moving, moment.as_ref());
    let centre = body_math(about);
    let central = Central { centre, angle: PLACE, radius, legs: None, body: moving, path, moment };
    Some(Situation { wording, layout: Layout::Central(central), axes: Vec::new() }.drawing())
}
