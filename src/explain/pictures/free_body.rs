//! Free-body diagrams: the forces on a body in a stage whose solution speaks of forces or of their work, and at an instant at which
//! a force is asked for, with what they make of it.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::ForceDiagram;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Line;
use momentous_figure::Moving;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_laws::force::THRESHOLD;
use momentous_model::ActingForce;
use momentous_model::ForceKind;
use momentous_model::Instant;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::Strength;
use momentous_scene::stage::Push;
use momentous_scene::stage::Resistance;
use momentous_scene::stage::Rotate;
use momentous_scene::stage::Stream;

use super::super::reach::laws_used;
use super::super::wording::capitalised;
use super::arm::along_path;
use super::compass::Compass;
use super::labels::body_math;
use super::labels::factor;
use super::labels::product;
use super::quantities::Quantities;
use super::sheet::swing;
use super::words::arrows;
use super::words::sentences;

/// The forces on the only body of a push or a slide, as they act on the drawing; none where one of them is not known.
pub(super) fn of_stage(quantities: &Quantities<'_>, compass: &Compass, index: usize, stage: &Stage) -> Option<Drawing> {
    let body = if let Stage::Push(push) = stage {
        let mut pushed = push.pushed();
        pushed.next().filter(|_| pushed.next().is_none())?
    } else if let Stage::Slide(slide) = stage
        && slide.on.is_none()
        && !slide.is_ramp()
    {
        &slide.body
    } else {
        return None;
    };
    let tilted = quantities.slope(index).map(|(rise, _)| compass.tilted(rise));
    let compass = tilted.as_ref().unwrap_or(compass);
    let mut acting =
        quantities.model().forces.iter().filter(|force| force.stage == index && force.on == *body).peekable();
    let forces: Vec<LabelledVector> = match (acting.peek(), stage) {
        (Some(_), _) => acting
            .map(|force| holds_still(quantities, compass, stage, force).or_else(|| acts(quantities, compass, force)))
            .collect::<Option<_>>()?,
        (None, Stage::Push(push)) => along_line(quantities, compass, index, body, push)?,
        (None, _) => return None,
    };
    let floor = pushes_up(quantities, index, body).is_some();
    let moving = quantities.body(body, forces.into_iter().map(Moving::force).collect());
    let name = quantities.called(body);
    let phrase = quantities.model().phrase(quantities.scene(), index);
    let wording = Wording {
        title: capitalised(&format!("free-body diagram of {name}")),
        description: sentences([format!("the forces on {name}"), arrows(&moving, true).join(", ")]),
        caption: sentences([format!("{phrase}: the forces on {name}")]),
    };
    let slope = quantities.slope(index).and_then(|(_, label)| label).filter(|_| floor);
    let line = Line { angle: compass.axis_angle(0), floor, slope, bodies: vec![moving], ..Line::default() };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

/// The friction on a body that is about to slide.
fn holds_still(
    quantities: &Quantities<'_>,
    compass: &Compass,
    stage: &Stage,
    force: &ActingForce,
) -> Option<LabelledVector> {
    let Stage::Push(push) = stage else { return None };
    let is_threshold =
        laws_used(quantities.worked).any(|law| law.stage == Some(force.stage) && law.law.id == THRESHOLD.id);
    let rubs =
        push.forces.iter().find_map(|force| if let Force::Friction(friction) = force { Some(friction) } else { None });
    let term = quantities
        .term(rubs?.friction.at_rest.as_ref()?)
        .filter(|_| is_threshold && force.kind == ForceKind::Friction)?;
    let size = quantities.evaluate(&term)? * pushes_up(quantities, force.stage, &force.on)?;
    let [x, y] = quantities.direction(&force.direction)?;
    let label = product([quantities.symbolic(&term), name_math(&format!("N_{}", force.on))]);
    Some(LabelledVector::known(label, compass.place([size * x, size * y])))
}

/// The force with which a floor pushes up.
fn pushes_up(quantities: &Quantities<'_>, index: usize, body: &str) -> Option<f64> {
    let mut floors = quantities.model().forces.iter();
    let normal = floors.find(|force| force.stage == index && force.on == body && force.kind == ForceKind::Normal);
    normal.map_or_else(|| quantities.named(&format!("N_{body}")), |force| quantities.evaluate(&force.strength))
}

/// A force of the model: one that changes as it is when the body starts to move, or else with the sense that it has all the time.
fn acts(quantities: &Quantities<'_>, compass: &Compass, force: &ActingForce) -> Option<LabelledVector> {
    let [x, y] = quantities.direction(&force.direction)?;
    let clock = quantities.model().symbols.find("t").filter(|clock| force.strength.contains(*clock));
    let size = match clock {
        Some(clock) => {
            let start = quantities.evaluate(&force.during[0]);
            let value = |symbol| if symbol == clock { start } else { quantities.value(symbol) };
            let first = force.strength.evaluate(&|symbol| value(symbol).unwrap_or(f64::NAN));
            let sense = || quantities.sense(&force.strength, (0.0, quantities.evaluate(&force.during[1])));
            if first.is_finite() && first != 0.0 { first } else { sense()? }
        }
        None => quantities.evaluate(&force.strength)?,
    };
    let label = match (force.kind, clock) {
        (ForceKind::Weight, _) => quantities.weight_math(&force.on, force.stage),
        (_, Some(_)) => Math::Identifier("F".to_owned()),
        (_, None) => quantities.size_of(&force.strength),
    };
    Some(LabelledVector::known(label, compass.place([size * x, size * y])))
}

/// The forces of a push along one axis that depend on the place or on the speed: in the middle of the way, at the greater speed.
fn along_line(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    body: &str,
    push: &Push,
) -> Option<Vec<LabelledVector>> {
    let [axis] = &quantities.axes[..] else { return None };
    let along =
        |label: Math, value: f64| Some(LabelledVector::known(label, compass.place(quantities.along_axes(&[value])?)));
    let velocities = [1, 2].map(|side| quantities.named(&quantities.velocity_name(body, index + side)));
    let faster = velocities.into_iter().flatten().max_by(|one, other| one.abs().total_cmp(&other.abs()));
    let mut forces = Vec::new();
    for force in &push.forces {
        let Force::Pull(pull) = force else { continue };
        let Strength::Term(term) = &pull.value else { return None };
        let (term, place) = (quantities.term(term)?, quantities.model().symbols.find(axis.letter()));
        let changes = place.is_some_and(|place| term.contains(place));
        let ends = [1, 2].map(|side| quantities.named(&format!("r_{body}{}", index + side)));
        let middle = || Some(f64::midpoint(ends[0]?, ends[1]?));
        let at = |symbol| if Some(symbol) == place && changes { middle() } else { quantities.value(symbol) };
        let value = term.evaluate(&|symbol| at(symbol).unwrap_or(f64::NAN));
        let sense = if quantities.is_backwards(pull.direction.as_ref()) { -1.0 } else { 1.0 };
        let label = if changes { Math::Identifier("F".to_owned()) } else { quantities.unsigned(&term) };
        forces.push(along(label, sense * value).filter(|_| value.is_finite())?);
    }
    let (mass, gravity) = (quantities.mass(body, index + 1), quantities.named("g"));
    let weight = mass.zip(gravity).map(|(mass, gravity)| mass * gravity);
    let rubs =
        push.forces.iter().find_map(|force| if let Force::Friction(friction) = force { Some(friction) } else { None });
    if rubs.is_some() || quantities.scene().plane == Plane::Vertical {
        forces.push(LabelledVector::known(quantities.weight_math(body, index), [0.0, -weight?]));
    }
    if let Some(friction) = rubs {
        let (normal, kinetic) = (pushes_up(quantities, index, body)?, quantities.term(&friction.friction.kinetic)?);
        let name = name_math(&format!("N_{body}"));
        forces.push(LabelledVector::known(name.clone(), compass.place([0.0, normal])));
        let against = -quantities.evaluate(&kinetic)? * normal * faster?.signum();
        forces.push(along(product([quantities.symbolic(&kinetic), name]), against)?);
    }
    if let Some(resistance) = &push.resistance {
        let (term, square) = match resistance {
            Resistance::Linear(term) => (term, false),
            Resistance::Quadratic(term) => (term, true),
        };
        let coefficient = quantities.term(term)?;
        let size = quantities.evaluate(&coefficient)? * if square { faster? * faster?.abs() } else { faster? };
        let letter = Math::Identifier("v".to_owned());
        let speed = if square { squared(letter) } else { letter };
        forces.push(along(product([factor(&coefficient, quantities.symbolic(&coefficient)), speed]), -size)?);
    }
    Some(forces)
}

fn squared(letter: Math) -> Math {
    Math::Sup(letter.into(), Math::Number("2".to_owned()).into())
}

/// The diagrams of the instants of a stage at which a pull or a push that holds a body on its way is asked for, told or used.
pub(super) fn at_instants(quantities: &Quantities<'_>, compass: &Compass, index: usize, stage: &Stage) -> Vec<Drawing> {
    let worked = quantities.worked;
    let told = worked.variant.all_given().iter().map(|(symbol, ..)| *symbol);
    let found = worked.leaf().answer_steps().iter().flat_map(|step| step.unknowns.iter().copied());
    let used: BTreeSet<Symbol> = worked.form.wanted().chain(told).chain(found).collect();
    let holds = used.into_iter().map(|symbol| quantities.model().name(symbol)).filter(|name| {
        matches!(name.kind, QuantityKind::Tension | QuantityKind::NormalForce | QuantityKind::HoldingForce)
    });
    holds.filter_map(|name| at_instant(quantities, compass, index, stage, name)).collect()
}

/// The forces on a body at an instant, and its mass times its acceleration.
struct Held {
    forces: Vec<LabelledVector>,
    effect: Vec<LabelledVector>,
    surface: Option<f64>,
    /// The meaning of the letters of the acceleration.
    told: &'static str,
}

fn at_instant(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Stage,
    name: &Name,
) -> Option<Drawing> {
    let body = name.subject.as_str();
    let side = || {
        let Some(Instant::Number(instant)) = name.instant else { return None };
        [0, 1].into_iter().rev().find(|side| quantities.timeline.naming_instant(body, index + 1 + side) == instant)
    };
    let when = |side: usize| quantities.when(index + 1 + side);
    let (held, when) = if let Stage::Swing(swing) = stage
        && swing.body == body
    {
        let side = side()?;
        let (angle, _) = swing::angle(quantities, compass, index, swing, side);
        (on_circle(quantities, index, name, angle, swing.radius.is_some())?, when(side))
    } else if let Stage::Rotate(rotate) = stage
        && rotate.held().iter().any(|(held, _)| *held == body)
    {
        let side = side()?;
        (on_level_circle(quantities, index, name, rotate, side)?, when(side))
    } else if let Stage::Conical(conical) = stage
        && conical.body == body
    {
        let side = side()?;
        (on_cone(quantities, index, name, index + 1 + side)?, when(side))
    } else if let Stage::Stream(stream) = stage
        && stream.body == body
    {
        let when = if stream.moves.is_some() { "at constant velocity" } else { "at rest" };
        (in_stream(quantities, compass, name, stream)?, when.to_owned())
    } else {
        return None;
    };
    let called = quantities.called(body);
    let said = |vectors: &[LabelledVector]| {
        let drawn = vectors.iter().filter(|vector| vector.value != Some([0.0; 2]));
        let labels = drawn.map(|vector| vector.label.plain()).collect::<Vec<_>>();
        if labels.is_empty() { "0".to_owned() } else { labels.join(", ") }
    };
    let wording = Wording {
        title: capitalised(&format!("free-body diagram of {called}")),
        description: sentences([
            format!("the forces on {called}: {}", said(&held.forces)),
            format!("mass times acceleration: {}", said(&held.effect)),
        ]),
        caption: sentences([format!("{called} {when}: forces = mass times acceleration"), held.told.to_owned()]),
    };
    let axes = if matches!(stage, Stage::Stream(_)) { compass.marks() } else { Vec::new() };
    let (name, form) = (body_math(body), quantities.form(body));
    let Held { mut forces, effect, surface, .. } = held;
    forces.retain(|force| force.value != Some([0.0, 0.0]));
    Some(ForceDiagram { wording, name, form, surface, forces, effect, axes }.drawing())
}

fn acceleration(quantities: &Quantities<'_>, body: &str, index: usize, letter: &str) -> Math {
    product([quantities.mass_math(body, index + 1), Math::subscripted("a", letter)])
}

fn along(label: Math, size: f64, [x, y]: [f64; 2]) -> LabelledVector {
    LabelledVector::known(label, [size * x, size * y])
}

/// How large the acceleration on a circle is.
const TOWARDS_CENTRE: &str = "towards the centre: v\u{b2}/r";

/// On a cord or inside a track, at an angle from straight down, counter-clockwise.
fn on_circle(quantities: &Quantities<'_>, index: usize, name: &Name, angle: f64, on_track: bool) -> Option<Held> {
    let body = name.subject.as_str();
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let inwards = [-sine, cosine];
    let pull = name.to_string();
    let (size, weight) = (quantities.named(&pull)?, quantities.mass(body, index + 1)? * quantities.named("g")?);
    let forces =
        vec![along(name_math(&pull), size, inwards), along(quantities.weight_math(body, index), weight, [0.0, -1.0])];
    let along_path = along(acceleration(quantities, body, index, "t"), -weight * sine, [cosine, sine]);
    let across = along(acceleration(quantities, body, index, "n"), size - weight * cosine, inwards);
    let effect = if sine == 0.0 { vec![across] } else { vec![across, along_path] };
    let surface = on_track.then(|| libm::atan2(inwards[1], inwards[0]));
    Some(Held { forces, effect, surface, told: TOWARDS_CENTRE })
}

/// On an arm or a string seen along the axis, to the right of the centre, with what pushes it along its path.
fn on_level_circle(
    quantities: &Quantities<'_>,
    index: usize,
    name: &Name,
    stage: &Rotate,
    side: usize,
) -> Option<Held> {
    let (body, pull) = (name.subject.as_str(), name.to_string());
    let size = quantities.named(&pull)?;
    let inwards = [-1.0, 0.0];
    let mut forces = vec![along(name_math(&pull), size, inwards)];
    let mut effect = vec![along(acceleration(quantities, body, index, "n"), size, inwards)];
    let (start, end) = quantities.ends(stage.during.as_ref())?;
    let instant = if side == 0 { Some(start) } else { end };
    let clock = quantities.model().symbols.find("t");
    let mut driven = 0.0;
    for push in along_path(quantities, stage, body, 0.0) {
        let strength = stage.driving().find(|(_, on)| on.is_some_and(|(on, _)| on == body))?;
        let Strength::Term(term) = &strength.0.value else { return None };
        let term = quantities.term(term)?;
        let at = |symbol| if Some(symbol) == clock { instant } else { quantities.value(symbol) };
        let value = term.evaluate(&|symbol| at(symbol).unwrap_or(f64::NAN));
        forces.push(along(push.vector.label, value, [0.0, 1.0]));
        driven += value;
    }
    if !driven.is_finite() {
        return None;
    }
    if driven != 0.0 {
        effect.push(along(acceleration(quantities, body, index, "t"), driven, [0.0, 1.0]));
    }
    Some(Held { forces, effect, surface: None, told: TOWARDS_CENTRE })
}

/// On a cord that goes round a vertical, to its right.
fn on_cone(quantities: &Quantities<'_>, index: usize, name: &Name, instant: usize) -> Option<Held> {
    let (body, pull) = (name.subject.as_str(), name.to_string());
    let since = quantities.timeline.naming_instant(body, instant);
    let angle = quantities.named(&format!("angle_{body}{since}"))?;
    let (size, weight) = (quantities.named(&pull)?, quantities.mass(body, index + 1)? * quantities.named("g")?);
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let forces = vec![
        along(name_math(&pull), size, [-sine, cosine]),
        along(quantities.weight_math(body, index), weight, [0.0, -1.0]),
    ];
    let effect = vec![along(acceleration(quantities, body, index, "n"), size * sine, [-1.0, 0.0])];
    Some(Held { forces, effect, surface: None, told: TOWARDS_CENTRE })
}

/// A body that catches a stream at constant velocity or at rest: what holds it, the stream, and where they act along the line, its weight and that
/// of what it has caught.
fn in_stream(quantities: &Quantities<'_>, compass: &Compass, name: &Name, stage: &Stream) -> Option<Held> {
    let [_] = quantities.axes[..] else { return None };
    let (body, hold) = (name.subject.as_str(), name.to_string());
    let stream = format!("F_{}", stage.body);
    let placed =
        |label: Math, value: f64| Some(LabelledVector::known(label, compass.place(quantities.along_axes(&[value])?)));
    let (holds, flows) = (quantities.named(&hold)?, quantities.named(&stream)?);
    let mut forces = vec![placed(name_math(&hold), holds)?, placed(name_math(&stream), flows)?];
    let rest = -(holds + flows);
    let weighs = quantities.scene().plane == Plane::Vertical && name.kind == QuantityKind::NormalForce;
    if weighs {
        let weight = (quantities.mass(body, 1)? * quantities.named("g")?).copysign(rest);
        if weight != 0.0 {
            forces.push(placed(quantities.weight_math(body, 0), weight)?);
        }
        let caught = caught_mass(quantities, body, stage);
        if let Some(caught) = caught.filter(|caught| quantities.evaluate(caught) != Some(0.0)) {
            forces.push(placed(product([quantities.unsigned(&caught), name_math("g")]), rest - weight)?);
        }
    }
    Some(Held { forces, effect: Vec::new(), surface: None, told: "" })
}

/// The mass that the body has caught of the stream: what is told, or the flow times how long it flowed.
fn caught_mass(quantities: &Quantities<'_>, body: &str, stage: &Stream) -> Option<Expr> {
    if let Some(caught) = &stage.caught {
        return quantities.term(caught);
    }
    let flow = quantities.model().symbol_of(&format!("flow_{body}"))?;
    Some(Expr::from(flow) * quantities.term(stage.during.as_ref()?)?)
}
