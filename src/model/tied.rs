//! The condition of a string over a pulley on the stages before it: both of its bodies have one speed when it begins to pull.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Connected;

use super::stage::Description;

/// An impact or a blow changes the velocity of one end alone; then the string jerks, which is a stage of its own.
pub(super) fn jerked(scene: &Scene, index: usize, string: &Connected, at: &Path) -> Vec<Fault> {
    let ends @ [trailing, leading] = [string.trailing.body.as_str(), string.leading.body.as_str()];
    let changed = |stage: &Stage, end: &str| {
        let whole = stage.whole_and_parts().map(|(whole, _)| whole);
        Description::of(scene, stage).changed().into_iter().chain(whole).any(|body| body == end)
    };
    let mut earlier = scene.stages.iter().take(index).rev();
    let last = earlier.find(|stage| ends.iter().any(|end| changed(stage, end)));
    let Some(stage @ (Stage::Impact(_) | Stage::Blow(_))) = last else { return Vec::new() };
    if ends.iter().all(|end| changed(stage, end)) {
        return Vec::new();
    }
    let noun = Description::of(scene, stage).noun;
    let message = format!(
        "the {noun} before this stage changes the velocity at one end of the string only, and a taut string gives both ends one"
    );
    let pulley = string.over.as_deref().unwrap_or("the pulley");
    let help = format!(
        "write the jerk of the string as a stage between the two: `taut: {{ between: [{trailing}, {leading}], over: {pulley} }}`"
    );
    vec![Fault::new(Code::Value, message).help(help).at_path(at.clone())]
}
