//! Bodies along a line: on a track before an impact, or one that is pushed or struck.

use crate::figure::Drawing;
use crate::figure::Form;
use crate::figure::Layout;
use crate::figure::Line;
use crate::figure::Moving;
use crate::figure::MovingBody;
use crate::figure::Situation;
use crate::model::ForceKind;
use crate::scene::Plane;
use crate::scene::Stage;
use crate::scene::stage::Partners;

use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::words::situation_wording;

/// The bodies before a stage; after the last one, where nothing is given of them before. In a solution with their momenta.
pub(in super::super) fn drawing(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Option<Drawing> {
    let last = quantities.timeline.last();
    let before = bodies(quantities, compass, stage);
    let is_telling = |bodies: &[(String, MovingBody)]| bodies.iter().any(|(_, body)| !body.vectors.is_empty());
    let rebounds = |body: &str| !departure(quantities, compass, body, stage).is_empty();
    let after = || {
        let alive = quantities.timeline.alive(last);
        let body = |body: &str| (body.to_owned(), quantities.body(body, quantities.motion(compass, body, last)));
        alive.into_iter().map(body).collect::<Vec<_>>()
    };
    // A sheet that tells of no motion still shows the bodies and the axes.
    let shows_before = is_telling(&before) || !is_telling(&after()) && quantities.scope() == Scope::Given;
    let (when, bodies) = if shows_before {
        let both = before.iter().any(|(body, _)| rebounds(body));
        let when = quantities.when(stage + 1);
        (if both { format!("{when} and {}", quantities.when(stage + 2)) } else { when }, before)
    } else {
        (quantities.when(last), after())
    };
    if bodies.is_empty() || quantities.scope() == Scope::Solved && !is_telling(&bodies) {
        return None;
    }
    let wording = situation_wording(quantities, &bodies, &when);
    let floor = has_floor(quantities, stage, &bodies);
    let bodies = bodies.into_iter().map(|(_, body)| body).collect();
    let line = Line { angle: compass.axis_angle(0), bodies, floor, slope: None };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

/// The bodies with their momenta after a stage that has no impulses to draw.
pub(in super::super) fn after(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Option<Drawing> {
    let instant = stage + 2;
    let bodies: Vec<(String, MovingBody)> = quantities
        .timeline
        .alive(instant)
        .into_iter()
        .map(|body| {
            let momentum = quantities.momentum(body, body, instant, quantities.mass(body));
            (body.to_owned(), quantities.body(body, vec![Moving::momentum(momentum.placed(compass))]))
        })
        .collect();
    if bodies.is_empty() {
        return None;
    }
    let wording = situation_wording(quantities, &bodies, &quantities.when(instant));
    let bodies = bodies.into_iter().map(|(_, body)| body).collect();
    let line = Line { angle: compass.axis_angle(0), bodies, floor: true, slope: None };
    Some(Situation { wording, layout: Layout::Line(line), axes: compass.marks() }.drawing())
}

fn bodies(quantities: &Quantities<'_>, compass: &Compass, stage: usize) -> Vec<(String, MovingBody)> {
    let vectors = |body: &String| {
        if quantities.scope() == Scope::Solved {
            let momentum = quantities.momentum(body, body, stage + 1, quantities.mass(body));
            return vec![Moving::momentum(momentum.placed(compass))];
        }
        let before = quantities.motion(compass, body, stage + 1);
        let mut vectors: Vec<Moving> = if is_struck(quantities, body, stage) {
            before.into_iter().map(Moving::arriving).collect()
        } else {
            before
        };
        vectors.extend(departure(quantities, compass, body, stage));
        vectors.extend(quantities.impulses_on(compass, body, stage));
        vectors.extend(quantities.forces_on(compass, body, stage));
        vectors
    };
    let order = order(quantities, stage);
    order.into_iter().map(|body| (body.clone(), quantities.body(&body, vectors(&body)))).collect()
}

/// A struck body comes and goes: the velocity with which it goes belongs to the picture, where it is given.
fn departure(quantities: &Quantities<'_>, compass: &Compass, body: &str, stage: usize) -> Vec<Moving> {
    if is_struck(quantities, body, stage) { quantities.motion(compass, body, stage + 2) } else { Vec::new() }
}

fn is_struck(quantities: &Quantities<'_>, body: &str, stage: usize) -> bool {
    matches!(quantities.scene().stages.get(stage), Some(Stage::Blow(blow)) if blow.body == body)
}

/// The bodies from back to front: in an impact, the second body lies ahead of the first.
fn order(quantities: &Quantities<'_>, stage: usize) -> Vec<String> {
    let mut order: Vec<String> = Vec::new();
    let place = |order: &Vec<String>, body: &str| order.iter().position(|own| own == body);
    for own in &quantities.scene().stages {
        let Stage::Impact(impact) = own else { continue };
        let Some(Partners::Bodies(first, second)) = impact.partners() else { continue };
        match (place(&order, first), place(&order, second)) {
            (None, None) => order.extend([first.to_owned(), second.to_owned()]),
            (Some(behind), None) => order.insert(behind + 1, second.to_owned()),
            (None, Some(ahead)) => order.insert(ahead, first.to_owned()),
            (Some(_), Some(_)) => {}
        }
    }
    let alive = quantities.timeline.alive(stage + 1);
    order.retain(|body| alive.contains(&body.as_str()));
    let others: Vec<&str> = alive.into_iter().filter(|body| place(&order, body).is_none()).collect();
    order.extend(others.into_iter().map(str::to_owned));
    order
}

/// A floor is drawn under what rubs on it, and under vehicles that meet on a level line.
fn has_floor(quantities: &Quantities<'_>, stage: usize, bodies: &[(String, MovingBody)]) -> bool {
    let rubs = quantities.model().forces.iter().any(|force| force.stage == stage && force.kind == ForceKind::Normal);
    let level = quantities.scene().plane == Plane::Horizontal && quantities.axes.len() == 1;
    let vehicles = bodies.len() > 1 && bodies.iter().all(|(_, body)| body.form == Form::Block);
    rubs || level && vehicles
}
