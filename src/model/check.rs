//! Checks of a scene before any law is written down: whether its parts fit together.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::Axes;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Separate;

use super::Name;
use super::QuantityKind;
use super::VectorName;
use super::name::MASS_CENTRE;
use super::stage::Description;
use super::stage::ROTOR;
use super::stage::is_height_of_a_bounce;
use super::stage::is_holding_pull;
use super::stored::is_spring;
use super::timeline::Timeline;
use super::unknown::unknown;
use super::upright;

/// Whether a name is one that the scene makes by itself, rather than one that the author chose.
pub(super) fn is_structural(scene: &Scene, name: &str) -> bool {
    if VectorName::parse(name).is_some() {
        return true;
    }
    let Some(name) = Name::parse(name) else { return false };
    // Only work may stand without anything else.
    if name.is_plain() && name.kind != QuantityKind::Work {
        return false;
    }
    if name.lacks_a_body() {
        return false;
    }
    let timeline = Timeline::new(scene);
    let is_sprung = is_spring(scene, &name);
    let known_subject = name.subject.is_empty()
        || is_sprung
        || name.is_of_mass_centre()
        || scene.points.contains_key(&name.subject)
        || timeline.bodies().any(|body| body == name.subject);
    known_subject
        && match name.kind {
            QuantityKind::Velocity
            | QuantityKind::Speed
            | QuantityKind::Direction(_)
            | QuantityKind::Momentum
            | QuantityKind::Impulse
            | QuantityKind::MeanForce
            | QuantityKind::KineticEnergy
            | QuantityKind::EnergyLost
            | QuantityKind::EnergyGained
            | QuantityKind::DeformationImpulse
            | QuantityKind::RestitutionImpulse
            | QuantityKind::CommonVelocity
            | QuantityKind::RelativeEnergy
            | QuantityKind::RelativeVelocity
            | QuantityKind::AngularMomentum
            | QuantityKind::Weight
            | QuantityKind::Work => true,
            QuantityKind::Mass => !scene.parts_of(&name.subject).is_empty(),
            QuantityKind::Position | QuantityKind::Coordinate(_) => !name.subject.is_empty() && name.instant.is_some(),
            QuantityKind::Height => is_height_of_a_bounce(scene, &name),
            QuantityKind::Tension => is_holding_pull(scene, &name),
            QuantityKind::MomentumRate => name.instant.is_some() && name.subject.is_empty(),
            QuantityKind::PotentialEnergy => {
                let is_weighed = scene.plane == Plane::Vertical && !name.subject.is_empty();
                name.instant.is_some() && (is_weighed || is_sprung)
            }
            QuantityKind::Period => {
                let turns = |stage: &Stage| matches!(stage, Stage::Rotate(_) | Stage::Conical(_));
                name.instant.is_some() && scene.stages.iter().any(turns)
            }
            QuantityKind::AngularVelocity => {
                let is_on_cord =
                    |stage: &Stage| matches!(stage, Stage::Conical(conical) if conical.body == name.subject);
                name.instant.is_some() && scene.stages.iter().any(is_on_cord)
            }
            QuantityKind::Moment | QuantityKind::AngularMomentumRate => {
                name.instant.is_some() && (name.is_of_mass_centre() || scene.points.contains_key(&name.subject))
            }
            _ => false,
        }
}

/// Whether a name is that of the angular impulse of a stage; a moment of inertia that has this name differs in dimension.
pub(super) fn is_angular_impulse(scene: &Scene, name: &str, dimension: Dimension) -> bool {
    let turns = |stage: &Stage| {
        matches!(stage, Stage::Strike(_) | Stage::Moment(_))
            || matches!(stage, Stage::Rotate(rotate) if rotate.is_driven())
    };
    let is_own = |name: Name| name.kind == QuantityKind::AngularImpulse && name.subject.is_empty();
    dimension == Dimension::ANGULAR_MOMENTUM && Name::parse(name).is_some_and(is_own) && scene.stages.iter().any(turns)
}

/// Every way in which the parts of a scene contradict each other.
pub(super) fn check(scene: &Scene) -> Vec<Fault> {
    let mut faults = Vec::new();
    let at = Path::root().key("scene");
    for name in scene.bodies.keys() {
        if !is_body_name(name) {
            faults.push(bad_body_name(name).at_path(at.key("bodies").name(name.as_str())));
        }
    }
    if let Axes::Rectangular(axes) = &scene.axes
        && axes.is_empty()
    {
        let fault = Fault::new(Code::Value, "a scene needs an axis");
        let help = "write `axes: { x: to the right }`, or two or three: `axes: { x: east, y: north, z: upwards }`";
        faults.push(fault.help(help).at_path(at.key("axes")));
    }
    faults.extend(super::space::faults(scene));
    faults.extend(names_of_instants(scene));
    faults.extend(unions_without_a_name_of_their_own(scene));
    faults.extend(stages_of_one_name(scene));
    if !faults.is_empty() {
        return faults;
    }
    let at = Path::root().key("scene");
    let timeline = Timeline::new(scene);
    for (index, stage) in scene.stages.iter().enumerate() {
        let at = at.key("stages").index(index).key(stage.key());
        faults.extend(super::space::without_polar_axes(scene, stage).map(|fault| fault.at_path(at.clone())));
        for (name, key) in Description::of(scene, stage).bodies {
            if timeline.since(name, index + 1).is_none() {
                let path = key.map_or_else(|| at.clone(), |key| at.key(key));
                faults.push(unknown("body", name, &timeline.alive(index + 1)).at_path(path));
            } else if key != Some(ROTOR) && scene.bodies.get(name).is_some_and(|body| body.inertia.is_some()) {
                let message = format!("{} has a moment of inertia and is no particle", scene.called(name));
                let help = if scene.rotors().count() > 1 {
                    "no stage lets two bodies with an `inertia` act on each other: the program has no impact, clutch or belt between them"
                } else {
                    "name it as the `rotor` of a `rotate` or a `strike`, or remove its `inertia`"
                };
                faults.push(Fault::new(Code::Value, message).help(help).at_path(at.clone()));
            }
        }
        faults.extend(match stage {
            Stage::Impact(impact) => collision(scene, impact, &at),
            Stage::Spring(spring) if spring.ends().is_none() => {
                let fault = Fault::new(Code::MissingKey, "a spring needs a body, or two bodies that it connects");
                vec![fault.help("write `body: A`, or `between: [A, B]`").at_path(at)]
            }
            Stage::Fall(fall) => upright::falling(scene, index, &fall.body, &at),
            Stage::Swing(_) => upright::not_vertical(scene, "a swing", &at),
            Stage::Taut(taut) => {
                let mut faults = super::jerk::faults(taut, &at);
                faults.extend(upright::over_a_pulley(scene, taut, &at));
                faults
            }
            Stage::Connected(string) => {
                let mut faults = super::tied::jerked(scene, index, string, &at);
                faults.extend(in_a_row(scene, stage, ["bodies on a string over a pulley", "along the string"], at));
                faults
            }
            Stage::Tow(_) => in_a_row(scene, stage, ["bodies in a row", "ahead"], at),
            Stage::Flight(stage) if stage.flying().next().is_none() => {
                let fault = Fault::new(Code::MissingKey, "a flight needs a body");
                vec![fault.help("write `body: A`, or `bodies: [A, B]`").at_path(at)]
            }
            Stage::Separate(stage) => separation(scene, &timeline, index, stage, &at),
            Stage::Rotate(_)
            | Stage::Central(_)
            | Stage::Moment(_)
            | Stage::Strike(_)
            | Stage::Conical(_)
            | Stage::Bowl(_)
            | Stage::Interact(_) => super::space::turning(scene, &timeline, stage, at),
            Stage::Push(push) => super::stage::pushing(scene, push, &at),
            Stage::Slide(_)
            | Stage::Spring(_)
            | Stage::Blow(_)
            | Stage::Bounces(_)
            | Stage::Stream(_)
            | Stage::Thrust(_)
            | Stage::Drift(_)
            | Stage::SlideOff(_)
            | Stage::Walk(_)
            | Stage::Motion(_) => Vec::new(),
            Stage::Flight(_) => upright::weightless(scene, &at),
        });
    }
    faults.extend(rotors_that_nothing_turns(scene));
    faults.extend(super::standing::faults(scene, &timeline));
    faults.extend(two_angular_velocities(scene));
    faults
}

/// The angular velocity of what turns as a whole has one name: a scene has one arm, or one body with a moment of inertia.
fn two_angular_velocities(scene: &Scene) -> Option<Fault> {
    let turning = scene.stages.iter().enumerate().filter_map(|(index, stage)| {
        if let Stage::Rotate(rotate) = stage {
            return rotate.is_arm().then_some((index, stage.key(), rotate.about.as_str(), rotate.rotor.as_deref()));
        }
        let Stage::Strike(strike) = stage else { return None };
        Some((index, stage.key(), strike.about.as_str(), strike.rotor.as_deref()))
    });
    let all: Vec<_> = turning.collect();
    let (_, _, first, _) = *all.first()?;
    let rotor = all.iter().find_map(|(_, _, _, rotor)| *rotor);
    let differs = |(_, _, about, other_rotor): &&(usize, &str, &str, Option<&str>)| {
        *about != first || other_rotor.is_some_and(|other_rotor| Some(other_rotor) != rotor)
    };
    let (index, key, ..) = *all.iter().find(differs)?;
    let message = "two things turn in this scene, and `omega` can name the angular velocity of one only";
    let help = "keep the stages of one of them, about one point; write the other as a problem of its own";
    let path = Path::root().key("scene").key("stages").index(index).key(key);
    Some(Fault::new(Code::Value, message).help(help).at_path(path))
}

/// A body that turns about an axis does so in a stage that names it.
fn rotors_that_nothing_turns(scene: &Scene) -> Vec<Fault> {
    let is_named = |rotor: &str| {
        scene.stages.iter().any(|stage| Description::of(scene, stage).bodies.iter().any(|(name, _)| *name == rotor))
    };
    let idle = scene.rotors().filter(|rotor| !scene.stages.is_empty() && !is_named(rotor));
    let fault = |rotor: &str| {
        let message = format!("{} has a moment of inertia, and no stage names it", scene.called(rotor));
        let fault = Fault::new(Code::Value, message);
        let help = format!("name it in the stage in which it turns: `{ROTOR}: {rotor}`");
        fault.help(help).at_path(Path::root().key("scene").key("bodies").name(rotor))
    };
    idle.map(fault).collect()
}

/// The keys by which an impact says how the bodies part; one is enough.
fn told_of_restitution(impact: &Impact) -> Vec<&'static str> {
    let keys = [
        ("restitution", impact.restitution.is_some()),
        ("elastic", impact.elastic),
        ("loss", impact.loss.is_some()),
        ("plastic", impact.plastic),
    ];
    keys.into_iter().filter(|(_, told)| *told).map(|(key, _)| key).collect()
}

/// A stage is found by its name.
fn stages_of_one_name(scene: &Scene) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (index, stage) in scene.stages.iter().enumerate() {
        let Some(name) = stage.name() else { continue };
        if scene.stages[..index].iter().any(|earlier| earlier.name() == Some(name)) {
            let fault = Fault::new(Code::Duplicate, format!("two stages are called `{name}`"));
            let path = Path::root().key("scene").key("stages").index(index).key(stage.key()).key("name");
            faults.push(fault.help("rename one of them").at_path(path));
        }
    }
    faults
}

/// How an impact is given.
fn collision(scene: &Scene, impact: &Impact, at: &Path) -> Vec<Fault> {
    let mut faults = Vec::new();
    match impact.partners() {
        Some(Partners::Bodies(first, second)) if first == second => {
            let fault = Fault::new(Code::Value, format!("`{first}` cannot collide with itself"));
            faults.push(fault.help("name two bodies").at_path(at.key("between")));
        }
        Some(Partners::Surface(_, surface)) if !scene.surfaces.contains_key(surface) => {
            let known: Vec<&str> = scene.surfaces.keys().map(String::as_str).collect();
            faults.push(unknown("surface", surface, &known).at_path(at.key("against")));
        }
        Some(_) => {}
        None => {
            let fault = Fault::new(Code::MissingKey, "an impact needs two bodies, or a body and a surface");
            faults.push(fault.help("write `between: [A, B]`, or `body: A` with `against: floor`").at_path(at.clone()));
        }
    }
    if let Some(name) = impact.becomes.as_ref().filter(|name| !is_body_name(name)) {
        faults.push(bad_body_name(name).at_path(at.key("becomes")));
    }
    if let [first, second, ..] = told_of_restitution(impact)[..] {
        let message = format!("`{first}` and `{second}` cannot be used together: each says how the bodies separate");
        let fault = Fault::new(Code::OverDetermined, message);
        faults.push(fault.help(format!("remove `{first}` or `{second}`")).at_path(at.key(second)));
    }
    faults
}

/// Every instant has at most one name, and every name an instant.
fn names_of_instants(scene: &Scene) -> Vec<Fault> {
    let at = Path::root().key("scene").key("instants");
    let mut faults = Vec::new();
    for (index, instant) in scene.instants.iter().enumerate() {
        let (name, words) = (instant.name(), instant.words());
        let fault = if !instant.is_one() {
            Fault::new(Code::Value, "an instant has one name, and words behind it if you like")
                .help("write `top: at the top`")
        } else if words.is_some_and(|words| words.contains("{{")) {
            Fault::new(Code::Value, format!("the words for the instant `{name}` hold no values"))
                .help("say it without a number: `top: at the top`")
        } else if index > scene.stages.len() {
            Fault::new(Code::Value, format!("there is no instant for the name `{name}`")).help(format!(
                "the instants are before, between and after the stages: {} in all",
                scene.stages.len() + 1
            ))
        } else if scene.instants[..index].iter().any(|other| other.name() == name) {
            Fault::new(Code::Duplicate, format!("two instants are called `{name}`")).help("rename one of them")
        } else {
            continue;
        };
        faults.push(fault.at_path(at.index(index)));
    }
    faults
}

/// The misfits of two bodies that follow each other on a string, or in a row.
fn in_a_row(scene: &Scene, stage: &Stage, [what, axis]: [&str; 2], at: Path) -> Vec<Fault> {
    let fault = match &Description::of(scene, stage).bodies[..] {
        _ if !matches!(&scene.axes, Axes::Rectangular(axes) if axes.len() == 1) => {
            let fault = Fault::new(Code::Value, format!("{what} need a scene with one axis"));
            fault.help(format!("write `axes: {{ x: {axis} }}`"))
        }
        [(one, _), (other, Some(key))] if one == other => {
            let fault = Fault::new(Code::Value, format!("`{one}` cannot be at both ends"));
            fault.help(format!("name another body under `{key}`"))
        }
        _ => return Vec::new(),
    };
    vec![fault.at_path(at)]
}

/// The union of two bodies is a body of its own: its name must not be that of another.
fn unions_without_a_name_of_their_own(scene: &Scene) -> Vec<Fault> {
    let mut taken: Vec<&str> = scene.bodies.keys().map(String::as_str).collect();
    let mut faults = Vec::new();
    for (index, stage) in scene.stages.iter().enumerate() {
        let Stage::Impact(Impact { becomes: Some(union), .. }) = stage else { continue };
        if taken.contains(&union.as_str()) {
            let fault = Fault::new(Code::Duplicate, format!("`{union}` is already the name of another body"));
            let path = Path::root().key("scene").key("stages").index(index).key(stage.key()).key("becomes");
            faults.push(fault.help("give the joined body a new name: `becomes: C`").at_path(path));
        }
        taken.push(union);
    }
    faults
}

/// Checks which bodies part, and from which whole.
fn separation(scene: &Scene, timeline: &Timeline, index: usize, stage: &Separate, at: &Path) -> Vec<Fault> {
    let mut faults = Vec::new();
    if stage.into.len() < 2 {
        let fault = Fault::new(Code::MissingKey, "a separation needs two parts or more");
        faults.push(fault.help("name them: `into: [A, B]`").at_path(at.key("into")));
    }
    let later = |name: &String| {
        let rest = scene.stages.iter().skip(index + 1);
        rest.into_iter()
            .any(|stage| matches!(stage, Stage::Separate(Separate { from: Some(whole), .. }) if whole == name))
    };
    for (position, part) in stage.into.iter().enumerate() {
        let at = at.key("into").index(position);
        let known = match &stage.from {
            Some(_) => scene.bodies.contains_key(part) || later(part),
            None => timeline.since(part, index + 1).is_some(),
        };
        if !known {
            let known: Vec<&str> = scene.bodies.keys().map(String::as_str).collect();
            faults.push(unknown("body", part, &known).at_path(at));
        } else if stage.into[..position].contains(part) || stage.from.as_ref() == Some(part) {
            let fault = Fault::new(Code::Duplicate, format!("`{part}` cannot be a part twice, or be a part of itself"));
            faults.push(fault.help("name each part once").at_path(at));
        }
    }
    if let Some(whole) = &stage.from {
        if !is_body_name(whole) {
            faults.push(bad_body_name(whole).at_path(at.key("from")));
        } else if timeline.since(whole, index + 1).is_none() {
            faults.push(unknown("body", whole, &timeline.alive(index + 1)).at_path(at.key("from")));
        }
    }
    for (position, relative) in stage.relatives().iter().enumerate() {
        let at = super::stage::place_of_relative(stage, position, at);
        for (name, key) in [(&relative.of, "of"), (&relative.to, "to")] {
            if !stage.into.contains(name) {
                let known: Vec<&str> = stage.into.iter().map(String::as_str).collect();
                faults.push(unknown("part", name, &known).at_path(at.key(key)));
            }
        }
    }
    faults
}

/// Whether names such as `v_A1` can be made of a body's short name.
fn is_body_name(name: &str) -> bool {
    name.ends_with(|last: char| last.is_alphabetic()) && name != MASS_CENTRE
}

fn bad_body_name(name: &str) -> Fault {
    Fault::new(Code::Value, format!("a body cannot be called `{name}`")).help(
        "write a short name that ends in a letter (digits number the instants) and is not `G` (the centre of mass)",
    )
}
