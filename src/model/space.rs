//! What a scene in three dimensions can hold, and where its points are.

use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::scene::Axes;
use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Impact;

/// What a scene says of places and directions that its axes do not allow.
pub(super) fn faults(scene: &Scene) -> Vec<Fault> {
    let Axes::Rectangular(axes) = &scene.axes else { return points(scene, &|_| false).collect() };
    let mut faults: Vec<Fault> = points(scene, &|letter| axes.keys().any(|axis| axis.letter() == letter)).collect();
    if axes.len() < 3 {
        return faults;
    }
    let at = Path::root().key("scene");
    for (index, stage) in scene.stages.iter().enumerate() {
        if !fills_space(stage) {
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

/// Whether the equations of a stage hold in three dimensions.
fn fills_space(stage: &Stage) -> bool {
    match stage {
        Stage::Push(push) => push.over.is_none() && push.incline.is_none(),
        Stage::Impact(Impact { between, line_of_impact, .. }) => between.is_some() && line_of_impact.is_none(),
        Stage::Blow(_) | Stage::Separate(_) | Stage::Flight(_) | Stage::Drift(_) => true,
        _ => false,
    }
}

/// Coordinates of points along axes that the scene has not.
fn points<'a>(scene: &'a Scene, has: &'a dyn Fn(&str) -> bool) -> impl Iterator<Item = Fault> + 'a {
    let at = Path::root().key("scene").key("points");
    let coordinates =
        scene.points.iter().flat_map(|(name, point)| point.at.axes().map(move |axis| (name, axis.letter())));
    coordinates.filter(|(_, letter)| !has(letter)).map(move |(name, letter)| {
        let fault = Fault::new(Code::Value, format!("the scene has no axis {letter}"));
        fault.help("count places along the axes of the scene").at_path(at.key(name.as_str()).key("at").key(letter))
    })
}
