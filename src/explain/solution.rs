//! The worked solution: five sections for everyone, and one for the instructor.

use crate::problem::Worked;
use crate::scene::Scene;
use crate::scene::Stage;
use crate::scene::stage::Ends;

use super::Audience;
use super::Block;
use super::Inline;
use super::Outline;
use super::Section;
use super::answers;
use super::axes;
use super::cache::SolutionCache;
use super::checks;
use super::computed;
use super::diagrams;
use super::display::Display;
use super::display::Shown;
use super::instructor;
use super::script;
use super::steps::Detail;
use super::steps::Steps;
use super::steps::WITHOUT_ZEROS;
use super::steps::text;
use super::wording::capitalised;
use super::wording::list;

/// The worked solution of a variant, with a last section where instructors read it.
#[must_use]
pub fn solution(worked: Worked<'_>, audience: Audience) -> Outline {
    let cache = SolutionCache::of(worked);
    let shown = Shown::default();
    let display = Display { worked, way: cache.way(worked), shown: &shown };
    shown.figures.get_or_init(|| computed::figures(display));
    let answers = answers::answers(display);
    let checks = checks::checks(display);
    let closing = if checks.is_empty() { "Answer" } else { "Answer and check" };
    let mut sections = vec![
        section("System", display.way.system.get_or_init(|| system(worked)).clone()),
        acting(display),
        section("Axes and what is given", axes::axes(display)),
        section("Laws", laws(display, Detail::Full)),
        section(closing, answers.into_iter().chain(checks).collect()),
    ];
    sections.retain(|section| !section.blocks.is_empty());
    if audience == Audience::Instructor {
        sections.push(Section { audience, ..section("Certificate and equations used", instructor::notes(display)) });
    }
    Outline { title: worked.problem.title().to_owned(), sections }
}

/// What acts, with its diagrams where there are any.
fn acting(display: Display<'_>) -> Section {
    let blocks = diagrams::diagrams(display);
    let drawn = blocks.iter().any(|block| matches!(block, Block::Figure(_)));
    section(if drawn { "Momentum and impulse diagrams" } else { "Forces and impulses" }, blocks)
}

/// The worked solution on one page: what is given, the laws with their equations, the values found, and the answers.
#[must_use]
pub fn brief(worked: Worked<'_>) -> Outline {
    let cache = SolutionCache::of(worked);
    let shown = Shown::default();
    let display = Display { worked, way: cache.way(worked), shown: &shown };
    shown.figures.get_or_init(|| computed::figures(display));
    let mut sections = vec![
        section("Axes and what is given", axes::axes(display)),
        section("Laws", laws(display, Detail::Brief)),
        section("Answer", answers::answers(display)),
    ];
    sections.retain(|section| !section.blocks.is_empty());
    Outline { title: worked.problem.title().to_owned(), sections }
}

fn section(heading: &str, blocks: Vec<Block>) -> Section {
    Section { heading: heading.to_owned(), audience: Audience::Everyone, blocks }
}

/// Who belongs to the system, and from when to when it is looked at.
fn system(worked: Worked<'_>) -> Vec<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    // What comes apart belongs to the system as its parts.
    let whole = |body: &String| !scene.division_of(body).is_empty();
    let names: Vec<String> =
        scene.bodies.iter().filter(|(own, _)| !whole(own)).map(|(_, body)| body.name.clone()).collect();
    let together = if names.len() > 1 { " together" } else { "" };
    let who = capitalised(&format!("{}{together}", list(&names)));
    let last = worked.problem.model().when(scene, scene.stages.len() + 1);
    let when = if scene.stages.is_empty() {
        "at one instant".to_owned()
    } else if worked.problem.model().when(scene, 1) == last {
        last
    } else {
        let last = scene.stages.len() + 1;
        format!(
            "{} (1) and {} ({last})",
            worked.problem.model().when(scene, 1),
            worked.problem.model().when(scene, last)
        )
    };
    let mut blocks = vec![text(&format!("{who}, {when}."))];
    if scene.stages.len() > 1 {
        let rows = scene.stages.iter().enumerate().map(|(index, stage)| {
            let phrase = worked.problem.model().phrase(scene, index);
            vec![Inline::Text(format!(
                "From ({}) to ({}): {}.",
                index + 1,
                index + 2,
                happening(scene, stage, &phrase)
            ))]
        });
        blocks.push(Block::List(rows.collect()));
    }
    blocks
}

/// What happens in a stage, as a noun phrase.
fn happening(scene: &Scene, stage: &Stage, phrase: &str) -> String {
    let name = |body: &str| scene.called(body);
    let does = |body: &str, forms: [&str; 2]| scene.does(body, forms);
    match stage {
        Stage::Impact(impact) => match (&impact.between, &impact.body, &impact.against) {
            (Some([a, b]), ..) => format!("{phrase} of {} and {}", name(a), name(b)),
            (_, Some(body), Some(surface)) => format!("{phrase} of {} on {}", name(body), surface_name(scene, surface)),
            _ => phrase.to_owned(),
        },
        Stage::Push(push) => format!("forces act on {}", name(&push.body)),
        Stage::Slide(slide) => does(&slide.body, ["slides", "slide"]),
        Stage::Spring(spring) => match spring.ends() {
            Some(Ends::Free(first, second)) => format!("the spring acts between {} and {}", name(first), name(second)),
            Some(Ends::Fixed(body)) => format!("the spring acts on {}", name(body)),
            None => phrase.to_owned(),
        },
        Stage::Swing(swing) => does(&swing.body, ["swings on its cord", "swing on their cord"]),
        Stage::Taut(taut) => {
            format!("the string between {} and {} goes taut", name(&taut.between[0]), name(&taut.between[1]))
        }
        Stage::Connected(connected) => {
            let [leading, trailing] = [&connected.leading, &connected.trailing].map(|strand| name(&strand.body));
            format!("{leading} pulls {trailing} along by the string")
        }
        Stage::Tow(tow) => {
            let [front, rear] = tow.both().map(|own| name(&own.body));
            format!("{front} and {rear} move together")
        }
        Stage::Blow(blow) => format!("{} acts on {}", blow.by, name(&blow.body)),
        Stage::Rotate(rotate) => {
            let held: Vec<String> = rotate.held().into_iter().map(|(body, _)| name(body)).collect();
            if let Some(rotor) = &rotate.rotor {
                let with = if held.is_empty() { String::new() } else { format!(", with {} on it", list(&held)) };
                return format!("{} turns{with}", name(rotor));
            }
            let [turns, its] = if held.len() > 1 { ["move", "the"] } else { ["moves", "its"] };
            format!("{} {turns} round on {its} arm", list(&held))
        }
        Stage::Moment(_) => "a moment acts on them".to_owned(),
        Stage::Strike(strike) => {
            let arm = strike.rotor.as_ref().map_or_else(|| "the arm".to_owned(), |rotor| name(rotor));
            format!("{} strikes {arm}", name(&strike.body))
        }
        Stage::Conical(conical) => format!("the cord of {} changes its length", name(&conical.body)),
        Stage::Bowl(bowl) => format!("{} slides round inside the wall", name(&bowl.body)),
        Stage::Interact(interact) => {
            let bodies: Vec<String> = interact.between.iter().map(|body| name(body)).collect();
            format!("{} act on each other", list(&bodies))
        }
        Stage::Central(central) => format!("{} moves under the central force", name(&central.body)),
        Stage::Fall(fall) => format!("{} falls", name(&fall.body)),
        Stage::Motion(motion) => format!("{} moves as given", name(&motion.body)),
        Stage::Bounces(bounces) => format!("{} bounces", name(&bounces.body)),
        Stage::SlideOff(slide) => format!("{} slides down {}", name(&slide.body), name(&slide.on)),
        Stage::Walk(walk) => format!("{} walks along {}", name(&walk.body), name(&walk.on)),
        Stage::Stream(stream) => format!("{} acts on {}", stream.by, name(&stream.body)),
        Stage::Thrust(thrust) => format!("{} burns its fuel", name(&thrust.body)),
        Stage::Drift(_) => "no net force acts; every body keeps its velocity".to_owned(),
        Stage::Flight(flight) => {
            let bodies: Vec<String> = flight.flying().map(|body| scene.called(body)).collect();
            format!("{} {} freely", list(&bodies), if bodies.len() > 1 { "move" } else { "moves" })
        }
        Stage::Separate(separate) => {
            format!("{phrase} of {}", list(&separate.into.iter().map(|part| name(part)).collect::<Vec<_>>()))
        }
    }
}

fn surface_name(scene: &Scene, surface: &str) -> String {
    let own = scene.surfaces.get(surface).and_then(|entry| entry.name.clone());
    own.unwrap_or_else(|| format!("the {surface}"))
}

/// The steps of the answer plan.
fn laws(display: Display<'_>, detail: Detail) -> Vec<Block> {
    let worked = display.worked;
    let mut steps = Steps::new(display, detail);
    let scripts = display.way.laws.get_or_init(|| script::scripts(display));
    let mut blocks = Vec::new();
    if let [first, ..] = &worked.leaf().words[..] {
        blocks.push(text(&format!("{}.", capitalised(first))));
    }
    for (position, (step, script)) in worked.leaf().answer_steps().iter().zip(scripts).enumerate() {
        blocks.extend(steps.step(position, step, script));
    }
    without_repetition(blocks)
}

/// Leaves out a sentence that says of the next equation what was just said of the one before.
fn without_repetition(blocks: Vec<Block>) -> Vec<Block> {
    let mut said: Option<usize> = None;
    let mut kept: Vec<Block> = Vec::with_capacity(blocks.len());
    for block in blocks {
        if matches!(block, Block::Paragraph(_)) && block != text(WITHOUT_ZEROS) {
            if said.and_then(|place| kept.get(place)) == Some(&block) {
                continue;
            }
            said = Some(kept.len());
        }
        kept.push(block);
    }
    kept
}
