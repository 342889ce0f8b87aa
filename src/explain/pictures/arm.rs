//! Particles on one arm: several that turn together, and one that strikes it.

use std::f64::consts::FRAC_PI_2;
use std::f64::consts::PI;
use std::f64::consts::TAU;

use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::AngularImpulse;
use momentous_figure::Arm;
use momentous_figure::ArmDiagram;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::Moment;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::OnArm;
use momentous_figure::Role;
use momentous_figure::Situation;
use momentous_figure::Wording;
use momentous_scene::Strength;
use momentous_scene::Term;
use momentous_scene::stage::Rotate;
use momentous_scene::stage::Strike;

use super::super::wording::capitalised;
use super::angular::moment_impulse;
use super::angular::nothing;
use super::labels::body_math;
use super::labels::product;
use super::quantities::Quantities;
use super::sense::given_moment;
use super::words::sentences;
use momentous_scene::list;

/// Words in the name of a rotor that is drawn as a disc.
const DISCS: &[&str] = &["carousel", "disc", "disk", "flywheel", "platform", "roundabout", "turntable", "wheel"];

/// A body on an arm, or one that strikes it, as a scene has it.
struct Carried<'a> {
    body: &'a str,
    distances: [&'a Term; 2],
    angle: f64,
    strikes: bool,
}

fn held(stage: &Rotate) -> Vec<Carried<'_>> {
    let held = stage.held();
    let many = f64::from(u16::try_from(held.len()).unwrap_or(u16::MAX));
    // Two lie on a straight arm; more are spread evenly, the first at the top.
    let first = if held.len() == 2 { 0.0 } else { FRAC_PI_2 };
    let places = (0_u16..).map(|place| first + TAU * f64::from(place) / many);
    let carried = held.into_iter().zip(places);
    carried.map(|((body, arm), angle)| Carried { body, distances: arm.ends(), angle, strikes: false }).collect()
}

fn struck(stage: &Strike) -> Vec<Carried<'_>> {
    let on_arm = stage.carries.iter().zip([0.0, PI, FRAC_PI_2, -FRAC_PI_2]);
    let striking = Carried { body: &stage.body, distances: [&stage.at; 2], angle: 0.0, strikes: true };
    on_arm
        .map(|((body, at), angle)| Carried { body, distances: [at; 2], angle, strikes: false })
        .chain([striking])
        .collect()
}

/// Several bodies on an arm at the start.
pub(super) fn sheet(quantities: &Quantities<'_>, stage: &Rotate) -> Drawing {
    let mut turns: Vec<(Moment, Role)> = turning(quantities, 1).into_iter().collect();
    let acts = stage.moment.as_ref().and_then(|strength| given_moment(quantities, strength, stage.during.as_ref()));
    turns.extend(acts.map(|moment| (moment, Role::Force)));
    let pushes = |body: &str, angle: f64| along_path(quantities, stage, body, angle);
    situation(quantities, &held(stage), (&stage.about, stage.rotor.as_deref()), turns, &pushes)
}

/// A body that comes to an arm.
pub(super) fn strike_sheet(quantities: &Quantities<'_>, stage: &Strike) -> Drawing {
    situation(
        quantities,
        &struck(stage),
        (&stage.about, stage.rotor.as_deref()),
        turning(quantities, 1).into_iter().collect(),
        &|_, _| Vec::new(),
    )
}

/// The angular velocity at an instant, where it may be shown.
pub(super) fn turning(quantities: &Quantities<'_>, instant: usize) -> Option<(Moment, Role)> {
    let name = format!("omega_{instant}");
    if let Some(label) = quantities.asked_name(&name) {
        return Some((Moment { label, value: 1.0 }, Role::Velocity));
    }
    let value = quantities.named(&name).filter(|value| *value != 0.0)?;
    Some((Moment { label: name_math(&name), value }, Role::Velocity))
}

fn situation(
    quantities: &Quantities<'_>,
    all: &[Carried<'_>],
    (about, rotor): (&str, Option<&str>),
    turns: Vec<(Moment, Role)>,
    pushes: &dyn Fn(&str, f64) -> Vec<Moving>,
) -> Drawing {
    let particles = all.iter().map(|carried| {
        let name = quantities.velocity_name(carried.body, 1);
        let shown = quantities.named(&name).filter(|_| carried.strikes || turns.is_empty());
        let vector = |value| Moving::velocity(LabelledVector::known(name_math(&name), across(carried.angle, value)));
        let vectors = shown.map(vector).into_iter().chain(pushes(carried.body, carried.angle)).collect();
        on_arm(quantities, carried, 0, vectors)
    });
    let particles: Vec<OnArm> = particles.collect();
    let (names, centre) = (names(quantities, all, rotor), quantities.point(about));
    let arcs = turns.iter().map(|(turn, role)| {
        let sense = if turn.value < 0.0 { "clockwise" } else { "counter-clockwise" };
        let what = if *role == Role::Force { "the moment" } else { "the angular velocity" };
        format!("{what} {} is {sense}", turn.label.plain())
    });
    let pushed = all.iter().zip(&particles).flat_map(|(carried, particle)| {
        let forces = particle.body.vectors.iter().filter(|moving| moving.role == Role::Force);
        forces.map(|force| {
            format!("the force {} acts on {}", force.vector.label.plain(), quantities.called(carried.body))
        })
    });
    let pushed: Vec<String> = pushed.collect();
    let words = format!("{names} about {centre}, seen along the axis");
    let wording = Wording {
        title: capitalised(&format!("{names} and {centre}")),
        description: sentences([words.clone()].into_iter().chain(pushed).chain(arcs)),
        caption: sentences([words]),
    };
    let arm = Arm { centre: body_math(about), particles, disc: disc(quantities, all, rotor), turns };
    Situation { wording, layout: Layout::Arm(arm), axes: Vec::new() }.drawing()
}

/// A transverse vector where a body is drawn at that angle.
fn across(angle: f64, value: f64) -> [f64; 2] {
    [-value * libm::sin(angle), value * libm::cos(angle)]
}

/// The forces along the path of a body drawn at that angle that are given.
pub(super) fn along_path(quantities: &Quantities<'_>, stage: &Rotate, body: &str, angle: f64) -> Vec<Moving> {
    let driving = stage.driving().filter(|(_, on)| on.is_some_and(|(on, _)| on == body));
    let arrow = |strength: &Strength| {
        let Strength::Term(term) = strength else { return None };
        let term = quantities.term(term)?;
        let clock = quantities.model().symbols.find("t").filter(|clock| term.contains(*clock));
        // A force that changes has no one length; its arrow shows where it points.
        let (label, size) = match clock {
            Some(_) => {
                let told = term.all_symbols(&|symbol| Some(symbol) == clock || quantities.value(symbol).is_some());
                let sense = || quantities.sense(&term, quantities.ends(stage.during.as_ref())?);
                // One that is asked for is drawn in the sense in which it counts.
                let sense = if told { sense()? } else { 1.0 };
                (Math::Identifier("F".to_owned()), sense.signum())
            }
            None => (quantities.unsigned(&term), quantities.evaluate(&term)?),
        };
        Some(Moving::force(LabelledVector::known(label, across(angle, size))))
    };
    driving.filter_map(|(force, _)| arrow(&force.value)).collect()
}

fn on_arm(quantities: &Quantities<'_>, carried: &Carried<'_>, side: usize, vectors: Vec<Moving>) -> OnArm {
    let distance = quantities.term(carried.distances[side]);
    let value = distance.as_ref().and_then(|distance| quantities.evaluate(distance));
    // The body comes from the side from which it moves towards the arm.
    let named = |name: String| quantities.named(&name).unwrap_or(0.0);
    let arm = named("omega_1".to_owned()) * value.unwrap_or(0.0);
    let comes = named(quantities.velocity_name(carried.body, 1)) - arm;
    OnArm {
        body: MovingBody { vectors, ..MovingBody::new(body_math(carried.body)) },
        distance: value.unwrap_or(1.0),
        label: quantities.label_of(carried.distances[side]),
        angle: carried.angle,
        beside: if carried.strikes { if comes < 0.0 { 1.0 } else { -1.0 } } else { 0.0 },
    }
}

/// Whether a body that turns is a disc.
pub(super) fn is_disc(quantities: &Quantities<'_>, rotor: &str) -> bool {
    quantities.words(rotor).iter().any(|word| DISCS.contains(&word.as_str()))
}

/// The radius of a rotor that is a disc: that of the outermost place on it.
fn disc(quantities: &Quantities<'_>, all: &[Carried<'_>], rotor: Option<&str>) -> Option<f64> {
    let is_disc = is_disc(quantities, rotor?);
    let places = all.iter().filter(|carried| !carried.strikes).flat_map(|carried| carried.distances);
    let known = places.map(|place| quantities.evaluate(&quantities.term(place)?));
    known.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::max).filter(|_| is_disc)
}

fn names(quantities: &Quantities<'_>, all: &[Carried<'_>], rotor: Option<&str>) -> String {
    list(&all.iter().map(|carried| carried.body).chain(rotor).map(|body| quantities.called(body)).collect::<Vec<_>>())
}

/// The diagram of several bodies on an arm.
pub(super) fn rotation(quantities: &Quantities<'_>, index: usize, stage: &Rotate) -> Option<Drawing> {
    let all = held(stage);
    let rotor = stage.rotor.as_deref();
    let (before, first) = arm(quantities, index, &all, (&stage.about, rotor), (0, None))?;
    // What nobody asks for may not be solved: without a moment it follows.
    let resists = |carried: &Carried<'_>| {
        let distance = quantities.evaluate(&quantities.term(carried.distances[1])?)?;
        Some(quantities.mass(carried.body, index + 1)? * distance * distance)
    };
    let carried: Option<f64> = all.iter().map(resists).sum();
    let inertia = match rotor {
        Some(rotor) => inertia(quantities, rotor).map(|(_, value)| value),
        None => Some(0.0),
    };
    let whole = carried.zip(inertia).map(|(carried, inertia)| carried + inertia);
    let turn = whole.filter(|_| stage.moment.is_none()).map(|whole| first / whole);
    let (after, last) = arm(quantities, index, &all, (&stage.about, rotor), (1, turn))?;
    let gained = if stage.moment.is_some() { last - first } else { 0.0 };
    let impulse = AngularImpulse { label: moment_impulse(quantities, index, stage), value: Some(gained) };
    Some(diagram(quantities, index, [before, after], impulse, (&all, &stage.about, rotor)))
}

/// The diagram of a body that strikes an arm.
pub(super) fn strike(quantities: &Quantities<'_>, index: usize, stage: &Strike) -> Option<Drawing> {
    let all = struck(stage);
    let rotor = stage.rotor.as_deref();
    let [before, after] = [0, 1].map(|side| arm(quantities, index, &all, (&stage.about, rotor), (side, None)));
    let impulse = AngularImpulse { label: nothing(&stage.about), value: Some(0.0) };
    Some(diagram(quantities, index, [before?.0, after?.0], impulse, (&all, &stage.about, rotor)))
}

/// The arm at one end with the momenta of what it carries, and their moment about the centre; with an angular velocity for
/// where none was solved.
fn arm(
    quantities: &Quantities<'_>,
    index: usize,
    all: &[Carried<'_>],
    (about, rotor): (&str, Option<&str>),
    (side, turn): (usize, Option<f64>),
) -> Option<(Arm, f64)> {
    let mut moment = 0.0;
    let mut particles = Vec::new();
    for carried in all {
        let name = quantities.velocity_name(carried.body, index + 1 + side);
        let distance = quantities.evaluate(&quantities.term(carried.distances[side])?)?;
        let turns = || Some(quantities.named(&format!("omega_{}", index + 1 + side)).or(turn)? * distance);
        let momentum = quantities.mass(carried.body, index + 1)? * quantities.named(&name).or_else(turns)?;
        moment += momentum * distance;
        let label = product([quantities.mass_math(carried.body, index + 1), name_math(&name)]);
        let vector = LabelledVector::known(label, across(carried.angle, momentum));
        particles.push(on_arm(quantities, carried, side, vec![Moving::momentum(vector)]));
    }
    let mut turns = Vec::new();
    if let Some(rotor) = rotor {
        let (label, inertia) = inertia(quantities, rotor)?;
        let name = format!("omega_{}", index + 1 + side);
        let momentum = inertia * quantities.named(&name).or(turn)?;
        moment += momentum;
        if momentum != 0.0 {
            turns.push((Moment { label: product([label, name_math(&name)]), value: momentum }, Role::Momentum));
        }
    }
    Some((Arm { centre: body_math(about), particles, disc: disc(quantities, all, rotor), turns }, moment))
}

/// The moment of inertia of what carries the particles, as it is written and in numbers.
fn inertia(quantities: &Quantities<'_>, rotor: &str) -> Option<(Math, f64)> {
    let term = quantities.term(quantities.scene().bodies.get(rotor)?.inertia.as_ref()?)?;
    Some((quantities.symbolic(&term), quantities.evaluate(&term)?))
}

fn diagram(
    quantities: &Quantities<'_>,
    index: usize,
    [before, after]: [Arm; 2],
    impulse: AngularImpulse,
    (all, about, rotor): (&[Carried<'_>], &str, Option<&str>),
) -> Drawing {
    let (names, centre) = (names(quantities, all, rotor), quantities.point(about));
    let phrase = quantities.model().phrase(quantities.scene(), index);
    let change = match impulse.value {
        Some(0.0) => "no angular impulse acts about it",
        Some(value) if value < 0.0 => "the angular impulse about it acts clockwise",
        _ => "the angular impulse about it acts counter-clockwise",
    };
    let momenta = |arm: &Arm| {
        let each = arm.particles.iter().flat_map(|particle| &particle.body.vectors).map(|moving| &moving.vector.label);
        let turning = arm.turns.iter().map(|(moment, _)| &moment.label);
        list(&each.chain(turning).map(Math::plain).collect::<Vec<_>>())
    };
    let turning = |when: &str, arm: &Arm| match momenta(arm) {
        all if all.is_empty() => format!("{when}, nothing turns about {centre}"),
        all => format!("{when}, there is {all} of {names} about {centre}"),
    };
    let ends = match rotor {
        Some(_) => [turning("before", &before), turning("after", &after)],
        None => [
            format!("before, {names} have the momenta {} at right angles to the arm about {centre}", momenta(&before)),
            format!("after, they have {}", momenta(&after)),
        ],
    };
    let [first, last] = ends;
    let wording = Wording {
        title: format!("Angular impulse-momentum diagram of {phrase}"),
        description: sentences([first, change.to_owned(), last]),
        caption: sentences([format!(
            "about {centre}: angular momentum before + angular impulse = angular momentum after, for {names}"
        )]),
    };
    ArmDiagram { wording, before, impulse, after }.drawing()
}
