//! Whether momentum, kinetic energy or angular momentum is conserved in a stage, answered from the scene.

use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::fault::did_you_mean;
use crate::model::Agent;
use crate::model::Builder;
use crate::model::Timeline;
use crate::scene::Plane;
use crate::scene::Stage;
use crate::scene::stage::Arm;
use crate::scene::stage::Connected;
use crate::scene::stage::Partners;
use crate::scene::stage::Slide;
use crate::scene::stage::Strand;

use super::ask::Conservable;
use super::ask::Conserved;
use super::concept::Question;
use super::concept::Verdict;
use super::concept::join;
use super::concept::stage;
use super::concept::yes_or_no;
use super::decision::ChoicePart;
use super::impact_kind::ImpactKind;
use super::load::Loaded;
use super::misjudged;
use super::part::PartKind;

/// Whether a quantity is conserved for some bodies in a stage.
pub(super) fn conserved(loaded: &Loaded, ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let stage = stage(ask.stage.as_deref(), builder, path)?;
    check_bodies(ask, builder, path)?;
    let names: Vec<String> = ask.of.iter().map(|body| builder.name_of(body)).collect();
    let whose = join(&names);
    let phrase = builder.phrase_of(stage);
    let judged = |verdict: Verdict, builder: &Builder<'_>| {
        let behind = misjudged::conserved(ask, builder, stage, verdict.0);
        yes_or_no(verdict, behind)
    };
    let kind = match ask.conserved {
        Conservable::Momentum => judged(momentum(ask, builder, stage, path)?, builder),
        Conservable::Energy => energy(loaded, ask, builder, stage, path),
        Conservable::AngularMomentum => judged(angular(ask, builder, stage), builder),
    };
    let what = match (ask.conserved, ask.along) {
        (Conservable::Momentum, Some(axis)) => format!("the momentum of {whose} along {}", axis.letter()),
        (Conservable::Momentum, None) => format!("the momentum of {whose}"),
        (Conservable::Energy, _) => format!("the kinetic energy of {whose}"),
        (Conservable::AngularMomentum, _) => format!("the angular momentum of {whose}"),
    };
    Some((format!("Is {what} conserved during {phrase}?"), kind))
}

/// The system is made of bodies of the scene.
fn check_bodies(ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<()> {
    let bodies: Vec<&str> = builder.bodies().collect();
    let known = format!("the scene has: {}", bodies.join(", "));
    let fault = match ask.of.iter().find(|body| !bodies.contains(&body.as_str())) {
        None if !ask.of.is_empty() => return Some(()),
        None => Fault::new(Code::Value, "`of` names no body").help(known),
        Some(body) => {
            let near = did_you_mean(body, bodies.iter().copied()).map(|near| format!("did you mean `{near}`?"));
            Fault::new(Code::UnknownName, format!("there is no body `{body}` in this scene"))
                .help(near.unwrap_or(known))
        }
    };
    builder.fault(fault.at_path(path.key("of")));
    None
}

fn momentum(ask: &Conserved, builder: &mut Builder<'_>, stage: usize, path: &Path) -> Option<Verdict> {
    let positions: Vec<usize> = match ask.along {
        None => (0..builder.axis_letters().len()).collect(),
        Some(axis) => {
            let position = builder.axis_letters().iter().position(|letter| *letter == axis.letter());
            let Some(position) = position else {
                let fault = Fault::new(Code::Value, format!("the scene has no axis {}", axis.letter()));
                let help = format!("its axes are: {}", builder.axis_letters().join(", "));
                builder.fault(fault.help(help).at_path(path.key("along")));
                return None;
            };
            vec![position]
        }
    };
    if let Some(Stage::SlideOff(slide)) = builder.scene().stages.get(stage)
        && let Some(guide) = builder.scene().bodies.get(&slide.on).and_then(|body| body.guide.as_ref())
    {
        let free = |position: &usize| builder.axis_letters().get(*position) == Some(&guide.along.0.trim());
        if !positions.iter().all(free) {
            let by = guide.by.as_deref().unwrap_or("what guides it");
            let name = builder.name_of(&slide.on);
            return Some((
                false,
                format!("weight acts, and {by} pushes on {name} across the way in which it can move"),
            ));
        }
    }
    let outside = builder.impulses().iter().find(|impulse| {
        let internal = matches!(&impulse.by, Agent::Body(other) if ask.of.contains(other));
        let acts = |position: &usize| impulse.components.get(*position).is_none_or(|component| !component.is_zero());
        impulse.stage == stage && ask.of.contains(&impulse.on) && !internal && positions.iter().any(acts)
    });
    Some(match outside {
        Some(impulse) => {
            let name = builder.name_of(&impulse.on);
            (false, format!("{} gives {name} an impulse from outside the system", impulse.called))
        }
        None => {
            (true, "the impulses within the system cancel in pairs, and none acts from outside along the axis".into())
        }
    })
}

fn energy(loaded: &Loaded, ask: &Conserved, builder: &mut Builder<'_>, stage: usize, path: &Path) -> PartKind {
    let scene = &loaded.draft.scene;
    let timeline = Timeline::new(scene);
    let takes_part = |body: &&String| timeline.since(body, stage + 2).is_none_or(|since| since == stage + 2);
    let all = |bodies: &[&str]| bodies.iter().all(|body| ask.of.iter().any(|own| own == body));
    let verdict = match scene.stages.get(stage) {
        _ if !ask.of.iter().any(|body| takes_part(&body)) => (true, "nothing acts on it".into()),
        Some(Stage::Impact(impact)) => match (impact.partners(), ImpactKind::of(loaded, impact, builder, path)) {
            (Some(Partners::Bodies(first, second)), _) if !all(&[first, second]) => {
                (false, "the other body does work on it during the contact".into())
            }
            (Some(Partners::Surface(_, surface)), _)
                if scene.surfaces.get(surface).is_some_and(|own| own.velocity.is_some()) =>
            {
                (false, "the surface moves, and does work on the body during the contact".into())
            }
            (_, kind) => {
                let behind = misjudged::conserved(ask, builder, stage, false);
                return PartKind::Choice(ChoicePart::OfImpact(Box::new(kind.keeps_energy(behind))));
            }
        },
        Some(Stage::Rotate(stage))
            if stage.moment.is_none() && stage.held().iter().all(|(_, arm)| matches!(arm, Arm::Constant(_))) =>
        {
            (true, "the only force in the plane is at right angles to the motion and does no work".into())
        }
        Some(Stage::Swing(_)) => (
            false,
            "weight does work as the height changes, though the cord, at right angles to the motion, does none".into(),
        ),
        Some(Stage::Slide(slide)) => sliding(slide),
        Some(Stage::Spring(_)) => {
            (false, "the spring does work: it stores kinetic energy when it is deformed, and gives it back".into())
        }
        Some(Stage::Taut(_)) => {
            (false, "the string ends with one velocity along it for both, and the jerk takes energy".into())
        }
        Some(Stage::Connected(connected)) if all(&[&connected.trailing.body, &connected.leading.body]) => {
            on_a_string(connected, builder)
        }
        Some(Stage::Connected(_)) => (false, "the string does work on it: it pulls along the motion".into()),
        Some(Stage::Separate(_)) => {
            (false, "the parts are pushed away from each other, and the forces that do so do work on them".into())
        }
        Some(Stage::Moment(_)) => (false, "the moment does work as the system turns".into()),
        Some(Stage::Interact(own)) if own.elastic && own.between.iter().all(|body| all(&[body])) => {
            (true, "the bodies lose no kinetic energy".into())
        }
        Some(Stage::Interact(_)) => (false, "the bodies do work on each other".into()),
        Some(Stage::Strike(_)) => (false, "in the impact kinetic energy is passed on, and part of it is lost".into()),
        Some(Stage::Conical(_)) => (false, "the cord does work as it is drawn in or let out".into()),
        Some(Stage::Fall(_) | Stage::SlideOff(_) | Stage::Bowl(_)) => {
            (false, "weight does work as the height changes".into())
        }
        Some(Stage::Flight(_)) if scene.plane == Plane::Vertical => {
            (false, "weight does work as the height changes".into())
        }
        _ => {
            let moved = builder.impulses().iter().any(|impulse| impulse.stage == stage);
            (!moved, if moved { "a force does work on the body".into() } else { "nothing does work".into() })
        }
    };
    let behind = misjudged::conserved(ask, builder, stage, verdict.0);
    yes_or_no(verdict, behind)
}

fn sliding(slide: &Slide) -> Verdict {
    if slide.friction.is_some() {
        (false, "friction does work on the body all along its way".into())
    } else if slide.incline.is_none() && slide.height.is_none() {
        (true, "the smooth level floor pushes at right angles to the motion, and nothing does work".into())
    } else {
        (false, "weight does work as the height changes".into())
    }
}

/// Two bodies on one string: what does work on them besides it.
fn on_a_string(connected: &Connected, builder: &Builder<'_>) -> Verdict {
    let strands = [&connected.trailing, &connected.leading];
    let of = |acts: &dyn Fn(&Strand) -> bool| {
        let own = strands.into_iter().filter(|strand| acts(strand));
        own.map(|strand| builder.name_of(&strand.body)).collect::<Vec<_>>()
    };
    let level = |strand: &Strand| strand.on.as_ref().is_some_and(|on| on.0.trim() == "level");
    let weight = of(&|strand| !level(strand));
    let friction = of(&|strand| strand.friction.is_some());
    let does_work = |what: &str, on: &[String]| (!on.is_empty()).then(|| format!("{what} does work on {}", join(on)));
    let works: Vec<String> =
        [does_work("weight", &weight), does_work("friction", &friction)].into_iter().flatten().collect();
    let string = "the string takes from one body what it gives to the other";
    if works.is_empty() {
        (true, format!("{string}, and nothing else does work"))
    } else {
        (false, format!("{string}, but {}", works.join(", and ")))
    }
}

fn angular(ask: &Conserved, builder: &Builder<'_>, stage: usize) -> Verdict {
    let all = |bodies: &[&String]| bodies.iter().all(|body| ask.of.contains(body));
    match builder.scene().stages.get(stage) {
        Some(Stage::Central(_)) => {
            (true, "the force always passes through the point and has no moment about it".into())
        }
        Some(Stage::Rotate(stage)) if stage.moment.is_none() => {
            (true, "the only force in the plane passes through the point and has no moment about it".into())
        }
        Some(Stage::Strike(own)) if all(&own.carries.keys().chain([&own.body]).collect::<Vec<_>>()) => {
            (true, "the impulse of the support passes through the point".into())
        }
        Some(Stage::Interact(own)) if all(&own.between.iter().collect::<Vec<_>>()) => {
            (true, "the forces between the bodies are equal and opposite along one line".into())
        }
        Some(Stage::Strike(_) | Stage::Interact(_)) => {
            (false, "the other bodies act on it, and their forces have a moment about the point".into())
        }
        Some(Stage::Conical(_) | Stage::Bowl(_)) => (true, "no force has a moment about the vertical axis".into()),
        _ => (false, "a force has a moment about the point".into()),
    }
}
