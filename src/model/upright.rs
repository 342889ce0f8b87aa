//! The conditions of weight on a scene: a vertical plane, and an axis that points up or down, or along the string over a pulley.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::stage::Taut;

/// The axis along which bodies on a string over a pulley move.
const ALONG: &str = "`axes: { x: [along the string, back along the string] }`";

/// A body that moves by its weight needs a plane in which weight acts.
pub(super) fn not_vertical(scene: &Scene, what: &str, at: &Path) -> Vec<Fault> {
    let fault = || Fault::new(Code::Value, format!("{what} needs a vertical plane"));
    let fault = (scene.plane != Plane::Vertical).then(|| fault().help("write `plane: vertical` under `scene`"));
    fault.map(|fault| fault.at_path(at.clone())).into_iter().collect()
}

/// A body that falls does so along an axis.
pub(super) fn falling(scene: &Scene, index: usize, body: &str, at: &Path) -> Vec<Fault> {
    let mut faults = not_vertical(scene, "a fall", at);
    let on_a_string = scene.axes.rectangular().len() == 1 && scene.sinks(index, body).is_some();
    if !has_upright_axis(scene) && !on_a_string {
        let fault = Fault::new(Code::Value, "no axis of the scene points up or down, so that nothing falls along it");
        let help = format!(
            "write `axes: {{ y: downwards }}`; where the body hangs on a string over a pulley afterwards, {ALONG}"
        );
        faults.push(fault.help(help).at_path(at.clone()));
    }
    faults
}

/// Over a pulley one body rises while the other sinks: no vertical axis tells both.
pub(super) fn over_a_pulley(scene: &Scene, stage: &Taut, at: &Path) -> Vec<Fault> {
    if stage.over.is_none() || !has_upright_axis(scene) {
        return Vec::new();
    }
    let message =
        "over a pulley one body moves up while the other moves down, so that velocities are counted along the string";
    let fault = Fault::new(Code::Value, message).help(format!("write {ALONG}")).at_path(at.key("over"));
    vec![fault]
}

/// A flight with an axis that points up or down, in a plane in which no weight acts.
pub(super) fn weightless(scene: &Scene, at: &Path) -> Vec<Fault> {
    // In space, far from everything, nothing weighs anything.
    let in_space = scene.axes.rectangular().len() > 2;
    if in_space || scene.plane == Plane::Vertical || !has_upright_axis(scene) {
        return Vec::new();
    }
    let message = "an axis points up or down, but no weight acts in the horizontal plane of the scene";
    let help = "write `plane: vertical` under `scene`, or call the axis otherwise, as in `y: away from you`";
    vec![Fault::new(Code::Value, message).help(help).at_path(at.clone())]
}

fn has_upright_axis(scene: &Scene) -> bool {
    scene.axes.rectangular().iter().any(|(_, senses)| senses.rise().is_some())
}
