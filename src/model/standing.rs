//! Conditions stated outside the stages that act in each of them: a guide, weight in the plane, the slope of an axis, the bonds
//! between bodies. A stage takes account of it, or is refused; none passes it over.

#![deny(clippy::wildcard_enum_match_arm)]

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Flight;
use momentous_scene::stage::Push;

use super::name::MASS_CENTRE;
use super::stage::Description;
use super::timeline::Timeline;

/// The account that a stage takes of something stated outside it.
enum Account {
    /// Its equations hold it, or nothing of it acts in such a stage.
    Taken,
    /// Its equations do not hold it, and this is the way out.
    Missing(&'static str),
}

/// The way out where a stage has no equations for a guided body.
const ALONG_THE_GUIDE: &str =
    "keep the axis along the guide as the only one, such as `axes: { x: along the rod }`, and remove the `guide`";

/// The way out where a stage has no equations for weight in its plane.
const LEVEL: &str = "write `plane: horizontal`, or remove `plane`";

/// Whatever acts in a stage by what is said elsewhere, and has no place in its equations.
pub(super) fn faults(scene: &Scene, timeline: &Timeline) -> Vec<Fault> {
    let mut faults: Vec<Fault> = guides_off_the_line(scene);
    for (index, stage) in scene.stages.iter().enumerate() {
        let at = Path::root().key("scene").key("stages").index(index).key(stage.key());
        let noun = Description::of(scene, stage).noun;
        if let Account::Missing(help) = guide(stage) {
            for body in takes_part(scene, timeline, index, stage).into_iter().filter(|body| is_guided(scene, body)) {
                let message = format!("the {noun} has no equations for {}, which a guide holds", scene.called(body));
                faults.push(Fault::new(Code::Value, message).help(help).at_path(at.clone()));
            }
        }
        if scene.plane == Plane::Vertical
            && let Account::Missing(help) = weight(scene, stage)
        {
            let message = format!("weight acts in a vertical plane, and the {noun} has no equations for it");
            faults.push(Fault::new(Code::Value, message).help(help).at_path(at.clone()));
        }
        if let Some((message, help)) = untold_slope(scene, stage) {
            faults.push(Fault::new(Code::Value, message).help(help).at_path(at.clone()));
        }
        let acted_on = takes_part(scene, timeline, index, stage);
        faults.extend(super::bond::broken(scene, index, stage, &acted_on).map(|fault| fault.at_path(at)));
    }
    faults
}

/// Whether the equations of a stage hold a body to its guide.
fn guide(stage: &Stage) -> Account {
    match stage {
        Stage::Impact(_)
        | Stage::Blow(_)
        | Stage::Separate(_)
        | Stage::Interact(_)
        | Stage::SlideOff(_)
        | Stage::Drift(_)
        | Stage::Push(Push { resistance: None, gains: None, loses: None, .. }) => Account::Taken,
        Stage::Push(_)
        | Stage::Slide(_)
        | Stage::Spring(_)
        | Stage::Swing(_)
        | Stage::Taut(_)
        | Stage::Connected(_)
        | Stage::Tow(_)
        | Stage::Rotate(_)
        | Stage::Moment(_)
        | Stage::Strike(_)
        | Stage::Conical(_)
        | Stage::Bowl(_)
        | Stage::Central(_)
        | Stage::Fall(_)
        | Stage::Bounces(_)
        | Stage::Stream(_)
        | Stage::Thrust(_)
        | Stage::Walk(_)
        | Stage::Flight(_)
        | Stage::Motion(_) => Account::Missing(ALONG_THE_GUIDE),
    }
}

/// Whether a stage in a vertical plane counts weight, or leaves it out with a reason that holds there.
fn weight(scene: &Scene, stage: &Stage) -> Account {
    let upright = scene.axes.rectangular().iter().any(|(_, senses)| senses.rise().is_some());
    match stage {
        Stage::Rotate(_) => Account::Missing(
            "the moment of weight changes as the arm turns, and no key says where it points: write `plane: horizontal`, or remove `plane`",
        ),
        Stage::Moment(moment) if moment.about != MASS_CENTRE => {
            Account::Missing("take the moment about the mass centre, `about: G`, or remove `plane`")
        }
        Stage::Central(_) => Account::Missing(LEVEL),
        Stage::Spring(spring) if upright && spring.between.is_some() => {
            Account::Missing("let the two bodies and their spring lie along a level axis")
        }
        Stage::Walk(_) if upright => Account::Missing("name a level axis only, such as `axes: { x: to the right }`"),
        // Sudden stages neglect weight, or include it where they are told to; the others have it in their equations.
        Stage::Impact(_)
        | Stage::Push(_)
        | Stage::Slide(_)
        | Stage::Spring(_)
        | Stage::Swing(_)
        | Stage::Taut(_)
        | Stage::Connected(_)
        | Stage::Tow(_)
        | Stage::Blow(_)
        | Stage::Moment(_)
        | Stage::Strike(_)
        | Stage::Conical(_)
        | Stage::Bowl(_)
        | Stage::Interact(_)
        | Stage::Fall(_)
        | Stage::Bounces(_)
        | Stage::Stream(_)
        | Stage::Thrust(_)
        | Stage::Drift(_)
        | Stage::Separate(_)
        | Stage::SlideOff(_)
        | Stage::Walk(_)
        | Stage::Flight(_)
        | Stage::Motion(_) => Account::Taken,
    }
}

/// The bodies on which a stage acts.
fn takes_part<'a>(scene: &'a Scene, timeline: &'a Timeline, index: usize, stage: &'a Stage) -> Vec<&'a str> {
    if matches!(stage, Stage::Moment(_) | Stage::Drift(_)) {
        return timeline.alive(index + 1);
    }
    if let Stage::Separate(separate) = stage {
        return separate.into.iter().chain(&separate.from).map(String::as_str).collect();
    }
    Description::of(scene, stage).bodies.into_iter().map(|(body, _)| body).collect()
}

fn is_guided(scene: &Scene, body: &str) -> bool {
    scene.members(body).into_iter().any(|member| scene.bodies.get(member).is_some_and(|entry| entry.guide.is_some()))
}

/// On a line every body is held to it: a guide along another direction contradicts the axis.
fn guides_off_the_line(scene: &Scene) -> Vec<Fault> {
    let axes = scene.axes.rectangular();
    let off = |along: &str| axes.iter().all(|(axis, senses)| along != axis.letter() && along != senses.positive);
    let guides = scene.bodies.iter().filter_map(|(name, body)| Some((name, body.guide.as_ref()?)));
    let off_the_line = guides.filter(|(_, guide)| axes.len() < 2 && off(guide.along.0.trim()));
    let fault = |(name, _): (&String, _)| {
        let message = format!("a guide of {} needs a scene with two axes, in whose plane it lies", scene.called(name));
        let help =
            "write `axes: { x: to the right, y: upwards }`, or remove the `guide` and let the only axis run along it";
        let path = Path::root().key("scene").key("bodies").name(name.as_str()).key("guide");
        Fault::new(Code::Value, message).help(help).at_path(path)
    };
    off_the_line.map(fault).collect()
}

/// An axis along a slope or a string, along which weight acts by a share that a stage without a slope of its own does not tell.
fn untold_slope(scene: &Scene, stage: &Stage) -> Option<(String, &'static str)> {
    let can_tell = matches!(stage, Stage::Push(_) | Stage::Flight(_));
    let tells =
        matches!(stage, Stage::Push(Push { incline: Some(_), .. }) | Stage::Flight(Flight { incline: Some(_), .. }));
    let is_told = tells || !(can_tell || matches!(stage, Stage::Thrust(_) | Stage::Drift(_)));
    let axes = scene.axes.rectangular();
    let (_, senses) = axes.first().filter(|_| !is_told)?;
    let phrase = senses.positive.as_str();
    let slopes = ["slope", "incline", "hill", "ramp", "wedge", "string", "rope", "cord"];
    if scene.plane != Plane::Vertical || !slopes.iter().any(|word| phrase.contains(word)) {
        return None;
    }
    let key = stage.key();
    let message = format!("weight acts along the axis `{phrase}`, and the `{key}` does not tell how steep it is");
    let help = if can_tell {
        "write `incline: alpha`, or name a level or an upright axis"
    } else {
        "name a level or an upright axis, such as `axes: { x: to the right }`"
    };
    Some((message, help))
}
