//! The section on momentum and impulse: the figures, what acts, what is left out and why.

use std::collections::BTreeSet;

use momentous_laws::angular;
use momentous_laws::momentum;
use momentous_model::Omission;
use momentous_model::Omitted;
use momentous_problem::PartKind;
use momentous_problem::Worked;
use momentous_scene::Stage;
use momentous_scene::stage::Impact;

use super::super::Block;
use super::super::Inline;
use super::super::asked::solution_figures;
use super::super::cache::WayCache;
use super::super::reach::last_instant;
use super::super::reach::laws_used;
use super::super::terms::display::Display;
use super::super::wording::capitalised;
use super::stage_words::acting;

/// The section's blocks; none where nothing happens in the scene.
pub(crate) fn diagrams(display: Display<'_>, way: &WayCache) -> Vec<Block> {
    let worked = display.worked;
    let mut blocks: Vec<Block> =
        solution_figures(worked).into_iter().map(|drawing| Block::Figure(Box::new(drawing))).collect();
    blocks.extend_from_slice(way.acting.get_or_init(|| sentences(worked)));
    blocks.extend(neglected(worked));
    blocks.extend(why_not_energy(worked));
    blocks
}

/// How much of the change of momentum is left out, where that is worth a word.
fn neglected(worked: Worked<'_>) -> impl Iterator<Item = Block> {
    let scene = &worked.problem.loaded().draft.scene;
    worked.neglected().into_iter().map(move |(weight, share)| {
        Block::text(&format!(
            "In {} the impulse of weight, which is neglected, is {:.1} % of the change of momentum of {}.",
            worked.problem.model().phrase(scene, weight.stage),
            100.0 * share,
            scene.called(&weight.on)
        ))
    })
}

/// The influences in each stage, and the omissions.
fn sentences(worked: Worked<'_>) -> Vec<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    let model = worked.problem.model();
    // Also at its start a force acts.
    let stages = last_instant(worked).max(2) - 1;
    let acting =
        scene.stages.iter().enumerate().take(stages).filter_map(|(index, stage)| acting(model, scene, index, stage));
    let mut blocks: Vec<Block> = acting.map(|sentence| Block::text(&sentence)).collect();
    let solved = solved_stages(worked);
    for (heading, kind) in [("Neglected:", Omitted::Neglected), ("Not needed:", Omitted::NotNeeded)] {
        let is_here = |omission: &&Omission| omission.kind == kind && !omission.stages.is_disjoint(&solved);
        let of_kind = model.omissions.iter().filter(is_here);
        let items: Vec<Vec<Inline>> = of_kind
            .map(|omission| vec![Inline::Text(format!("{}, because {}.", capitalised(&omission.what), omission.why))])
            .collect();
        if !items.is_empty() {
            blocks.extend([Block::text(heading), Block::List(items)]);
        }
    }
    blocks
}

/// The laws of momentum that serve in an impact.
const MOMENTUM: [&str; 4] =
    [momentum::CONSERVATION.id, momentum::IMPULSE_MOMENTUM.id, momentum::SYSTEM.id, angular::CONSERVATION.id];

/// The stages whose laws the answers need; all that are looked at where something is to be decided.
fn solved_stages(worked: Worked<'_>) -> BTreeSet<usize> {
    let decides = worked.form.parts.iter().any(|part| matches!(part.kind, PartKind::Choice(_)));
    if decides { (0..last_instant(worked)).collect() } else { laws_used(worked).filter_map(|law| law.stage).collect() }
}

/// Why momentum serves where energy does not, for impacts that lose energy and are solved by momentum.
fn why_not_energy(worked: Worked<'_>) -> Option<Block> {
    let scene = &worked.problem.loaded().draft.scene;
    let symbols = &worked.problem.model().symbols;
    let is_one = |e: &str| {
        let given = worked.variant.all_given().iter();
        e == "1"
            || given
                .into_iter()
                .any(|(symbol, value, _)| symbols.entry(*symbol).name == e && value.to_rational().is_one())
    };
    let loses = |impact: &Impact| impact.plastic || impact.restitution.as_ref().is_some_and(|e| !is_one(e.0.trim()));
    let by_momentum: BTreeSet<usize> =
        laws_used(worked).filter(|law| MOMENTUM.contains(&law.law.id)).filter_map(|law| law.stage).collect();
    let stages = scene.stages.iter().enumerate().filter(|(index, _)| by_momentum.contains(index));
    let lossy = stages.filter(|(_, stage)| matches!(stage, Stage::Impact(impact) if loses(impact)));
    let (impacts, change) = match lossy.count() {
        0 => return None,
        1 => ("the impact", "changes"),
        _ => ("the impacts", "change"),
    };
    let is_energy = |symbol| worked.problem.model().name(symbol).kind.is_kinetic_energy();
    let told_energy = worked.variant.all_given().iter().any(|(symbol, ..)| is_energy(*symbol));
    let asked = worked.form.parts.iter().filter(|part| !matches!(part.kind, PartKind::Choice(_)));
    let on_energy = asked.flat_map(|part| part.kind.wanted()).any(is_energy);
    (!told_energy).then(|| {
        let afterwards = if on_energy { " The energy is worked out afterwards, from the velocities." } else { "" };
        Block::text(&format!(
            "Why momentum and not energy: {impacts} {change} the kinetic energy, and by how much is not known beforehand.{afterwards}"
        ))
    })
}
