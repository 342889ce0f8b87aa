//! The section on momentum and impulse: the figures, what acts, what is left out and why.

use crate::model::Agent;
use crate::model::ForceKind;
use crate::model::Impulse;
use crate::model::Model;
use crate::model::Omitted;
use crate::problem::PartKind;
use crate::problem::Worked;
use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Connected;
use crate::scene::stage::Impact;
use crate::scene::stage::Strand;

use super::Block;
use super::Inline;
use super::display::Display;
use super::pictures;
use super::steps::text;
use super::wording::capitalised;
use super::wording::list;

/// The section's blocks; none where nothing happens in the scene.
pub(super) fn diagrams(display: Display<'_>) -> Vec<Block> {
    let worked = display.worked;
    let mut blocks: Vec<Block> =
        pictures::solution(worked).into_iter().map(|drawing| Block::Figure(Box::new(drawing))).collect();
    blocks.extend_from_slice(display.way.acting.get_or_init(|| sentences(worked)));
    blocks.extend(neglected(worked));
    blocks.extend(why_not_energy(worked));
    blocks
}

/// How much of the change of momentum is left out, where that is worth a word.
fn neglected(worked: Worked<'_>) -> impl Iterator<Item = Block> {
    let scene = &worked.problem.loaded().draft.scene;
    worked.neglected().into_iter().map(move |(weight, share)| {
        text(&format!(
            "In {} the impulse of weight, which is neglected, is {:.1} % of the change of momentum of {}.",
            worked.problem.model().phrase(scene, weight.stage),
            100.0 * share,
            scene.called(&weight.on)
        ))
    })
}

/// What acts in each stage, and what is left out.
fn sentences(worked: Worked<'_>) -> Vec<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    let model = worked.problem.model();
    let acting = scene.stages.iter().enumerate().filter_map(|(index, stage)| acting(model, scene, index, stage));
    let mut blocks: Vec<Block> = acting.map(|sentence| text(&sentence)).collect();
    for (heading, kind) in [("Neglected:", Omitted::Neglected), ("Not needed:", Omitted::NotNeeded)] {
        let of_kind = model.omissions.iter().filter(|omission| omission.kind == kind);
        let items: Vec<Vec<Inline>> = of_kind
            .map(|omission| vec![Inline::Text(format!("{}, because {}.", capitalised(&omission.what), omission.why))])
            .collect();
        if !items.is_empty() {
            blocks.extend([text(heading), Block::List(items)]);
        }
    }
    blocks
}

/// One sentence on what acts in a stage.
fn acting(model: &Model, scene: &Scene, index: usize, stage: &Stage) -> Option<String> {
    let all = || model.impulses.iter().filter(|impulse| impulse.stage == index);
    // Weight that a short contact includes is no impulsive force.
    let short = matches!(stage, Stage::Impact(_) | Stage::Blow(_));
    let impulses: Vec<&Impulse> = all().filter(|impulse| impulse.impulsive || !short).collect();
    let also = if short && all().any(|impulse| !impulse.impulsive) { "; weight acts as well" } else { "" };
    let first = impulses.first()?;
    let name = |body: &str| scene.called(body);
    let body = name(&first.on);
    let [is, its] = if scene.members(&first.on).len() > 1 { ["are", "their"] } else { ["is", "its"] };
    let phrase = model.phrase(scene, index);
    let during = |sentence: String| match scene.stages.len() {
        1 => format!("{}.", capitalised(&sentence)),
        _ => format!("During {phrase} {sentence}."),
    };
    Some(match (stage, &impulses[..]) {
        (Stage::Impact(_) | Stage::Separate(_), [_, _, ..]) => {
            let inner = impulses.iter().filter(|impulse| matches!(impulse.by, Agent::Body(_)));
            let bodies = inner.map(|impulse| name(&impulse.on)).collect::<Vec<_>>();
            let equal = if bodies.len() == 2 { "equal and opposite impulses" } else { "impulses that cancel" };
            let bodies = list(&bodies);
            let guides = guiding(scene, &impulses);
            let also = if guides.is_empty() { "nothing else is impulsive".to_owned() } else { list(&guides) };
            format!("During {phrase}, {bodies} exert {equal} on each other; {also}.")
        }
        (Stage::SlideOff(slide), _) => during(format!(
            "{} and {} are acted on by their weights and by the support; none of these forces has a component along the motion of {}",
            name(&slide.body),
            name(&slide.on),
            name(&slide.on)
        )),
        (Stage::Flight(flight), _) => {
            let bodies: Vec<String> = flight.flying().map(name).collect();
            let (are, their) = if bodies.len() > 1 { ("are", "their") } else { ("is", "its") };
            during(format!("{} {are} acted on by {their} weight alone", list(&bodies)))
        }
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
        (Stage::Impact(_) | Stage::Blow(_), _) => {
            format!("During {phrase} the only impulsive force on {body} is that of {}{also}.", first.called)
        }
        (Stage::Push(_) | Stage::Slide(_), _) => {
            let forces = model.forces.iter().filter(|force| force.stage == index);
            let called = forces.map(|force| match force.kind {
                ForceKind::Weight => format!("{its} weight"),
                _ => force.called.clone(),
            });
            let mut called: Vec<String> = called.collect();
            // Forces that depend on the position have no impulses of their own in the model.
            if let (Stage::Push(push), true) = (stage, called.is_empty()) {
                called.extend(push.called().map(str::to_owned));
            }
            during(format!("{body} {is} acted on by {}", list(&called)))
        }
        (Stage::Fall(_), _) => during(format!("{body} {is} acted on by its weight alone")),
        (Stage::Spring(_), [one, other]) => during(format!(
            "{} and {} are acted on by the spring between them, with equal and opposite forces",
            name(&one.on),
            name(&other.on)
        )),
        (Stage::Spring(_), _) => during(format!("{body} {is} acted on by the spring")),
        (Stage::Swing(_), _) => during(format!("{body} {is} acted on by {its} weight and the cord")),
        (Stage::Taut(_), [one, other]) => format!(
            "During {phrase}, it pulls {} and {} with impulses of equal size; nothing else is impulsive.",
            name(&one.on),
            name(&other.on)
        ),
        (Stage::Connected(connected), [one, other]) => {
            during(connecting(scene, connected, &list(&[one, other].map(|own| name(&own.on)))))
        }
        (Stage::Taut(_) | Stage::Connected(_), _) => during(format!("{body} {is} acted on by the string")),
        (Stage::Tow(tow), _) => during(format!(
            "{} acts on {} with equal and opposite forces; all other forces are external",
            tow.joint(),
            list(&tow.both().map(|own| name(&own.body)))
        )),
        (Stage::Bounces(_), _) => {
            during(format!("{body} {is} acted on by its weight and, at each bounce, by {}", first.called))
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
        (Stage::Rotate(_) | Stage::Central(_) | Stage::Conical(_) | Stage::Bowl(_) | Stage::Stream(_), _) => {
            during(format!("{body} {is} acted on by {}", first.called))
        }
    })
}

/// What acts on a body that strikes an arm.
fn striking(phrase: &str, body: &str, arm: &str) -> String {
    format!("During {phrase} the only impulsive forces are that between {body} and {arm} and that of the support.")
}

/// What acts on two bodies that a string connects.
fn connecting(scene: &Scene, connected: &Connected, both: &str) -> String {
    let lies = |strand: &&Strand| strand.on.as_ref().is_some_and(|on| on.0.trim() != "hanging");
    let carried = [&connected.leading, &connected.trailing].into_iter().filter(lies);
    let pushed = carried.map(|strand| {
        let rubs = if strand.friction.is_some() { ", with friction" } else { "" };
        format!("; {} is pushed by what carries it{rubs}", scene.called(&strand.body))
    });
    format!("the string pulls {both} with the same tension, and weight acts on both{}", pushed.collect::<String>())
}

/// What each guided body receives from its guide.
fn guiding(scene: &Scene, impulses: &[&Impulse]) -> Vec<String> {
    let guides = impulses.iter().filter(|impulse| impulse.by == Agent::Guide);
    let received = |impulse: &&Impulse| {
        let on = scene.called(&impulse.on);
        format!("{on} receives an impulse perpendicular to its path from {}", impulse.called)
    };
    guides.map(received).collect()
}

/// Why momentum serves where energy does not, in a scene with an impact that loses energy.
fn why_not_energy(worked: Worked<'_>) -> Option<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    let symbols = &worked.problem.model().symbols;
    let is_one = |e: &str| {
        let given = worked.variant.all_given().iter();
        e == "1"
            || given.into_iter().any(|(own, value, _)| symbols.entry(*own).name == e && value.to_rational().is_one())
    };
    let loses = |impact: &Impact| impact.plastic || impact.restitution.as_ref().is_some_and(|e| !is_one(e.0.trim()));
    let lossy = scene.stages.iter().filter(|stage| matches!(stage, Stage::Impact(impact) if loses(impact)));
    let impacts = match lossy.count() {
        0 => return None,
        1 => "impact",
        _ => "impacts",
    };
    let is_energy = |symbol| worked.problem.model().name(symbol).kind.is_kinetic_energy();
    let told_energy = worked.variant.all_given().iter().any(|(symbol, ..)| is_energy(*symbol));
    let found = worked.form.parts.iter().filter(|part| !matches!(part.kind, PartKind::Choice(_)));
    let on_energy = found.flat_map(|part| part.kind.wanted()).any(is_energy);
    (!told_energy).then(|| {
        let afterwards = if on_energy { " The energy is worked out afterwards, from the velocities." } else { "" };
        text(&format!(
            "Why momentum and not energy: kinetic energy is lost in the {impacts}, and how much is not known beforehand.{afterwards}"
        ))
    })
}
