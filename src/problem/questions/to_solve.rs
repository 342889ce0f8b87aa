//! The quantities of a question that have to be solved.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_model::Builder;
use momentous_model::QuantityKind;

use super::super::language::form;
use super::super::reading::load::Loaded;

/// Selects the quantities that have to be solved: they have no value of their own.
pub(super) fn to_solve(loaded: &Loaded, builder: &Builder<'_>, quantities: BTreeSet<Symbol>) -> Vec<Symbol> {
    let has_value = |name: &str| loaded.given.get(name).is_some_and(|given| !given.is_derived());
    let is_told = |symbol: Symbol| {
        let name = &builder.symbols().entry(symbol).name;
        // Gravity has a value of its own.
        builder.name(symbol).kind == QuantityKind::Gravity
            || has_value(name)
            || name.split_once('.').is_some_and(|(whole, _)| has_value(whole))
    };
    quantities.into_iter().filter(|symbol| !builder.is_literal(*symbol) && !is_told(*symbol)).collect()
}

/// Selects the quantities that have to be solved and are not revealed by the form.
pub(super) fn to_solve_unrevealed(
    loaded: &Loaded,
    question: &form::Question,
    builder: &mut Builder<'_>,
    quantities: &BTreeSet<Symbol>,
) -> Vec<Symbol> {
    let revealed: BTreeSet<Symbol> = question.reveal.iter().filter_map(|name| builder.mention(name)).collect();
    to_solve(loaded, builder, quantities - &revealed)
}
