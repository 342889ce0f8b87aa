//! A scene at one instant: a particle seen from a fixed point, or several with their centre of mass.

use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::name_math;
use momentous_figure::Central;
use momentous_figure::Drawing;
use momentous_figure::LabelledVector;
use momentous_figure::Layout;
use momentous_figure::MassCentre;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_figure::PlacedParticle;
use momentous_figure::Situation;
use momentous_figure::Space;
use momentous_figure::Travel;
use momentous_figure::Wording;
use momentous_scene::Axis;

use super::super::wording::capitalised;
use super::compass::Compass;
use super::labels::ORIGIN;
use super::labels::body_math;
use super::quantities::Quantities;
use super::quantities::Scope;
use super::sheet;
use super::vectors::Labelled;
use super::words::OBLIQUE;
use super::words::arrows;
use super::words::sentences;
use momentous_scene::list;

/// A body in space seen from a fixed point, at the start; none where its place may not be shown.
pub(super) fn in_space(quantities: &Quantities<'_>, compass: &Compass) -> Option<Drawing> {
    let ([body], [_, _, _]) = (&quantities.timeline.alive(1)[..], &quantities.axes[..]) else { return None };
    let mut points = quantities.scene().points.iter();
    let (first, _) = points.next()?;
    let mut legs = Vec::new();
    for (position, axis) in quantities.axes.iter().enumerate() {
        let name = format!("r_{body}1.{}", axis.letter());
        let value = quantities.named(&name)?;
        legs.push(LabelledVector::known(name_math(&name), quantities.along(position, value)));
    }
    let known = quantities.velocity(body, 1).is_some();
    let vectors = match quantities.scope() {
        Scope::Given => quantities.motion(compass, body, 1),
        Scope::Solved if known => {
            vec![Moving::momentum(quantities.momentum(body, body, 1, Some(1.0)).placed(compass))]
        }
        Scope::Solved => return None,
    };
    let others = points.filter_map(|(name, point)| {
        let part = |axis: &Axis| match point.at.get(*axis) {
            Some(term) => quantities.evaluate(&quantities.term(term)?),
            None => Some(0.0),
        };
        let at: Vec<f64> = quantities.axes.iter().map(part).collect::<Option<_>>()?;
        Some(LabelledVector::known(body_math(name), quantities.along_axes(&at)?))
    });
    let points: Vec<LabelledVector> = others.collect();
    let (name, centre) = (quantities.called(body), quantities.point(first));
    let what = if quantities.scope() == Scope::Given { "velocity" } else { "momentum" };
    let shown = if vectors.is_empty() { name.clone() } else { format!("the {what} of {name}") };
    let words = format!("{shown}, relative to {centre}");
    let body = MovingBody { vectors, ..MovingBody::new(body_math(body)) };
    let wording = Wording {
        title: capitalised(&format!("{name} and {centre}")),
        description: sentences([words.clone(), list(&arrows(&body, false))]),
        caption: sentences([words, OBLIQUE.to_owned()]),
    };
    let space = Space { centre: body_math(first), legs, points, body };
    Some(Situation { wording, layout: Layout::Space(space), axes: compass.marks() }.drawing())
}

/// Bodies on which forces act, where they are when that begins; none where their places may not be shown.
pub(super) fn pushed(quantities: &Quantities<'_>, compass: &Compass) -> Option<Drawing> {
    let bodies = quantities.timeline.alive(1);
    let places = bodies.iter().map(|body| quantities.position(body, 1)).collect::<Option<Vec<[f64; 2]>>>();
    places.filter(|_| quantities.axes.len() == 2).map(|places| mass_centre(quantities, compass, &bodies, &places))
}

/// The figure of a scene without stages: with momenta or a centre of mass where it belongs to a solution.
pub(super) fn drawing(quantities: &Quantities<'_>, compass: &Compass) -> Option<Drawing> {
    if let Some(drawing) = in_space(quantities, compass) {
        return Some(drawing);
    }
    let bodies = quantities.timeline.alive(1);
    let places: Option<Vec<[f64; 2]>> = bodies.iter().map(|body| quantities.position(body, 1)).collect();
    match (&bodies[..], places, quantities.scene().points.keys().next()) {
        ([body], Some(places), Some(point)) => Some(about_point(quantities, compass, body, *places.first()?, point)),
        (_, Some(places), _) => Some(mass_centre(quantities, compass, &bodies, &places)),
        _ => sheet::line::drawing(quantities, compass, 0),
    }
}

fn about_point(quantities: &Quantities<'_>, compass: &Compass, body: &str, place: [f64; 2], point: &str) -> Drawing {
    let vectors = match quantities.scope() {
        Scope::Given => quantities.motion(compass, body, 1),
        Scope::Solved => {
            let components = quantities.momentum_components(body, 1);
            components.iter().map(|momentum| Moving::momentum(momentum.placed(compass))).collect()
        }
    };
    let (name, centre) = (quantities.called(body), quantities.point(point));
    let letters = quantities.axes.iter().map(|axis| name_math(&format!("r_{body}1.{}", axis.letter())));
    let mut legs: Vec<Math> = letters.collect();
    // The first leg is the horizontal one.
    if compass.place([1.0, 0.0])[0] == 0.0 {
        legs.reverse();
    }
    let legs = <[Math; 2]>::try_from(legs).ok();
    let shown: Vec<String> = vectors.iter().map(|moving| moving.vector.label.plain()).collect();
    let what = match quantities.scope() {
        Scope::Given => "velocity",
        Scope::Solved => "momentum",
    };
    let arrows = if shown.is_empty() { String::new() } else { format!(", with the {what} {}", list(&shown)) };
    let central = Central {
        centre: body_math(point),
        angle: compass.angle(place),
        radius: None,
        legs,
        body: MovingBody { vectors, ..MovingBody::new(body_math(body)) },
        path: None,
        other_end: None,
        moment: None,
    };
    let wording = Wording {
        title: capitalised(&format!("{name} and {centre}")),
        description: sentences([format!("{name}, relative to {centre}{arrows}")]),
        caption: sentences([format!("the {what} of {name}, relative to {centre}")]),
    };
    Situation { wording, layout: Layout::Central(central), axes: compass.marks() }.drawing()
}

fn mass_centre(quantities: &Quantities<'_>, compass: &Compass, bodies: &[&str], places: &[[f64; 2]]) -> Drawing {
    let particle = |body: &str, place: [f64; 2]| {
        let velocity =
            Labelled { label: name_math(&quantities.velocity_name(body, 1)), value: quantities.velocity(body, 1) };
        PlacedParticle {
            name: body_math(body),
            position: compass.place(place),
            velocity: velocity.value.map(|_| velocity.placed(compass)),
            forces: quantities.forces_on(compass, body, 0).into_iter().map(|force| force.vector).collect(),
        }
    };
    let centre = quantities.position("G", 1).map(|place| particle("G", place));
    let names: Vec<String> = bodies.iter().map(|body| quantities.called(body)).collect();
    let (names, with) = (list(&names), if centre.is_some() { ", and their centre of mass G" } else { "" });
    let particles: Vec<PlacedParticle> =
        bodies.iter().zip(places).map(|(body, place)| particle(body, *place)).collect();
    let forces = particles.iter().any(|particle| !particle.forces.is_empty());
    let velocities = if forces { "velocities and the forces on them" } else { "velocities" };
    let wording = Wording {
        title: format!("Positions and velocities of {names}"),
        description: sentences([format!("{names} at their positions with their {velocities}{with}")]),
        caption: sentences([format!("{names} with their {velocities}{with}")]),
    };
    let (origin, axes) = (Some(origin(quantities)), compass.marks());
    MassCentre { wording, particles, centre, arrows: Travel::Velocity, origin, axes }.drawing()
}

/// Bodies where they were before a stage, with their ways to where they are after it; the centre of mass where it is known.
pub(super) fn displacements(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    bodies: &[String],
) -> Option<Drawing> {
    let [before, after] = [index + 1, index + 2];
    let particle = |body: &str| {
        let from = quantities.position(body, before)?;
        let moved = quantities.position(body, after).map(|to| [to[0] - from[0], to[1] - from[1]]);
        let [from_name, to_name] = [before, after].map(|instant| name_math(&format!("r_{body}{instant}")));
        let label = Math::Row(vec![to_name, Math::Operator(Operator::Minus), from_name]);
        Some(PlacedParticle {
            name: body_math(body),
            position: compass.place(from),
            velocity: moved.map(|way| LabelledVector::known(label, compass.place(way))),
            forces: Vec::new(),
        })
    };
    let particles: Vec<PlacedParticle> = bodies.iter().map(|body| particle(body)).collect::<Option<_>>()?;
    let names: Vec<String> = bodies.iter().map(|body| quantities.called(body)).collect();
    let (names, centre) = (list(&names), particle("G").map(|particle| PlacedParticle { velocity: None, ..particle }));
    let mut told = vec![format!("{names} at their positions {}", quantities.when(before))];
    if particles.iter().any(|particle| particle.velocity.is_some()) {
        told.push(format!("the arrows lead to their positions {}", quantities.when(after)));
    }
    if centre.is_some() {
        told.push("G is their centre of mass".to_owned());
    }
    let wording = Wording {
        title: format!("Positions of {names}"),
        description: sentences(told.clone()),
        caption: sentences(told),
    };
    let (origin, axes) = (Some(origin(quantities)), compass.marks());
    Some(MassCentre { wording, particles, centre, arrows: Travel::Displacement, origin, axes }.drawing())
}

/// The point from which places are told.
fn origin(quantities: &Quantities<'_>) -> Math {
    let points = &quantities.scene().points;
    let named = points.iter().find(|(_, point)| point.at.axes().next().is_none()).map(|(name, _)| body_math(name));
    named.unwrap_or_else(|| Math::Identifier(ORIGIN.to_owned()))
}
