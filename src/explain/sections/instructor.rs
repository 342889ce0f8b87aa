//! Sections for instructors only: the certificate, and the equations that were used.

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::super::terms::display::with_unit;
use momentous_scene::list;

/// Certificates, equations used, roots that were not solutions.
pub(super) fn notes(display: Display<'_>) -> Vec<Block> {
    let worked = display.worked;
    let mut rows = Vec::new();
    for number in worked.form.parts.iter().flat_map(|part| part.kind.numbers()) {
        let answer = worked.answer(number);
        let unit = number.plain_unit();
        let shown = |value: String| Inline::Math(with_unit(number_math(value), &unit));
        let name = Inline::Math(display.name(number.symbol));
        let mut words = vec![name, Inline::Text(" is ".into()), shown(answer.value.to_string())];
        if answer.error.is_finite() {
            words.extend([Inline::Text(", with an error of at most ".into()), shown(printed(answer.error, 2))]);
        } else {
            words.push(Inline::Text("; no bound on its error can be given".into()));
        }
        words.push(Inline::Text(".".into()));
        rows.push(words);
    }
    let mut blocks = Vec::new();
    if !rows.is_empty() {
        blocks.push(Block::List(rows));
    }
    let model = worked.problem.model();
    let leaf = worked.leaf();
    let used: Vec<&str> = leaf
        .answer_steps()
        .iter()
        .flat_map(|step| &step.equations)
        .filter_map(|equation| leaf.system.equations.get(*equation))
        .filter_map(|equation| model.instances.get(equation.tag))
        .map(|instance| instance.law.name)
        .collect();
    if !used.is_empty() {
        let checks = leaf.audit.checks.len();
        let audit = leaf.audit.plan.steps.len() - leaf.audit.answer_steps;
        blocks.push(Block::text(&format!(
            "Equations of the answer plan, {} in all: {}. The audit solves for {audit} more quantities and checks the answer against {checks} further equations.",
            used.len(),
            list(&counted(&used)),
        )));
    }
    blocks
}

/// Each name once, in the order of its first use, with how often it is used.
fn counted(names: &[&str]) -> Vec<String> {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for name in names {
        match counts.iter_mut().find(|(listed, _)| listed == name) {
            Some((_, count)) => *count += 1,
            None => counts.push((name, 1)),
        }
    }
    let times = |(name, count): (&str, usize)| if count > 1 { format!("{name} ({count} times)") } else { name.into() };
    counts.into_iter().map(times).collect()
}
