//! A body that a stream meets, and a body that throws mass away.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::name_math;
use momentous_figure::Attach;
use momentous_figure::Drawing;
use momentous_figure::Exhaust;
use momentous_figure::Form;
use momentous_figure::Grains;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Line;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::Situation;
use momentous_figure::Vane;
use momentous_figure::Wording;
use momentous_model::Direction;
use momentous_scene::stage;
use momentous_scene::stage::Stream;
use momentous_scene::stage::Thrust;

use super::super::compass::Compass;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::vectors::Labelled;
use super::super::words::arrows;
use super::super::words::sentences;
use super::super::words::situation_wording;
use momentous_scene::list;

/// An axis is level where the sine of its angle is less.
const LEVEL: f64 = 1e-9;

/// The stream before the body, after it, and its force where that may be shown.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    stage: &Stream,
) -> Option<Drawing> {
    let flowing = quantities.model().flowing_in(index)?;
    // A picture of a plate that lies obliquely is not drawn with one that lies across the stream.
    if flowing.normal.is_some() {
        return None;
    }
    let arriving = arrow(quantities, compass, &flowing.speed, &flowing.direction).filter(|_| !flowing.speed.is_zero());
    let departing = flowing.leaving.as_ref().and_then(|leaving| arrow(quantities, compass, &flowing.relative, leaving));
    // The body moves along the stream.
    let moves = stage.moves.as_ref().and_then(|moves| quantities.term(moves)).filter(|moves| !moves.is_zero());
    let moves = moves.and_then(|moves| arrow(quantities, compass, &moves, &flowing.direction));
    let stream_arrows: Vec<Moving> =
        moves.into_iter().chain(force(quantities, compass, &stage.body).map(Moving::force)).collect();
    // What grain falls on from above, and what moves level, is a belt.
    let level = libm::sin(compass.axis_angle(0)).abs() < LEVEL && quantities.axes.len() == 1;
    let form = if stage.per_length.is_some() && stage.moves.is_some() {
        // What takes up a rope as it moves is a length of that rope.
        Form::Strand
    } else if flowing.speed.is_zero() && level {
        Form::Belt
    } else {
        Form::Block
    };
    let drawn = |vectors| MovingBody { vectors, ..MovingBody::new(body_math(&stage.body)).shaped(form) };
    let mut wording = body_wording(quantities, index, &stage.body, &drawn(stream_arrows.clone()));
    let mut vectors = Vec::new();
    let vane = flowing.leaving.as_ref().and_then(|leaving| {
        let [first, second] = [&flowing.direction, leaving].map(|direction| quantities.direction(direction));
        Some(Vane {
            name: body_math(&stage.body),
            directions: [compass.angle(first?), compass.angle(second?)],
            jet: [arriving.clone(), departing.clone()],
            vectors: stream_arrows.clone(),
            angle: quantities.angle_mark(compass, leaving),
        })
    });
    for (does, vector) in
        [("meets", arriving.map(|moving| moving.arriving().in_stream())), ("leaves", departing.map(Moving::in_stream))]
    {
        let Some(vector) = vector else { continue };
        let with = list(&arrows(&drawn(vec![vector.clone()]), true));
        tell(&mut wording.description, format!("{} {does} {} with {with}", stage.by, quantities.called(&stage.body)));
        if vector.attach == Attach::Arriving && !vector.asked {
            let speed = vector.vector.label.plain();
            let velocity = format!("the velocity of {}", stage.by);
            // A caption has no subscripts.
            let is_plain = !speed.contains('_');
            let told =
                if is_plain { format!("{velocity} is {speed}") } else { format!("the arriving arrow is {velocity}") };
            tell(&mut wording.caption, told);
        }
        vectors.push(vector);
    }
    vectors.extend(stream_arrows);
    if vectors.is_empty() && quantities.scope() == Scope::Solved {
        return None;
    }
    // What leaves a body that moves is told as seen from it.
    if flowing.leaving.is_some() && flowing.relative != flowing.speed {
        let speed = quantities.symbolic(&flowing.relative).plain();
        let which = if speed.contains('_') { "with which it leaves" } else { &speed };
        let relative = format!("the velocity {which} is relative to {}", quantities.called(&stage.body));
        tell(&mut wording.caption, relative);
    }
    if let Some(vane) = vane {
        return Some(Situation { wording, layout: Layout::Vane(vane), axes: compass.marks() }.drawing());
    }
    // What has no velocity along the line falls onto the body from above.
    let falls = flowing.speed.is_zero();
    let label = || quantities.label_of(stage.flow.as_ref()?);
    let grains = falls.then(|| Grains { body: 0, join: true, label: label() });
    Some(lone(compass, wording, drawn(vectors), grains))
}

fn arrow(quantities: &Quantities<'_>, compass: &Compass, speed: &Expr, direction: &Direction) -> Option<Moving> {
    let [x, y] = quantities.direction(direction)?;
    let Some(size) = quantities.evaluate(speed) else {
        let vector = Labelled { label: quantities.asked(speed)?, value: Some([x, y]) };
        return Some(Moving::velocity(vector.placed(compass)).asked());
    };
    let vector = Labelled { label: quantities.unsigned(speed), value: Some([size * x, size * y]) };
    Some(Moving::velocity(vector.placed(compass)))
}

/// The force of the stream, in a solution.
fn force(quantities: &Quantities<'_>, compass: &Compass, body: &str) -> Option<LabelledVector> {
    if quantities.scope() == Scope::Given {
        return None;
    }
    let named = |letter: &str| quantities.named(&format!("F_{body}{letter}"));
    let value = match quantities.axes.len() {
        1 => quantities.along_axes(&[named("")?])?,
        _ => quantities.along_axes(&[named(".x")?, named(".y")?])?,
    };
    Some(Labelled { label: name_math(&format!("F_{body}")), value: Some(value) }.placed(compass))
}

/// A body that throws mass away, with its velocity at the start and the forces on it.
pub(in super::super) fn rocket(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    thrust: &Thrust,
) -> Option<Drawing> {
    let balance = if thrust.on_ground { at_lift_off(quantities, compass, thrust) } else { None };
    let lifts_off = balance.is_some();
    let vectors = balance.unwrap_or_else(|| {
        let mut vectors = quantities.motion(compass, &thrust.body, index + 1);
        // What stands on the ground is held by more than is drawn.
        if !thrust.on_ground {
            vectors.extend(quantities.forces_on(compass, &thrust.body, index));
        }
        vectors
    });
    if vectors.is_empty() {
        return None;
    }
    let body = MovingBody { vectors, ..MovingBody::new(body_math(&thrust.body)).shaped(Form::Block) };
    let mut wording = body_wording(quantities, index, &thrust.body, &body);
    let name = quantities.called(&thrust.body);
    if lifts_off {
        wording.caption = sentences([format!("{name} as it lifts off: the thrust is as large as the weight")]);
    }
    let label = match &thrust.exhaust {
        stage::Exhaust::Speed(term) => quantities.label_of(term),
        stage::Exhaust::Jets(_) => None,
    };
    tell(&mut wording.description, format!("{name} throws its exhaust out through a nozzle"));
    let exhaust = Exhaust { ahead: quantities.is_backwards(thrust.direction.as_ref()), label };
    let line = Line { angle: compass.axis_angle(0), bodies: vec![body], exhaust: Some(exhaust), ..Line::default() };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

/// The forces on what stands on the ground as it lifts off, in a solution.
fn at_lift_off(quantities: &Quantities<'_>, compass: &Compass, stage: &Thrust) -> Option<Vec<Moving>> {
    if quantities.scope() == Scope::Given {
        return None;
    }
    let name = format!("F_{}", stage.body);
    let thrust = match &stage.force {
        Some(term) => quantities.evaluate(&quantities.term(term)?)?,
        None => quantities.named(&name)?,
    };
    let label = match &stage.force {
        Some(term) => quantities.label_of(term)?,
        None => name_math(&name),
    };
    let along = |label: Math, size: f64| {
        let vector = Labelled { label, value: Some(quantities.along_axes(&[size])?) };
        Some(Moving::force(vector.placed(compass)))
    };
    // The exhaust is in the way of what points backwards from there.
    let weight = Math::Row(vec![name_math("m"), Math::Operator(Operator::Juxtapose), name_math("g")]);
    [along(label, thrust), along(weight, -thrust).map(Moving::arriving)].into_iter().collect()
}

fn body_wording(quantities: &Quantities<'_>, index: usize, name: &str, body: &MovingBody) -> Wording {
    situation_wording(quantities, &[(name.to_owned(), body.clone())], &quantities.when(index + 1))
}

/// Adds a sentence.
fn tell(text: &mut String, sentence: String) {
    text.push(' ');
    text.push_str(&sentences([sentence]));
}

fn lone(compass: &Compass, wording: Wording, body: MovingBody, grains: Option<Grains>) -> Drawing {
    let line = Line { angle: compass.axis_angle(0), bodies: vec![body], grains, ..Line::default() };
    Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing()
}
