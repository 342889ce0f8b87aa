//! Angular impulse-momentum diagrams: moment of momentum before + angular impulse = moment of momentum after.

use std::f64::consts::PI;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::AngularDiagram;
use momentous_figure::AngularImpulse;
use momentous_figure::AngularMomentum;
use momentous_figure::AngularState;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Wording;
use momentous_model::QuantityKind;
use momentous_scene::Strength;
use momentous_scene::Term;
use momentous_scene::stage::Arm;
use momentous_scene::stage::Bowl;
use momentous_scene::stage::Central;
use momentous_scene::stage::Conical;
use momentous_scene::stage::During;
use momentous_scene::stage::Orbit;
use momentous_scene::stage::Rotate;
use momentous_scene::stage::UpOrDown;
use momentous_solve::Statement;

use super::labels::body_math;
use super::labels::product;
use super::quantities::Quantities;
use super::words::sentences;

/// From the radius before to the radius after, on the drawing of a flight about a centre, where nothing tells the true angle.
const TURN: f64 = 0.9;
/// With less eccentricity an orbit is a circle, on which nothing tells one place from another.
const ROUND: f64 = 1e-6;

/// A particle at a place: its distance from the centre, and its velocity along and across the radius.
struct Place {
    radius: (Math, Option<f64>),
    velocity: Vec<(Math, Option<[f64; 2]>)>,
    /// Its direction as seen from the centre, in radians.
    angle: f64,
}

/// The diagram of a particle on an arm.
pub(super) fn rotation(quantities: &Quantities<'_>, stage: usize, rotate: &Rotate) -> Option<Drawing> {
    let held = rotate.held();
    let [(body, arm)] = held[..] else { return None };
    let arms = arm.ends();
    let place = |side: usize| {
        let arm = quantities.term(arms[side])?;
        let name = quantities.velocity_name(body, stage + 1 + side);
        let velocity = quantities.named(&name).map(|velocity| [0.0, velocity]);
        let radius = (quantities.symbolic(&arm), quantities.evaluate(&arm));
        Some(Place { radius, velocity: vec![(name_math(&name), velocity)], angle: 0.0 })
    };
    let places = [place(0)?, place(1)?];
    let label = moment_impulse(quantities, stage, rotate);
    let gained = match (rotate.is_driven(), &places.each_ref().map(Place::moment)) {
        (false, _) => Some(0.0),
        (true, [Some(before), Some(after)]) => Some(after - before),
        _ => None,
    };
    let impulse = AngularImpulse { label, value: gained };
    Some(drawing(quantities, [body, &rotate.about], stage, places, impulse))
}

/// The diagram of a particle under a central force.
pub(super) fn central(quantities: &Quantities<'_>, stage: usize, central: &Central) -> Drawing {
    let parts = [("theta", [0.0, 1.0]), ("r", [1.0, 0.0])];
    let place = |side: u8| round(quantities, &central.body, stage, side, &parts);
    let impulse = AngularImpulse { label: nothing(&central.about), value: Some(0.0) };
    let [before, after] = [place(0), place(1)];
    let angle = turn(quantities, stage, central, [&before, &after]).unwrap_or(after.angle);
    let after = Place { angle, ..after };
    let drawing = drawing(quantities, [&central.body, &central.about], stage, [before, after], impulse);
    // A radial momentum that the solution does not find is there all the same.
    let is_found = |side: usize| {
        let name = format!("{}.r", quantities.since(QuantityKind::Velocity, &central.body, stage + side));
        quantities.named(&name).is_some()
    };
    if central.orbit == Some(Orbit::Circle) || [1, 2].into_iter().all(is_found) {
        return drawing;
    }
    let caption = format!("{} Of the momentum, only the transverse part is drawn.", drawing.caption);
    Drawing { caption, ..drawing }
}

/// The angle from the first radius to the second in an orbit under gravity: between the nearest and the farthest point half a
/// turn, elsewhere the difference of the angles from the nearest point, of which a radius alone tells the lesser one.
fn turn(quantities: &Quantities<'_>, stage: usize, central: &Central, places: [&Place; 2]) -> Option<f64> {
    let [radial, other] = [0, 1].map(|side| {
        let name = quantities.since(QuantityKind::Velocity, &central.body, stage + 1 + side);
        quantities.named(&format!("{name}.r"))
    });
    let [Some(first), Some(second)] = places.map(|place| place.radius.1) else { return None };
    let apart = (first - second).abs() > ROUND * first;
    if central.spring.is_none() && apart && radial == Some(0.0) && other == Some(0.0) {
        return Some(PI);
    }
    let gravity = quantities.evaluate(&quantities.term(central.gravity.as_ref()?)?)?;
    let moment = places[0].moment()?;
    let cosine = |radius: f64| moment * moment / (gravity * radius) - 1.0;
    let sine = |radial: f64| radial * moment / gravity;
    let start = [cosine(first), sine(radial?)];
    let eccentricity = libm::hypot(start[0], start[1]);
    let to = match other {
        Some(other) => libm::atan2(sine(other), cosine(second)),
        None => libm::acos((cosine(second) / eccentricity).clamp(-1.0, 1.0)),
    };
    let turn = (to - libm::atan2(start[1], start[0])).rem_euclid(2.0 * PI);
    (eccentricity > ROUND && turn.is_finite()).then_some(turn)
}

/// A particle at one end of its way round a centre, with these polar components of its velocity: the first, and others that
/// are not zero.
fn round(quantities: &Quantities<'_>, body: &str, stage: usize, side: u8, parts: &[(&str, [f64; 2])]) -> Place {
    let [name, radius] = [QuantityKind::Velocity, QuantityKind::Position]
        .map(|kind| quantities.since(kind, body, stage + 1 + usize::from(side)).to_string());
    let component = |(letter, unit): &(&str, [f64; 2])| {
        let component = format!("{name}.{letter}");
        let value = quantities.named(&component);
        (name_math(&component), value.map(|value| unit.map(|part| part * value)))
    };
    let mut components = parts.iter().map(component);
    let first = components.next();
    let others = components.filter(|(_, value)| value.is_some_and(|value| value != [0.0, 0.0]));
    let velocity = first.into_iter().chain(others).collect();
    let radius = (name_math(&radius), quantities.named(&radius));
    Place { radius, velocity, angle: TURN * f64::from(side) }
}

/// The diagram of a conical pendulum on its two circles, seen from above.
pub(super) fn conical(quantities: &Quantities<'_>, stage: usize, conical: &Conical) -> Drawing {
    let place = |side: u8| {
        let [name, radius] = [QuantityKind::Velocity, QuantityKind::Position]
            .map(|kind| quantities.since(kind, &conical.body, stage + 1 + usize::from(side)).to_string());
        let velocity = quantities.named(&name).map(|velocity| [0.0, velocity]);
        let radius = (name_math(&radius), quantities.named(&radius));
        Place { radius, velocity: vec![(name_math(&name), velocity)], angle: TURN * f64::from(side) }
    };
    let impulse = AngularImpulse { label: nothing(&conical.about), value: Some(0.0) };
    drawing(quantities, [&conical.body, &conical.about], stage, [place(0), place(1)], impulse)
}

/// The diagram of a body inside a bowl at its two levels, seen from above: what moves along the slope has no moment.
pub(super) fn bowl(quantities: &Quantities<'_>, stage: usize, bowl: &Bowl) -> Drawing {
    let [before, mut after] = [0, 1].map(|side| round(quantities, &bowl.body, stage, side, &[("theta", [0.0, 1.0])]));
    after.radius.1 = after.radius.1.or_else(|| other_level(quantities, bowl, before.radius.1?));
    // What energy alone has answered still has its angular momentum.
    if let (Some(moment), Some(radius), Some((_, velocity))) =
        (before.moment(), after.radius.1, after.velocity.first_mut())
    {
        *velocity = velocity.or(Some([0.0, moment / radius]));
    }
    let impulse = AngularImpulse { label: nothing(&bowl.about), value: Some(0.0) };
    drawing(quantities, [&bowl.body, &bowl.about], stage, [before, after], impulse)
}

/// The distance from the axis at the second level, by the shape of the wall.
fn other_level(quantities: &Quantities<'_>, bowl: &Bowl, first: f64) -> Option<f64> {
    let number = |term: &Option<Term>| quantities.evaluate(&quantities.term(term.as_ref()?)?);
    let rise = number(&bowl.height)? * if bowl.way == UpOrDown::Up { 1.0 } else { -1.0 };
    if let Some(angle) = number(&bowl.cone) {
        return Some(first + rise * libm::tan(angle));
    }
    let size = number(&bowl.sphere)?;
    let depth = libm::sqrt((size * size - first * first).max(0.0)) - rise;
    Some(libm::sqrt((size * size - depth * depth).max(0.0)))
}

/// The angular impulse by its name, or as moment times time.
pub(super) fn moment_impulse(quantities: &Quantities<'_>, stage: usize, rotate: &Rotate) -> Math {
    let model = quantities.model();
    let is_integral = |tag: usize| {
        let instance = model.instances.get(tag);
        instance.is_some_and(|instance| instance.stage == Some(stage) && instance.integral.is_some())
    };
    let equation = model.system.equations.iter().find(|equation| is_integral(equation.tag));
    if let Some(Statement::Equal { left, .. }) = equation.map(|equation| &equation.statement) {
        return quantities.symbolic(left);
    }
    let zero = Expr::zero();
    let duration = match &rotate.during {
        Some(During::For(term)) => quantities.term(term).map(|end| quantities.duration(&zero, &end)),
        _ => None,
    };
    let duration = duration.unwrap_or_else(|| name_math(&quantities.staged("dt", stage)));
    if !rotate.forces.is_empty() {
        let only = rotate.driving().next().filter(|_| rotate.forces.len() == 1 && rotate.moment.is_none());
        let moment = only.and_then(|(force, on)| {
            let (Strength::Term(force), (_, Arm::Constant(arm))) = (&force.value, on?) else { return None };
            Some([quantities.symbolic(&quantities.term(arm)?), quantities.unsigned(&quantities.term(force)?)])
        });
        return moment.map_or_else(
            || name_math(&quantities.staged("I_M", stage)),
            |[arm, force]| product([arm, force, duration]),
        );
    }
    let Some(Strength::Term(moment)) = &rotate.moment else { return nothing(&rotate.about) };
    let moment = quantities.term(moment).map(|moment| quantities.unsigned(&moment));
    product([moment.unwrap_or_else(|| name_math("M")), duration])
}

/// The angular impulse of a force that has no moment: `M_O dt`, said to be zero by the diagram.
pub(super) fn nothing(about: &str) -> Math {
    product([name_math(&format!("M_{about}")), name_math("dt")])
}

impl Place {
    /// Moment of the velocity about the centre.
    fn moment(&self) -> Option<f64> {
        let (_, velocity) = self.velocity.first()?;
        Some(self.radius.1? * velocity.as_ref()?[1])
    }

    fn state(self, mass: &Math) -> AngularState {
        let (sine, cosine) = (libm::sin(self.angle), libm::cos(self.angle));
        let turned = |[x, y]: [f64; 2]| [x * cosine - y * sine, x * sine + y * cosine];
        let momenta = self
            .velocity
            .into_iter()
            .map(|(label, value)| LabelledVector { label: product([mass.clone(), label]), value: value.map(turned) });
        let (label, length) = self.radius;
        let radius = LabelledVector { label, value: length.map(|length| turned([length, 0.0])) };
        AngularState { radius, momenta: momenta.collect() }
    }
}

/// The mass is the same before and after, so momenta are drawn to the scale of the velocities.
fn drawing(
    quantities: &Quantities<'_>,
    [body, about]: [&str; 2],
    stage: usize,
    [before, after]: [Place; 2],
    impulse: AngularImpulse,
) -> Drawing {
    let mass = quantities.mass_math(body, stage + 1);
    let (name, centre) = (quantities.called(body), quantities.point(about));
    let phrase = quantities.model().phrase(quantities.scene(), stage);
    let change = match impulse.value {
        Some(0.0) => "no angular impulse acts about it".to_owned(),
        Some(value) if value > 0.0 => "the angular impulse about it acts counter-clockwise".to_owned(),
        Some(_) => "the angular impulse about it acts clockwise".to_owned(),
        None => "an angular impulse acts about it".to_owned(),
    };
    let place = |place: &Place, when: &str| {
        let momenta: Vec<String> =
            place.velocity.iter().map(|(label, _)| product([mass.clone(), label.clone()]).plain()).collect();
        format!(
            "{when}, {name} is at a distance {} from {centre}, with the momentum {}",
            place.radius.0.plain(),
            momenta.join(" and ")
        )
    };
    let wording = Wording {
        title: format!("Angular impulse-momentum diagram of {phrase}"),
        description: sentences([place(&before, "before"), change, place(&after, "after")]),
        caption: sentences([format!(
            "about {centre}: angular momentum before + angular impulse = angular momentum after, for {name}"
        )]),
    };
    let particle =
        AngularMomentum { name: body_math(body), before: before.state(&mass), impulse, after: after.state(&mass) };
    AngularDiagram { wording, centre: body_math(about), particles: vec![particle], axes: Vec::new() }.drawing()
}

impl Quantities<'_> {
    /// The name of a point in a sentence.
    pub(super) fn point(&self, point: &str) -> String {
        self.scene().point(point).to_owned()
    }
}
