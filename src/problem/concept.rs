//! Questions that are not a number, answered from the scene: what is conserved, what is impulsive, what kind of impact.

use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::fault::did_you_mean;
use crate::model::Agent;
use crate::model::Builder;
use crate::model::Impulse;
use crate::scene::Stage;
use crate::scene::Term;
use crate::scene::stage::Arm;
use crate::scene::stage::Impact;

use super::ask::Classify;
use super::ask::Conservable;
use super::ask::Conserved;
use super::ask::Impulsive;
use super::decision::ChoicePart;
use super::decision::Decision;
use super::given::Given;
use super::load::Loaded;
use super::part::PartKind;

/// The label and the kind of a part.
type Question = (String, PartKind);

/// Whether a quantity is conserved for some bodies in a stage.
pub(super) fn conserved(loaded: &Loaded, ask: &Conserved, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let stage = stage(ask.stage.as_deref(), builder, path)?;
    let bodies: Vec<&str> = builder.bodies().collect();
    if ask.of.is_empty() {
        let fault = Fault::new(Code::Value, "`of` names no body");
        builder.fault(fault.help(format!("the scene has: {}", bodies.join(", "))).at_path(path.key("of")));
        return None;
    }
    let unknown = ask.of.iter().find(|body| !bodies.contains(&body.as_str()));
    if let Some(body) = unknown {
        let near = did_you_mean(body, bodies.iter().copied()).map(str::to_owned);
        let fault = Fault::new(Code::UnknownName, format!("there is no body `{body}` in this scene"));
        let help = near
            .map_or_else(|| format!("the scene has: {}", bodies.join(", ")), |near| format!("did you mean `{near}`?"));
        builder.fault(fault.help(help).at_path(path.key("of")));
        return None;
    }
    let names: Vec<String> = ask.of.iter().map(|body| builder.name_of(body)).collect();
    let whose = join(&names);
    let phrase = builder.phrase_of(stage);
    let verdict = match ask.conserved {
        Conservable::Momentum => momentum(ask, builder, stage, path)?,
        Conservable::Energy => energy(loaded, builder, stage),
        Conservable::AngularMomentum => angular(builder, stage),
    };
    let what = match (ask.conserved, ask.along) {
        (Conservable::Momentum, Some(axis)) => format!("the momentum of {whose} along {}", axis.letter()),
        (Conservable::Momentum, None) => format!("the momentum of {whose}"),
        (Conservable::Energy, _) => format!("the kinetic energy of {whose}"),
        (Conservable::AngularMomentum, _) => format!("the angular momentum of {whose}"),
    };
    let label = format!("Is {what} conserved during {phrase}?");
    Some((label, yes_or_no(verdict)))
}

/// Whether something holds, and why, as a sentence without a full stop.
type Verdict = (bool, String);

fn yes_or_no((holds, because): Verdict) -> PartKind {
    PartKind::Choice(ChoicePart::Settled(Decision::yes_or_no(holds, because)))
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

fn energy(loaded: &Loaded, builder: &Builder<'_>, stage: usize) -> Verdict {
    match loaded.draft.scene.stages.get(stage) {
        Some(Stage::Impact(impact)) if impact.plastic => (
            false,
            "the bodies stay together, and part of the kinetic energy goes into deforming and heating them".into(),
        ),
        Some(Stage::Impact(impact)) if is_elastic(loaded, impact) => (true, "the impact is elastic (e = 1)".into()),
        Some(Stage::Impact(_)) => (false, "with e below 1 part of the kinetic energy is lost in the impact".into()),
        Some(Stage::Rotate(stage))
            if stage.moment.is_none() && stage.held().iter().all(|(_, arm)| matches!(arm, Arm::Constant(_))) =>
        {
            (true, "the only force in the plane is at right angles to the motion and does no work".into())
        }
        Some(Stage::Moment(_)) => (false, "the moment does work as the system turns".into()),
        Some(Stage::Interact(stage)) if stage.elastic => (true, "the bodies lose no kinetic energy".into()),
        Some(Stage::Interact(_)) => (false, "the bodies do work on each other".into()),
        Some(Stage::Strike(_)) => (false, "part of the kinetic energy is lost in the impact".into()),
        Some(Stage::Conical(_)) => (false, "the cord does work as it is drawn in or let out".into()),
        Some(Stage::Swing(_)) => (
            false,
            "weight does work as the height changes, though the cord, at right angles to the motion, does none".into(),
        ),
        Some(Stage::Slide(slide)) if slide.friction.is_some() => {
            (false, "friction does work on the body all along its way".into())
        }
        Some(Stage::Slide(slide)) if slide.incline.is_none() && slide.height.is_none() => {
            (true, "the smooth level floor pushes at right angles to the motion, and nothing does work".into())
        }
        Some(Stage::Slide(_) | Stage::Bowl(_)) => (false, "weight does work as the height changes".into()),
        Some(Stage::Spring(_)) => {
            (false, "the spring does work: it stores kinetic energy when it is deformed, and gives it back".into())
        }
        Some(Stage::Taut(_)) => {
            (false, "the string ends with one velocity along it for both, and the jerk takes energy".into())
        }
        Some(Stage::Connected(_)) => {
            (false, "the string takes from one body what it gives to the other, but weight does work on them".into())
        }
        _ => {
            let moved = builder.impulses().iter().any(|impulse| impulse.stage == stage);
            (!moved, if moved { "a force does work on the body".into() } else { "nothing does work".into() })
        }
    }
}

fn angular(builder: &Builder<'_>, stage: usize) -> Verdict {
    match builder.scene().stages.get(stage) {
        Some(Stage::Central(_)) => {
            (true, "the force always passes through the point and has no moment about it".into())
        }
        Some(Stage::Rotate(stage)) if stage.moment.is_none() => {
            (true, "the only force in the plane passes through the point and has no moment about it".into())
        }
        Some(Stage::Strike(_)) => (true, "the impulse of the support passes through the point".into()),
        Some(Stage::Conical(_) | Stage::Bowl(_)) => (true, "no force has a moment about the vertical axis".into()),
        Some(Stage::Interact(_)) => {
            (true, "the forces between the bodies are equal and opposite along one line".into())
        }
        _ => (false, "a force has a moment about the point".into()),
    }
}

/// Whether no kinetic energy is lost.
fn is_elastic(loaded: &Loaded, impact: &Impact) -> bool {
    impact.elastic || impact.restitution.as_ref().is_some_and(|e| is_one(loaded, e))
}

/// Whether a coefficient of restitution is 1, as it is written or given.
fn is_one(loaded: &Loaded, term: &Term) -> bool {
    let text = term.0.trim();
    let given = || match loaded.given.get(text) {
        Some(Given::Literal(literal)) => literal.components.first().cloned(),
        _ => None,
    };
    let value = crate::quantity::Decimal::parse(text).ok().or_else(given);
    value.is_some_and(|value| value.compare(&crate::quantity::Decimal::from(1)).is_eq())
}

/// The kinds of impact, in the order in which they are offered.
const KINDS: [&str; 3] = ["elastic", "inelastic", "perfectly plastic"];

/// Of which kind an impact is.
pub(super) fn classify(loaded: &Loaded, ask: &Classify, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let index = stage(ask.stage.as_deref(), builder, path)?;
    let Some(Stage::Impact(impact)) = loaded.draft.scene.stages.get(index) else {
        let fault = Fault::new(Code::Value, format!("{} is not an impact", builder.phrase_of(index)));
        builder.fault(fault.help("name a stage that is an impact: `stage: hit`").at_path(path.key("classify")));
        return None;
    };
    let (right, because) = if impact.plastic {
        (2, "the bodies stay together (e = 0)")
    } else if is_elastic(loaded, impact) {
        (0, "e = 1: no kinetic energy is lost")
    } else {
        (1, "e lies between 0 and 1: the bodies separate, and some kinetic energy is lost")
    };
    let label = format!("Of which kind is {}?", builder.phrase_of(index));
    let options = KINDS.map(str::to_owned).to_vec();
    let decision = Decision { options, right, because: because.into() };
    Some((label, PartKind::Choice(ChoicePart::Settled(decision))))
}

/// Forces that never have time to act in a short impact, whatever the scene.
const ORDINARY: &[(&str, &str)] = &[
    ("weight", "it stays as it is during the short contact, so its impulse is negligible"),
    ("gravity", "it stays as it is during the short contact, so its impulse is negligible"),
    ("friction", "it is bounded by the ordinary normal force, so in the short contact its impulse is negligible"),
    ("normal force", "nothing impulsive presses the body into the ground, so it stays as it is"),
    ("spring force", "it depends on the spring's length, which hardly changes during the short contact"),
    ("air resistance", "it stays small during the short contact, so its impulse is negligible"),
];

/// Whether a force is impulsive in a stage.
pub(super) fn impulsive(_: &Loaded, ask: &Impulsive, builder: &mut Builder<'_>, path: &Path) -> Option<Question> {
    let stage = stage(ask.stage.as_deref(), builder, path)?;
    let force = ask.impulsive.trim();
    let phrase = builder.phrase_of(stage);
    let bare = force.trim_start_matches("the ");
    let acts = |impulse: &&Impulse| {
        let named = impulse.called.trim_start_matches("the ");
        impulse.stage == stage
            && (named == bare || named.strip_prefix("contact with ") == Some(bare) || bare == "contact force")
    };
    let from_scene = builder.impulses().iter().find(acts).map(|impulse| impulse.impulsive);
    let ordinary = ORDINARY.iter().find(|(name, _)| *name == bare);
    let verdict = match (ordinary, from_scene) {
        (Some((_, why)), _) => (false, (*why).to_owned()),
        (None, Some(true)) => {
            (true, "it becomes very large for a very short time, so its impulse is not negligible".into())
        }
        (None, Some(false)) => (false, "it stays of ordinary size for an ordinary time".into()),
        (None, None) => {
            let known: Vec<&str> =
                builder.impulses().iter().filter(|own| own.stage == stage).map(|own| own.called.as_str()).collect();
            let all: Vec<&str> = ORDINARY.iter().map(|row| row.0).chain(known).collect();
            let help = did_you_mean(bare, all.iter().copied()).map(|near| format!("did you mean `{near}`?"));
            let help = help.unwrap_or_else(|| format!("known here: {}", all.join(", ")));
            let fault = Fault::new(Code::UnknownName, format!("no force called `{force}` acts in {phrase}"));
            builder.fault(fault.help(help).at_path(path.key("impulsive")));
            return None;
        }
    };
    let owner = ask.on.as_ref().map(|body| builder.name_of(body));
    let named = impulsive_force(force, from_scene == Some(true), owner.as_deref());
    Some((format!("Is {named} impulsive during {phrase}?"), yes_or_no(verdict)))
}

/// A force as the subject of a sentence: what gives an impulse, such as a bat, is not itself a force.
fn impulsive_force(force: &str, is_giver: bool, owner: Option<&str>) -> String {
    let bare = ["gravity", "friction", "air resistance"].contains(&force) || force.starts_with("the ");
    let named = if bare { force.to_owned() } else { format!("the {force}") };
    let is_giver = is_giver && !force.contains("force") && !force.contains("contact");
    let named = if is_giver { format!("the force of {named}") } else { named };
    match owner {
        Some(owner) if force == "weight" => format!("{named} of {owner}"),
        Some(owner) => format!("{named} on {owner}"),
        None => named,
    }
}

fn join(names: &[String]) -> String {
    match names {
        [] => "the system".into(),
        [only] => only.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// The stage that a question means: the one named, or the only one.
fn stage(name: Option<&str>, builder: &mut Builder<'_>, path: &Path) -> Option<usize> {
    let found = match name {
        Some(name) => builder.stage_of(name),
        None => (builder.scene().stages.len() == 1).then_some(0),
    };
    if found.is_none() {
        let message = match name {
            _ if builder.scene().stages.is_empty() => "nothing happens in this scene: it has no stage".to_owned(),
            None => "it is not said which stage is meant".to_owned(),
            Some(name) => format!("there is no stage `{name}`"),
        };
        let help = if builder.scene().stages.is_empty() {
            "say under `stages` what happens, as `- impact: { between: [A, B], restitution: e }`"
        } else {
            "give the stage a `name` and write it here: `stage: hit`"
        };
        builder.fault(Fault::new(Code::UnknownName, message).help(help).at_path(path.key("stage")));
    }
    found
}
