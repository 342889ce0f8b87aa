//! The worked solution: short as a textbook prints it, or in full.

use std::collections::BTreeSet;

use momentous_figure::Drawing;
use momentous_model::Timeline;
use momentous_problem::Worked;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Slide;
use momentous_solve::Step;

use super::super::Audience;
use super::super::Block;
use super::super::Detail;
use super::super::Inline;
use super::super::Outline;
use super::super::Section;
use super::super::asked::solution_figures;
use super::super::cache::SolutionCache;
use super::super::cache::WayCache;
use super::super::computed;
use super::super::reach::last_instant;
use super::super::terms::display::Display;
use super::super::terms::display::PrintedTerms;
use super::super::wording::capitalised;
use super::super::working::script::Script;
use super::super::working::short::ShortSteps;
use super::super::working::steps::Steps;
use super::super::working::steps::WITHOUT_ZEROS;
use super::answers;
use super::axes;
use super::diagrams;
use super::instructor;
use super::stage_words::happening;
use momentous_scene::list;

/// The worked solution of a variant: the system with its figures and what is given, the laws with their equations, and the answers;
/// in full also what acts, what is left out, and the checks. Instructors read a last section.
#[must_use]
pub fn solution(worked: Worked<'_>, audience: Audience, detail: Detail) -> Outline {
    let cache = SolutionCache::of(worked);
    let shown = PrintedTerms::default();
    let way = cache.way(worked);
    let display = Display { worked, manners: &way.manners, shown: &shown };
    shown.figures.get_or_init(|| computed::figures(display, way, detail));
    let mut sections = match detail {
        Detail::Short => short(display, way),
        Detail::Full => full(display, way),
    };
    sections.retain(|section| !section.blocks.is_empty());
    if audience == Audience::Instructor {
        sections.push(Section { audience, ..section("Certificate and equations used", instructor::notes(display)) });
    }
    let outline = Outline { title: worked.problem.title().to_owned(), sections };
    let scene = &worked.problem.loaded().draft.scene;
    if scene.has_plurals() { outline.reworded(&|words| scene.in_agreement(words)) } else { outline }
}

fn short(display: Display<'_>, way: &WayCache) -> Vec<Section> {
    let mut opening: Vec<Block> = without_repeated_legends(solution_figures(display.worked))
        .map(|drawing| Block::Figure(Box::new(drawing)))
        .collect();
    opening.extend(way.system.get_or_init(|| system(display.worked)).iter().cloned());
    opening.extend(axes::axes(display, way));
    let mut steps = ShortSteps::new(display);
    let blocks =
        laws(display, way.scripts(display, Detail::Short), |place, step, script| steps.step(place, step, script));
    vec![
        section("System", opening),
        section("Laws", blocks),
        section("Answer", answers::answers(display, Detail::Short)),
    ]
}

fn full(display: Display<'_>, way: &WayCache) -> Vec<Section> {
    let mut steps = Steps::new(display);
    let blocks =
        laws(display, way.scripts(display, Detail::Full), |place, step, script| steps.step(place, step, script));
    let checks = way.checks(display).blocks(display);
    let closing = if checks.is_empty() { "Answer" } else { "Answer and check" };
    vec![
        section("System", way.system.get_or_init(|| system(display.worked)).clone()),
        acting(display, way),
        section("Axes and what is given", axes::axes(display, way)),
        section("Laws", blocks),
        section(closing, answers::answers(display, Detail::Full).into_iter().chain(checks).collect()),
    ]
}

/// The figures, each with a caption that does not repeat what the first one explains: the balance that it draws, between a colon and
/// those for whom it holds.
fn without_repeated_legends(figures: Vec<Drawing>) -> impl Iterator<Item = Drawing> {
    let mut explained = BTreeSet::new();
    figures.into_iter().map(move |mut figure| {
        if let Some((subject, legend)) = figure.caption.split_once(": ")
            && let Some((balance, whom)) = legend.split_once(", for ")
            && !explained.insert(balance.to_owned())
        {
            figure.caption = format!("{subject}, for {whom}");
        }
        figure
    })
}

/// The influences, with their diagrams where there are any.
fn acting(display: Display<'_>, way: &WayCache) -> Section {
    let blocks = diagrams::diagrams(display, way);
    let drawn = blocks.iter().any(|block| matches!(block, Block::Figure(_)));
    section(if drawn { "Momentum and impulse diagrams" } else { "Forces and impulses" }, blocks)
}

fn section(heading: &str, blocks: Vec<Block>) -> Section {
    Section { heading: heading.to_owned(), audience: Audience::Everyone, blocks }
}

/// The bodies of the system, and the span for which it is looked at.
fn system(worked: Worked<'_>) -> Vec<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    // The balance is that of what flows on.
    if let [Stage::Stream(stream)] = &scene.stages[..]
        && !stream.stays
    {
        let words = format!("{} where it meets {}.", stream.by, scene.called(&stream.body));
        return vec![Block::text(&capitalised(&words))];
    }
    let last = last_instant(worked);
    let who = capitalised(&list(&taking_part(worked, last)));
    let [start, end] = [1, last].map(|instant| worked.problem.model().when(scene, instant));
    let when = if scene.stages.is_empty() {
        "at one instant".to_owned()
    } else if start == end {
        end
    } else {
        format!("{start} (1) and {end} ({last})")
    };
    // Several stages say themselves when each begins and ends.
    let opening = if last > 2 { format!("{who}.") } else { format!("{who}, {when}.") };
    let mut blocks = vec![Block::text(&opening)];
    if last > 2 {
        let timeline = Timeline::new(scene);
        let rows = scene.stages.iter().enumerate().take(last - 1).map(|(index, stage)| {
            let phrase = worked.problem.model().phrase(scene, index);
            vec![Inline::Text(format!(
                "From ({}) to ({}): {}.",
                begins(scene, &timeline, index),
                index + 2,
                happening(scene, stage, &phrase)
            ))]
        });
        blocks.push(Block::List(rows.collect()));
    }
    blocks
}

/// The instant from which a stage runs. A body that slides or flies has done so since something set it in motion, beside what
/// happens to others meanwhile.
fn begins(scene: &Scene, timeline: &Timeline, index: usize) -> usize {
    let mut moving: Vec<&str> = Vec::new();
    if let Stage::Slide(Slide { body, on: None, .. }) = &scene.stages[index] {
        moving.push(body);
    }
    if let Stage::Flight(flight) = &scene.stages[index] {
        moving.extend(flight.flying());
    }
    let since = moving.into_iter().map(|body| timeline.naming_instant(body, index + 1)).max();
    let is_beside = |since: &usize| *since > 1 && scene.stages[since - 1..index].iter().all(Stage::takes_time);
    since.filter(is_beside).unwrap_or(index + 1)
}

/// The bodies but those to which something happens only after the stages that are looked at, as they are called; what comes apart, or
/// comes together, as its parts.
fn taking_part(worked: Worked<'_>, last: usize) -> Vec<String> {
    let scene = &worked.problem.loaded().draft.scene;
    let on = |looked_at: bool| -> BTreeSet<&str> {
        let all = worked.problem.model().impulses.iter();
        let impulses = all.filter(|impulse| (impulse.stage + 1 < last.max(2)) == looked_at);
        impulses.flat_map(|impulse| scene.members(&impulse.on)).collect()
    };
    let [now, later] = [true, false].map(on);
    let only_later = |body: &str| later.contains(body) && !now.contains(body);
    let undivided = scene.bodies.iter().filter(|(name, _)| scene.division_of(name).is_empty());
    undivided.filter(|(name, _)| !only_later(name)).map(|(_, body)| body.name.clone()).collect()
}

/// The steps of the answer plan.
fn laws(
    display: Display<'_>,
    scripts: &[Script],
    mut write: impl FnMut(usize, &Step, &Script) -> Vec<Block>,
) -> Vec<Block> {
    let leaf = display.worked.leaf();
    let mut blocks = Vec::new();
    if let Some(first) = ways_taken(display).next() {
        blocks.push(Block::text(&format!("{}.", capitalised(first))));
    }
    for (position, (step, script)) in leaf.answer_steps().iter().zip(scripts).enumerate() {
        blocks.extend(write(position, step, script));
    }
    without_repetition(blocks)
}

/// The clauses for stages that can go in several ways, where an equation of that way leads to the answer.
fn ways_taken(display: Display<'_>) -> impl Iterator<Item = &str> {
    let leaf = display.worked.leaf();
    let used = leaf.answer_steps().iter().flat_map(|step| &step.equations);
    let used: BTreeSet<usize> =
        used.filter_map(|place| leaf.system.equations.get(*place)).map(|equation| equation.tag).collect();
    let choices = &display.worked.problem.model().choices;
    choices.iter().zip(&leaf.words).filter_map(move |(ways, what)| {
        let way = ways.iter().find(|way| way.what == *what)?;
        way.equations.iter().any(|equation| used.contains(&equation.tag)).then_some(way.what.as_str())
    })
}

/// Leaves out a sentence that says of the next equation what was just said of the one before.
fn without_repetition(blocks: Vec<Block>) -> Vec<Block> {
    let mut said: Option<usize> = None;
    let mut kept: Vec<Block> = Vec::with_capacity(blocks.len());
    for block in blocks {
        if matches!(block, Block::Paragraph(_)) && block != Block::text(WITHOUT_ZEROS) {
            if said.and_then(|place| kept.get(place)) == Some(&block) {
                continue;
            }
            said = Some(kept.len());
        }
        kept.push(block);
    }
    kept
}
