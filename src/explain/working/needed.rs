//! Which results of a step a short solution prints: those that are asked, and those from which something printed follows.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_problem::PartKind;
use momentous_problem::Worked;
use momentous_solve::Closed;
use momentous_solve::Root;
use momentous_solve::Statement;
use momentous_solve::Step;

/// For each step of the answer plan, the quantities that are asked or that a later step mentions.
pub(crate) fn later(worked: Worked<'_>) -> Vec<BTreeSet<Symbol>> {
    let mut needed = asked(worked);
    let steps = worked.leaf().answer_steps();
    let mut later: Vec<BTreeSet<Symbol>> = Vec::with_capacity(steps.len());
    for step in steps.iter().rev() {
        later.push(needed.clone());
        needed.extend(mentioned(worked, step));
    }
    later.reverse();
    later
}

/// The symbols that the parts ask, and those in which their answers are told or from which they are decided.
pub(crate) fn asked(worked: Worked<'_>) -> BTreeSet<Symbol> {
    let parts = worked.form.parts.iter();
    let wanted = |kind: &PartKind| {
        let decides = match kind {
            PartKind::Choice(choice) => choice.depends_on().into_iter().collect(),
            _ => Vec::new(),
        };
        kind.wanted().into_iter().chain(kind.in_terms_of()).chain(decides)
    };
    parts.flat_map(|part| wanted(&part.kind)).collect()
}

/// The quantities that a step mentions.
pub(super) fn mentioned(worked: Worked<'_>, step: &Step) -> impl Iterator<Item = Symbol> {
    let equations = &worked.leaf().system.equations;
    let stated = step.equations.iter().filter_map(|place| equations.get(*place));
    let sides = stated.flat_map(|equation| match &equation.statement {
        Statement::Equal { left, right } | Statement::FirstInteger { left, right, .. } => {
            left.symbols().into_iter().chain(right.symbols())
        }
    });
    let values = step.roots.iter().flat_map(|root| &root.values);
    sides.chain(values.flat_map(|(_, closed): &(Symbol, Closed)| closed.symbols())).collect::<Vec<_>>().into_iter()
}

/// Whether each value of a root is printed, where those are needed later.
pub(crate) fn printed(root: &Root, later: &BTreeSet<Symbol>) -> Vec<bool> {
    let mut needed = later.clone();
    let mut printed: Vec<bool> = root
        .values
        .iter()
        .rev()
        .map(|(unknown, closed)| {
            let is_needed = needed.contains(unknown);
            if is_needed {
                needed.extend(closed.symbols());
            }
            is_needed
        })
        .collect();
    printed.reverse();
    printed
}
