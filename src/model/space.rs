//! Checks of a scene in three dimensions, and the places of its points.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Axes;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Moment;

use super::read::moving_point;
use super::stage::Description;
use super::stage::ROTOR;
use super::timeline::Timeline;
use super::unknown::unknown;

/// The places and directions of a scene that its axes do not allow.
pub(super) fn faults(scene: &Scene) -> Vec<Fault> {
    let Axes::Rectangular(axes) = &scene.axes else { return points(scene, &|_| false).collect() };
    let mut faults: Vec<Fault> = points(scene, &|letter| axes.keys().any(|axis| axis.letter() == letter)).collect();
    if axes.len() < 3 {
        return faults;
    }
    let at = Path::root().key("scene");
    for (index, stage) in scene.stages.iter().enumerate() {
        if !Description::of(scene, stage).fills_space {
            let message = format!("`{}` happens along a line or in a plane, but the scene has three axes", stage.key());
            let fault = Fault::new(Code::Value, message).help("keep the axes of that line or plane");
            faults.push(fault.at_path(at.key("stages").index(index).key(stage.key())));
        }
    }
    for (name, _) in scene.bodies.iter().filter(|(_, body)| body.guide.is_some()) {
        let fault = Fault::new(Code::Value, "a guide lies in a plane, but the scene has three axes");
        let path = at.key("bodies").key(name.as_str()).key("guide");
        faults.push(fault.help("keep the axes of that plane").at_path(path));
    }
    faults
}

/// Coordinates of points along axes that the scene has not.
fn points<'a>(scene: &'a Scene, has: &'a dyn Fn(&str) -> bool) -> impl Iterator<Item = Fault> + 'a {
    let at = Path::root().key("scene").key("points");
    let coordinates =
        scene.points.iter().flat_map(|(name, point)| point.at.axes().map(move |axis| (name, axis.letter())));
    coordinates.filter(|(_, letter)| !has(letter)).map(move |(name, letter)| {
        let fault = Fault::new(Code::Value, format!("the scene has no axis {letter}"));
        fault.help("give positions along the axes of the scene").at_path(at.key(name.as_str()).key("at").key(letter))
    })
}

/// The misfits of a stage in which bodies turn about a point, or act on each other in a plane or in space.
pub(super) fn turning(scene: &Scene, timeline: &Timeline, stage: &Stage, at: Path) -> Vec<Fault> {
    let axes = match &scene.axes {
        Axes::Polar(_) => 0,
        Axes::Rectangular(axes) => axes.len(),
    };
    let Description { bodies, about, axes: wanted, .. } = Description::of(scene, stage);
    let mut faults: Vec<Fault> = Vec::new();
    if let Some(point) = about {
        faults.extend(not_fixed(scene, timeline, stage, point).map(|fault| fault.at_path(at.key("about"))));
    }
    for (body, key) in &bodies {
        let inertia = scene.bodies.get(*body).is_some_and(|body| body.inertia.is_some());
        if *key == Some(ROTOR) && !inertia && scene.bodies.contains_key(*body) {
            let fault = Fault::new(Code::MissingKey, format!("{} has no moment of inertia", scene.called(body)));
            let help = format!("write `{body}: {{ name: ..., inertia: I }}` under `bodies`");
            faults.push(fault.help(help).at_path(at.key(ROTOR)));
        }
    }
    if let Stage::Moment(moment) = stage
        && let Some(rotor) = scene.rotors().next()
    {
        faults.extend(on_a_rotor(scene, moment, rotor, axes).map(|fault| fault.at_path(at.clone())));
    }
    if !wanted.contains(&axes) {
        faults.push(other_axes(stage, wanted).at_path(at.clone()));
    }
    let held = !bodies.is_empty() || matches!(stage, Stage::Moment(_));
    if !held {
        let fault = Fault::new(Code::MissingKey, "no body takes part in this stage");
        faults.push(fault.help("write `body: A` with `arm: L`, `bodies: { A: L, B: L/2 }`, or `rotor: R`").at_path(at));
    }
    faults
}

/// A moment on a body with a moment of inertia that does not turn by itself about a fixed axis.
fn on_a_rotor(scene: &Scene, moment: &Moment, rotor: &str, axes: usize) -> Option<Fault> {
    let name = scene.called(rotor);
    if axes != 2 || moment.about == "G" {
        let message = format!("{name} has a moment of inertia and turns in a plane about a fixed axis");
        let help = "keep the two axes of that plane, and name the fixed point of the axis under `about`";
        return Some(Fault::new(Code::Value, message).help(help));
    }
    (scene.rotors().count() < scene.bodies.len()).then(|| {
        let message = format!("a moment acts on {name}, which has a moment of inertia, and on particles");
        let help = format!("write `rotate` with `rotor: {rotor}`, the particles as its `bodies`, and the `moment`");
        Fault::new(Code::Value, message).help(help)
    })
}

/// A point that is not declared, or that moves.
fn not_fixed(scene: &Scene, timeline: &Timeline, stage: &Stage, point: &str) -> Option<Fault> {
    let centre = point == "G" && matches!(stage, Stage::Moment(_));
    if centre || scene.points.contains_key(point) {
        return None;
    }
    if timeline.bodies().any(|body| body == point) {
        return Some(moving_point(&scene.called(point)));
    }
    let known: Vec<&str> = scene.points.keys().map(String::as_str).collect();
    Some(unknown("point", point, &known))
}

/// A stage that has no equations in polar axes, in a scene that has them; those that turn about a point say so themselves.
pub(super) fn without_polar_axes(scene: &Scene, stage: &Stage) -> Option<Fault> {
    let is_blow = matches!(stage, Stage::Blow(_)) && scene.plane == Plane::Horizontal;
    let is_polar = matches!(scene.axes, Axes::Polar(_));
    let has_none = is_polar && !is_blow && Description::of(scene, stage).axes.is_empty();
    let message = format!("`{}` has no equations in polar axes", stage.key());
    let help = "write `axes: { x: to the right, y: upwards }`; polar axes are for `central`, with a `blow` before or after it, and for `bowl`";
    has_none.then(|| Fault::new(Code::Value, message).help(help))
}

/// A stage with other axes than its equations have.
fn other_axes(stage: &Stage, wanted: &[usize]) -> Fault {
    let (needs, help) = match wanted {
        [0] => ("polar axes", "write `axes: polar`"),
        [1] => ("one axis, along the circle", "write `axes: { x: [counter-clockwise, clockwise] }`"),
        _ => ("two or three axes", "write `axes: { x: to the right, y: upwards }`"),
    };
    Fault::new(Code::Value, format!("`{}` needs {needs}", stage.key())).help(help)
}
