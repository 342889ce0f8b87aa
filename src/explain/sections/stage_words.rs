//! Each kind of stage in words: what happens in it, and what acts.

use momentous_model::Agent;
use momentous_model::ForceKind;
use momentous_model::Impulse;
use momentous_model::Model;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Arm;
use momentous_scene::stage::Connected;
use momentous_scene::stage::Ends;
use momentous_scene::stage::Flight;
use momentous_scene::stage::Interact;
use momentous_scene::stage::Push;
use momentous_scene::stage::Rotate;
use momentous_scene::stage::Slide;
use momentous_scene::stage::Spring;
use momentous_scene::stage::Strand;
use momentous_scene::stage::Stream;
use momentous_scene::stage::UpOrDown;

use super::super::wording::capitalised;
use momentous_scene::list;

/// The noun phrase for what happens in a stage.
pub(super) fn happening(scene: &Scene, stage: &Stage, phrase: &str) -> String {
    let name = |body: &str| scene.called(body);
    let does = |body: &str, forms: [&str; 2]| scene.does(body, forms);
    match stage {
        Stage::Impact(impact) => match (&impact.between, &impact.body, &impact.against) {
            (Some([a, b]), ..) => format!("{phrase} of {} and {}", name(a), name(b)),
            (_, Some(body), Some(surface)) => {
                format!("{} {}", does(body, ["hits", "hit"]), surface_name(scene, surface))
            }
            _ => phrase.to_owned(),
        },
        Stage::Push(push) => pushed(scene, push),
        Stage::Slide(Slide { body, on: Some(on), way, .. }) => {
            let way = if *way == Some(UpOrDown::Up) { "up" } else { "down" };
            format!("{} {way} {}", does(body, ["slides", "slide"]), name(on))
        }
        Stage::Slide(slide) => does(&slide.body, ["slides", "slide"]),
        Stage::Spring(spring) => match spring.ends() {
            Some(Ends::Free(first, second)) => format!("the spring acts between {} and {}", name(first), name(second)),
            Some(Ends::Fixed(body)) => format!("the spring acts on {}", name(body)),
            None => phrase.to_owned(),
        },
        Stage::Swing(swing) if swing.radius.is_some() => {
            does(&swing.body, ["slides on the circular track", "slide on the circular track"])
        }
        Stage::Swing(swing) => does(&swing.body, ["swings on the cord", "swing on the cord"]),
        Stage::Taut(taut) => {
            let between = |[one, other]: [&str; 2]| format!("between {} and {}", name(one), name(other));
            match &taut.ends()[..] {
                [only] => format!("the string {} goes taut", between(*only)),
                all => {
                    format!(
                        "the strings {} are jerked at the same time",
                        list(&all.iter().map(|pair| between(*pair)).collect::<Vec<_>>())
                    )
                }
            }
        }
        Stage::Connected(connected) => {
            let [leading, trailing] = [&connected.leading, &connected.trailing].map(|strand| name(&strand.body));
            format!("{leading} pulls {trailing} along by the string")
        }
        Stage::Tow(tow) => {
            let [front, rear] = tow.both().map(|towed| name(&towed.body));
            format!("{front} and {rear} move together")
        }
        Stage::Blow(blow) => format!("{} acts on {}", blow.by, name(&blow.body)),
        Stage::Rotate(rotate) => turning(scene, rotate),
        Stage::Moment(_) => "a moment acts on them".to_owned(),
        Stage::Strike(strike) => {
            let arm = strike.rotor.as_ref().map_or_else(|| "the arm".to_owned(), |rotor| name(rotor));
            format!("{} strikes {arm}", name(&strike.body))
        }
        Stage::Conical(conical) if conical.length.is_constant() => {
            does(&conical.body, ["moves steadily round a level circle", "move steadily round a level circle"])
        }
        Stage::Conical(conical) => format!("the cord of {} changes its length", name(&conical.body)),
        Stage::Bowl(bowl) => does(&bowl.body, ["slides round inside the wall", "slide round inside the wall"]),
        Stage::Interact(Interact { friction: Some(_), between, .. }) if let [upper, lower] = &between[..] => {
            format!("{} on {}", does(upper, ["slides", "slide"]), name(lower))
        }
        Stage::Interact(interact) => {
            let bodies: Vec<String> = interact.between.iter().map(|body| name(body)).collect();
            format!("{} act on each other", list(&bodies))
        }
        Stage::Central(central) => {
            does(&central.body, ["moves under the central force", "move under the central force"])
        }
        Stage::Fall(fall) => does(&fall.body, ["falls", "fall"]),
        Stage::Motion(motion) => does(&motion.body, ["moves as given", "move as given"]),
        Stage::Bounces(bounces) => does(&bounces.body, ["bounces", "bounce"]),
        Stage::SlideOff(slide) => format!("{} down {}", does(&slide.body, ["slides", "slide"]), name(&slide.on)),
        Stage::Walk(walk) => format!("{} along {}", does(&walk.body, ["walks", "walk"]), name(&walk.on)),
        Stage::Stream(stream) => format!("{} acts on {}", stream.by, name(&stream.body)),
        Stage::Thrust(thrust) => does(&thrust.body, ["burns fuel", "burn fuel"]),
        Stage::Drift(_) => "no net force acts; every body keeps its velocity".to_owned(),
        Stage::Flight(flight) => {
            let bodies: Vec<String> = flight.flying().map(|body| scene.called(body)).collect();
            let how = if flight.is_free() { "freely" } else { "against the resistance" };
            let several = bodies.len() > 1 || flight.flying().any(|body| scene.members(body).len() > 1);
            format!("{} {} {how}", list(&bodies), if several { "move" } else { "moves" })
        }
        Stage::Separate(separate) => {
            let parts: Vec<String> = separate.into.iter().map(|part| name(part)).collect();
            // A part that is named by its own parts is set off by a comma.
            match &parts[..] {
                [one, other] if separate.into.iter().any(|part| scene.members(part).len() > 1) => {
                    format!("{phrase} of {one}, and {other}")
                }
                _ => format!("{phrase} of {}", list(&parts)),
            }
        }
    }
}

/// The words for what turns on an arm or on a rotor.
fn turning(scene: &Scene, rotate: &Rotate) -> String {
    let called = |is_meant: fn(&Arm) -> bool| {
        let held = rotate.held().into_iter().filter(|(_, arm)| is_meant(arm));
        held.map(|(body, _)| scene.called(body)).collect::<Vec<_>>()
    };
    let (held, moved) = (called(|_| true), called(|arm| matches!(arm, Arm::Changing(_))));
    match (&rotate.rotor, &held[..], &moved[..]) {
        (None, [only], []) => format!("{only} moves round {}", scene.point(&rotate.about)),
        (None, _, []) => format!("{} move round {}", list(&held), scene.point(&rotate.about)),
        (None, ..) => format!("the distance of {} from {} changes", list(&moved), scene.point(&rotate.about)),
        (Some(rotor), [], _) => format!("{} turns", scene.called(rotor)),
        (Some(rotor), _, []) => format!("{} turns, with {} on it", scene.called(rotor), list(&held)),
        (Some(rotor), ..) => {
            format!("{} turns, while the distance of {} from its axis changes", scene.called(rotor), list(&moved))
        }
    }
}

/// The words for bodies on which forces act.
fn pushed(scene: &Scene, push: &Push) -> String {
    let bodies = list(&push.pushed().map(|body| scene.called(body)).collect::<Vec<_>>());
    let several = push.pushed().any(|body| scene.members(body).len() > 1);
    if let Some(change) = push.mass_change() {
        let joins = if change.gains { "joins" } else { "leaves" };
        let how = match (push.forces.is_empty(), several) {
            (true, false) => "moves freely",
            (true, true) => "move freely",
            (false, false) => "is pushed",
            (false, true) => "are pushed",
        };
        return format!("{} {joins} {bodies}, which {how}", change.name);
    }
    if push.is_resisted_alone() {
        let moves = if several || push.is_of_several() { "move" } else { "moves" };
        return format!("{bodies} {moves} against the resistance");
    }
    format!("forces act on {bodies}")
}

fn surface_name(scene: &Scene, surface: &str) -> String {
    let entry_name = scene.surfaces.get(surface).and_then(|entry| entry.name.clone());
    entry_name.unwrap_or_else(|| format!("the {surface}"))
}

/// One sentence on what acts in a stage.
pub(super) fn acting(model: &Model, scene: &Scene, index: usize, stage: &Stage) -> Option<String> {
    let all = || model.impulses.iter().filter(|impulse| impulse.stage == index);
    // Weight that a short contact includes is no impulsive force.
    let short = matches!(stage, Stage::Impact(_) | Stage::Blow(_));
    let impulses: Vec<&Impulse> = all().filter(|impulse| impulse.impulsive || !short).collect();
    let also = if short && all().any(|impulse| !impulse.impulsive) { "; weight acts as well" } else { "" };
    let first = impulses.first()?;
    let alone = impulses.iter().all(|impulse| impulse.on == first.on);
    let name = |body: &str| scene.called(body);
    let body = name(&first.on);
    let is = if scene.members(&first.on).len() > 1 { "are" } else { "is" };
    let phrase = model.phrase(scene, index);
    let during = |sentence: String| match scene.stages.len() {
        1 => format!("{}.", capitalised(&sentence)),
        _ => format!("During {phrase} {sentence}."),
    };
    if let Some([body, on]) = stage.carried() {
        return Some(during(supported(scene, body, on)));
    }
    Some(match (stage, &impulses[..]) {
        (Stage::Impact(_) | Stage::Separate(_), [_, _, ..]) if !alone => {
            let inner = impulses.iter().filter(|impulse| matches!(impulse.by, Agent::Body(_)));
            let bodies = inner.map(|impulse| name(&impulse.on)).collect::<Vec<_>>();
            let equal = if bodies.len() == 2 {
                "equal and opposite impulses on each other"
            } else {
                "impulses on each other that cancel"
            };
            let bodies = list(&bodies);
            let guides = guiding(scene, &impulses);
            let also = if guides.is_empty() { "nothing else is impulsive".to_owned() } else { list(&guides) };
            format!("During {phrase}, {bodies} exert {equal}; {also}.")
        }
        (Stage::SlideOff(slide), _) => during(supported(scene, &slide.body, &slide.on)),
        (Stage::Flight(flight), _) => {
            let bodies: Vec<String> = flight.flying().map(name).collect();
            let are = if bodies.len() > 1 { "are" } else { is };
            during(format!("{} {are} acted on by {}", list(&bodies), in_flight(scene, flight)))
        }
        (Stage::Interact(interact), [one, other]) if interact.friction.is_some() => during(format!(
            "{} and {} are acted on by the friction between them, with equal and opposite forces along the axis",
            name(&one.on),
            name(&other.on)
        )),
        (
            Stage::Separate(_)
            | Stage::Walk(_)
            | Stage::Drift(_)
            | Stage::Motion(_)
            | Stage::Moment(_)
            | Stage::Interact(_),
            _,
        ) => {
            return None;
        }
        (Stage::Impact(_) | Stage::Blow(_), _) => format!("During {phrase} {}{also}.", impulsive(&impulses, &body)),
        (Stage::Push(_) | Stage::Slide(_), _) => during(pushing(model, scene, index, stage, [&body, is])),
        (Stage::Fall(_), _) => during(format!("{body} {is} acted on by weight alone")),
        (Stage::Spring(_), [one, other]) => during(format!(
            "{} and {} are acted on by the spring between them, with equal and opposite forces",
            name(&one.on),
            name(&other.on)
        )),
        (Stage::Spring(spring), _) => {
            during(format!("{body} {is} acted on by {}", list(&beside_a_spring(scene, spring))))
        }
        (Stage::Swing(swing), _) => during(format!("{body} {is} acted on by weight and {}", swing.held_by())),
        (Stage::Taut(_), [one, other]) => format!(
            "During {phrase}, the string pulls {} and {} with impulses of equal size; nothing else is impulsive.",
            name(&one.on),
            name(&other.on)
        ),
        (Stage::Taut(_), [_, _, ..]) => jerking(&phrase),
        (Stage::Connected(connected), [one, other]) => {
            during(connecting(scene, connected, &list(&[one, other].map(|impulse| name(&impulse.on)))))
        }
        (Stage::Taut(_) | Stage::Connected(_), _) => during(format!("{body} {is} acted on by the string")),
        (Stage::Tow(tow), _) => during(format!(
            "{} acts on {} with equal and opposite forces; all other forces are external",
            tow.joint(),
            list(&tow.both().map(|towed| name(&towed.body)))
        )),
        (Stage::Bounces(_), _) => {
            during(format!("{body} {is} acted on by weight and, at each bounce, by {}", first.called))
        }
        (Stage::Thrust(_), _) => {
            let acting: Vec<String> = impulses.iter().map(|impulse| impulse.called.clone()).collect();
            during(format!("{body} {is} acted on by {}", list(&acting)))
        }
        (Stage::Strike(_), _) => striking(&phrase, &body, &first.called),
        (Stage::Rotate(rotate), [_, _, ..]) => {
            let held: Vec<String> = rotate.turning().into_iter().map(name).collect();
            during(format!("{} are acted on by {}", list(&held), first.called))
        }
        (Stage::Stream(stream), _) => {
            during(format!("{body} {is} acted on by {}", list(&beside_a_stream(scene, stream, &first.called))))
        }
        (Stage::Rotate(_) | Stage::Central(_) | Stage::Conical(_) | Stage::Bowl(_), _) => {
            during(format!("{body} {is} acted on by {}", first.called))
        }
    })
}

/// The influences on a body that a stream meets, the stream first.
fn beside_a_stream(scene: &Scene, stream: &Stream, called: &str) -> Vec<String> {
    let carries = scene.plane == Plane::Vertical && stream.stays;
    let holds = match &stream.moves {
        Some(_) if !carries => "what keeps the velocity constant".to_owned(),
        _ => format!("what holds {}", scene.called(&stream.body)),
    };
    let weight = carries.then(|| "weight".to_owned());
    [Some(called.to_owned()), weight, Some(holds)].into_iter().flatten().collect()
}

/// The influences from outside on a body and on the one that carries it and gives way.
fn supported(scene: &Scene, body: &str, on: &str) -> String {
    let [body, on] = [body, on].map(|body| scene.called(body));
    format!(
        "{body} and {on} are acted on by their weights and by the support; none of these forces has a component along the motion of {on}"
    )
}

/// The influences on bodies that are pushed or slide.
fn pushing(model: &Model, scene: &Scene, index: usize, stage: &Stage, [body, is]: [&str; 2]) -> String {
    let forces = || model.forces.iter().filter(|force| force.stage == index);
    if let Stage::Push(push) = stage
        && push.is_of_several()
    {
        let bodies: Vec<String> = push.pushed().map(|body| scene.called(body)).collect();
        let weights = forces().find(|force| force.kind == ForceKind::Weight).map(|_| "their weights".to_owned());
        let others = forces().filter(|force| force.kind != ForceKind::Weight).map(|force| force.called.clone());
        let called: Vec<String> = weights.into_iter().chain(others).collect();
        return format!("{} are acted on by {}", list(&bodies), list(&called));
    }
    let mut called: Vec<String> = forces().map(|force| force.called.clone()).collect();
    if let (Stage::Push(push), true) = (stage, called.is_empty()) {
        called = together(scene, push);
    }
    let guides = model.impulses.iter().filter(|impulse| impulse.stage == index && impulse.by == Agent::Guide);
    called.extend(guides.map(|impulse| impulse.called.clone()));
    format!("{body} {is} acted on by {}", list(&called))
}

/// The influences on a body at the end of a spring.
fn beside_a_spring(scene: &Scene, spring: &Spring) -> Vec<String> {
    let is_upright = scene.axes.rectangular().first().is_some_and(|(axis, _)| *axis == Axis::Y);
    let hangs = spring.incline.is_none() && scene.plane == Plane::Vertical && is_upright;
    let rests = spring.incline.is_some() || spring.friction.is_some();
    let mut called = Vec::new();
    called.extend((hangs || rests).then(|| "weight".to_owned()));
    called.extend(rests.then(|| "the normal force".to_owned()));
    called.extend(spring.friction.is_some().then(|| "friction".to_owned()));
    called.push("the spring".to_owned());
    called
}

/// The influences in a flight.
fn in_flight(scene: &Scene, flight: &Flight) -> &'static str {
    let heavy = scene.plane == Plane::Vertical || flight.incline.is_some();
    match (flight.is_free(), heavy) {
        (true, _) => "weight alone",
        (false, true) => "weight and the resistance",
        (false, false) => "the resistance alone",
    }
}

/// The influences in a push whose forces have one impulse together: those that depend on the position, or a resistance.
fn together(scene: &Scene, push: &Push) -> Vec<String> {
    let mut called: Vec<String> = push.force_names().map(str::to_owned).collect();
    let rubs = push.forces.iter().any(|force| matches!(force, Force::Friction(_)));
    if push.resistance.is_some() || rubs {
        let on_floor = push.incline.is_some() || rubs;
        called.extend((scene.plane == Plane::Vertical || on_floor).then(|| "weight".to_owned()));
        called.extend(on_floor.then(|| "the normal force".to_owned()));
        called.extend(rubs.then(|| "friction".to_owned()));
        called.extend(push.resistance.is_some().then(|| "the resistance".to_owned()));
    }
    called
}

/// The impulsive forces on one body.
fn impulsive(impulses: &[&Impulse], body: &str) -> String {
    let called: Vec<String> = impulses.iter().map(|impulse| impulse.called.clone()).collect();
    let [force, is] = if called.len() > 1 { ["forces", "are those"] } else { ["force", "is that"] };
    format!("the only impulsive {force} on {body} {is} of {}", list(&called))
}

/// The influences on a body that strikes an arm.
fn striking(phrase: &str, body: &str, arm: &str) -> String {
    format!("During {phrase} the only impulsive forces are that between {body} and {arm} and that of the support.")
}

/// The influences where several strings are jerked together.
fn jerking(phrase: &str) -> String {
    format!(
        "During {phrase}, each string pulls the bodies at its two ends with impulses of equal size; nothing else is impulsive."
    )
}

/// The influences on two bodies that a string connects.
fn connecting(scene: &Scene, connected: &Connected, both: &str) -> String {
    let lies = |strand: &&Strand| strand.on.as_ref().is_some_and(|on| on.0.trim() != "hanging");
    let carried = [&connected.leading, &connected.trailing].into_iter().filter(lies);
    let pushed = carried.map(|strand| {
        let rubs = if strand.friction.is_some() { ", with friction" } else { "" };
        format!("; {} is pushed by what carries it{rubs}", scene.called(&strand.body))
    });
    format!("the string pulls {both} with the same tension, and weight acts on both{}", pushed.collect::<String>())
}

/// The impulses that guided bodies receive from their guides.
fn guiding(scene: &Scene, impulses: &[&Impulse]) -> Vec<String> {
    let guides = impulses.iter().filter(|impulse| impulse.by == Agent::Guide);
    let received = |impulse: &&Impulse| {
        let on = scene.called(&impulse.on);
        format!("{on} receives an impulse perpendicular to its path from {}", impulse.called)
    };
    guides.map(received).collect()
}
