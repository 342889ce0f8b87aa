//! How far into its scene a solution goes: what only other forms ask is not looked at.

use momentous_expr::Symbol;
use momentous_model::Instance;
use momentous_model::Instant;
use momentous_model::QuantityKind;
use momentous_problem::PartKind;
use momentous_problem::Worked;
use momentous_solve::Equation;

/// The last instant that a step towards an answer looks at, counted from 1; that of the scene where something is to be decided.
#[must_use]
pub fn last_instant(worked: Worked<'_>) -> usize {
    let (model, leaf) = (worked.problem.model(), worked.leaf());
    let last = worked.problem.loaded().draft.scene.stages.len() + 1;
    if worked.form.parts.iter().any(|part| matches!(part.kind, PartKind::Choice(_))) {
        return last;
    }
    let instant = |symbol: Symbol| {
        let name = model.name(symbol);
        match name.instant {
            // Heights have the numbers of bounces.
            Some(Instant::Number(number)) if name.kind != QuantityKind::Height => Some(number),
            _ => None,
        }
    };
    let reached = |equation: &Equation| {
        let stage = model.instances.get(equation.tag).and_then(|instance| instance.stage);
        let end = stage.map(|stage| stage + 2);
        end.or_else(|| equation.symbols().into_iter().filter_map(instant).max())
    };
    let used = leaf.answer_steps().iter().flat_map(|step| &step.equations);
    let reached = used.filter_map(|place| reached(leaf.system.equations.get(*place)?));
    reached.max().map_or(last, |reached| reached.min(last))
}

/// The laws that the steps towards the answers use, each with its stage.
pub(crate) fn laws_used(worked: Worked<'_>) -> impl Iterator<Item = &Instance> {
    let leaf = worked.leaf();
    let equations = leaf.answer_steps().iter().flat_map(|step| &step.equations);
    let stated = equations.filter_map(|place| leaf.system.equations.get(*place));
    stated.filter_map(move |equation| worked.problem.model().instances.get(equation.tag))
}
