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
use super::super::words::sentences;

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
    let vectors = velocity(quantities, &name).into_iter().chain(forces).collect();
    let places = Places { radius, path: Some(CentralPath::Circle), other_end: None };
    draw(quantities, [body, &rotate.about], places, vectors, moment)
}

/// A body under a central force at the first place.
pub(in super::super) fn under_force(quantities: &Quantities<'_>, central: &stage::Central) -> Option<Drawing> {
    let name = quantities.velocity_name(&central.body, 1);
    let radius = quantities.since(QuantityKind::Position, &central.body, 1).to_string();
    let radius = quantities.named(&radius).map(|_| name_math(&radius)).or_else(|| quantities.asked_name(&radius));
    let path = orbit(quantities, central, &name);
    let vectors = velocity(quantities, &format!("{name}.theta")).into_iter().chain(radial(quantities, &name)).collect();
    let other_end = other_end(quantities, central, path);
    draw(quantities, [&central.body, &central.about], Places { radius, path, other_end }, vectors, None)
}

/// The label of the distance of the other end of an orbit that is told to be an ellipse: given or asked, or of a solution.
fn other_end(quantities: &Quantities<'_>, central: &stage::Central, path: Option<CentralPath>) -> Option<Math> {
    let end = match path? {
        CentralPath::Nearest => "max",
        CentralPath::Farthest => "min",
        CentralPath::Circle => return None,
    };
    let name = format!("r_{}.{end}", central.body);
    quantities.named(&name).map(|_| name_math(&name)).or_else(|| quantities.asked_name(&name))
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

/// What is told of the way of a body about a centre: the label at its distance, its path, the label at its other end.
struct Places {
    radius: Option<Math>,
    path: Option<CentralPath>,
    other_end: Option<Math>,
}

/// The velocity along the radius that is given.
fn radial(quantities: &Quantities<'_>, velocity: &str) -> Option<Moving> {
    let name = format!("{velocity}.r");
    let value = quantities.named(&name).filter(|value| *value != 0.0)?;
    let vector = [value * libm::cos(PLACE), value * libm::sin(PLACE)];
    let moving = Moving::velocity(LabelledVector::known(name_math(&name), vector));
    // Towards the centre, the radius is in the way.
    Some(if value < 0.0 { moving.arriving() } else { moving })
}

/// The velocity across the radius, where it is given or asked.
fn velocity(quantities: &Quantities<'_>, name: &str) -> Option<Moving> {
    let (sine, cosine) = (libm::sin(PLACE), libm::cos(PLACE));
    let across = |label, value: f64| Moving::velocity(LabelledVector::known(label, [-value * sine, value * cosine]));
    let told = quantities.named(name).map(|value| across(name_math(name), value));
    told.or_else(|| Some(across(quantities.asked_name(name)?, 1.0).asked()))
}

fn draw(
    quantities: &Quantities<'_>,
    [body, about]: [&str; 2],
    Places { radius, path, other_end }: Places,
    vectors: Vec<Moving>,
    moment: Option<Moment>,
) -> Option<Drawing> {
    if radius.is_none() && vectors.is_empty() {
        return None;
    }
    let moving = MovingBody { vectors, ..MovingBody::new(body_math(body)) };
    let mut wording = about_wording(quantities, [body, about], radius.as_ref(), &moving, moment.as_ref());
    if let Some(distance) = &other_end {
        let end = format!("the other end of the orbit lies {} from {}", distance.plain(), quantities.point(about));
        wording.description = format!("{} {}", wording.description, sentences([end]));
    }
    let centre = body_math(about);
    let central = Central { centre, angle: PLACE, radius, legs: None, body: moving, path, other_end, moment };
    Some(Situation { wording, layout: Layout::Central(central), axes: Vec::new() }.drawing())
}
