//! Conservation in a stage that takes no time: the terms before and after it decide.

use momentous_expr::Expr;
use momentous_model::Agent;
use momentous_model::Builder;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;
use momentous_scene::stage::Taut;

use super::super::super::reading::load::Loaded;
use super::super::choices::judgement::Test;
use super::super::equality::Equality;
use super::super::equality::Place;
use super::balance::Balance;
use super::balance::Verdict;

/// Why a total stays, where nothing more is to be said.
const SAME: &str = "it is the same before and after";

pub(crate) fn momentum(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Option<Verdict> {
    let outside = outside(balance, builder);
    let mut tests = Vec::new();
    for position in &balance.axes {
        let acting = outside
            .iter()
            .find(|(_, components)| components.get(*position).is_none_or(|component| !component.is_zero()));
        let otherwise =
            acting.map_or_else(|| "it is not the same before and after".to_owned(), |cause| cause.0.clone());
        // What is struck belongs to the system with all that it carries, so that only its support is outside.
        let otherwise = if let Some(Stage::Strike(strike)) = builder.scene().stages.get(balance.stage)
            && takes_in_all(balance, builder)
        {
            let arm = strike.rotor.as_ref().map_or_else(|| "the arm".to_owned(), |rotor| builder.name_of(rotor));
            format!("the support exerts an external impulse on {arm}")
        } else {
            otherwise
        };
        // Along a string over a pulley the velocities of both have one sense, and the pulley turns the momentum of one of
        // them. On an arm they have one sense on either side of what holds it, which gives an impulse from outside.
        let turns = matches!(
            builder.scene().stages.get(balance.stage),
            Some(Stage::Taut(Taut { over: Some(_), .. }) | Stage::Strike(_))
        );
        let equality = if turns {
            Equality::Never
        } else {
            let [before, after] =
                [1, 2].map(|side| builder.total_momentum(&balance.ask.of, balance.stage + side, *position));
            equality(loaded, balance, builder, [before?, after?])
        };
        tests.push(Test::new(equality, otherwise));
    }
    let is_identity = tests.iter().all(|test| matches!(test.equality, Equality::Always));
    // Ordinary forces act in an impact, too, but have no time.
    let is_short = matches!(builder.scene().stages.get(balance.stage), Some(Stage::Impact(_)));
    let because = match outside.is_empty() || is_identity {
        true if is_short => {
            "the impulses within the system cancel in pairs, and no external force along the axis is impulsive"
        }
        true => "the impulses within the system cancel in pairs, and no external impulse acts along the axis",
        false => SAME,
    };
    Some(Verdict { tests, because: because.into() })
}

pub(crate) fn energy(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Verdict {
    let sides = [0, 1].map(|side| builder.total_kinetic(&balance.ask.of, balance.stage, side));
    let equality = equality(loaded, balance, builder, sides);
    let (because, otherwise) = words_of_energy(balance, builder);
    Verdict { tests: vec![Test::new(equality, otherwise)], because: because.into() }
}

pub(crate) fn angular(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Option<Verdict> {
    if outside(balance, builder).is_empty() && takes_in_all(balance, builder) {
        let because = "the forces between the bodies are equal and opposite along one line";
        return Some(Verdict { tests: Vec::new(), because: because.into() });
    }
    let [before, after] = [1, 2].map(|side| builder.total_moment(&balance.ask.of, balance.about, balance.stage, side));
    let is_strike = matches!(builder.scene().stages.get(balance.stage), Some(Stage::Strike(_)));
    let (because, otherwise) = if is_strike && takes_in_all(balance, builder) {
        ("the impulse of the support passes through the point", "an impulse has a moment about the point")
    } else {
        (SAME, "the other bodies act on it, and their forces have a moment about the point")
    };
    let pairs = before?.into_iter().zip(after?);
    let tests = pairs.map(|(from, to)| Test::new(equality(loaded, balance, builder, [from, to]), otherwise)).collect();
    Some(Verdict { tests, because: because.into() })
}

fn equality(loaded: &Loaded, balance: &Balance<'_>, builder: &Builder<'_>, sides: [Expr; 2]) -> Equality {
    Equality::of(loaded, builder, Place { stage: balance.stage, clock: None }, sides)
}

/// The impulses on the system from outside: what is said of each, and its components.
fn outside(balance: &Balance<'_>, builder: &Builder<'_>) -> Vec<(String, Vec<Expr>)> {
    let bodies = &balance.ask.of;
    let on = |name: &str| builder.scene().members(name).iter().any(|member| bodies.iter().any(|body| body == member));
    let acts = builder.impulses().iter().filter(|impulse| {
        let is_within = matches!(&impulse.by, Agent::Body(other) if bodies.contains(other) || on(other));
        impulse.stage == balance.stage && (bodies.contains(&impulse.on) || on(&impulse.on)) && !is_within
    });
    let said = acts.map(|impulse| {
        let name = builder.name_of(&impulse.on);
        (format!("{} exerts an external impulse on {name}", impulse.called), impulse.components.clone())
    });
    said.collect()
}

/// Whether everything that takes part in the stage belongs to the system.
fn takes_in_all(balance: &Balance<'_>, builder: &Builder<'_>) -> bool {
    let system = &balance.ask.of;
    let is_in = |body: &&str| {
        system.iter().any(|other| other == body || builder.scene().members(other).contains(body))
            || builder.scene().members(body).iter().all(|member| system.iter().any(|other| other == member))
    };
    // What a stage makes later consists of bodies that are looked at themselves.
    let declared = builder.scene().bodies.keys().map(String::as_str);
    let bodies: Vec<&str> = declared.collect();
    bodies.iter().filter(|body| builder.is_changed_in(body, balance.stage)).all(is_in)
}

/// Why kinetic energy stays, and why it does not.
fn words_of_energy(balance: &Balance<'_>, builder: &Builder<'_>) -> (&'static str, &'static str) {
    let scene = builder.scene();
    let all = takes_in_all(balance, builder);
    match scene.stages.get(balance.stage) {
        Some(Stage::Impact(impact)) => match impact.partners() {
            Some(Partners::Bodies(..)) if !all => (SAME, "the other body does work on it during the contact"),
            Some(Partners::Surface(_, surface))
                if scene.surfaces.get(surface).is_some_and(|surface| surface.velocity.is_some()) =>
            {
                (SAME, "the surface moves, and does work on the body during the contact")
            }
            _ if impact.plastic => (
                "no kinetic energy is lost",
                "the bodies stay together, and part of the kinetic energy goes into deforming and heating them",
            ),
            _ if impact.restitution.is_some() => {
                ("the impact is elastic (e = 1)", "with e below 1, part of the kinetic energy is lost in the impact")
            }
            _ => ("the impact is elastic", "part of the kinetic energy is lost in the impact"),
        },
        Some(Stage::Strike(_)) if all => {
            ("the impact is elastic", "in the impact, kinetic energy is transferred, and part of it is lost")
        }
        Some(Stage::Strike(_)) => (SAME, "in the impact, kinetic energy is transferred"),
        Some(Stage::Taut(taut)) if !taut.strings.is_empty() => (
            SAME,
            "the strings become taut inelastically: the ends of each then have the same velocity along it, and kinetic energy is lost",
        ),
        Some(Stage::Taut(_)) => (
            SAME,
            "the string becomes taut inelastically: both bodies then have the same velocity along it, and kinetic energy is lost",
        ),
        Some(Stage::Separate(_)) => (
            "the parts do not move away from each other",
            "the parts are pushed away from each other, and the forces that do so do work on them",
        ),
        Some(Stage::Interact(interact)) if all && interact.friction.is_some() => {
            ("the bodies do not slide on each other", "friction turns part of the kinetic energy into heat")
        }
        Some(Stage::Interact(_)) if all => ("the bodies lose no kinetic energy", "the bodies do work on each other"),
        None
        | Some(
            Stage::Push(_)
            | Stage::Slide(_)
            | Stage::Spring(_)
            | Stage::Swing(_)
            | Stage::Connected(_)
            | Stage::Tow(_)
            | Stage::Blow(_)
            | Stage::Rotate(_)
            | Stage::Moment(_)
            | Stage::Conical(_)
            | Stage::Bowl(_)
            | Stage::Interact(_)
            | Stage::Central(_)
            | Stage::Fall(_)
            | Stage::Bounces(_)
            | Stage::Stream(_)
            | Stage::Thrust(_)
            | Stage::Drift(_)
            | Stage::SlideOff(_)
            | Stage::Walk(_)
            | Stage::Flight(_)
            | Stage::Motion(_),
        ) => (SAME, "a force does work on the body"),
    }
}
