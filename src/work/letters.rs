//! The letters that a student may write, with their meanings.

use std::collections::BTreeSet;

use serde::Serialize;

use momentous_expr::Symbol;
use momentous_problem::Worked;
use momentous_solve::Equation;

/// A letter of a problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Letter {
    /// The letter as it is typed: `v_A2`.
    pub name: String,
    /// Its meaning: `the velocity of cart A just after the impact`.
    pub meaning: String,
}

/// The letters of a form: what its sheet tells, what is asked, and what stands between.
#[must_use]
pub fn letters(worked: Worked<'_>) -> Vec<Letter> {
    let model = worked.problem.model();
    let leaf = worked.leaf();
    let equations = leaf.answer_steps().iter().flat_map(|step| &step.equations);
    let used: BTreeSet<Symbol> =
        equations.filter_map(|place| leaf.system.equations.get(*place)).flat_map(Equation::symbols).collect();
    let wanted: Vec<_> = worked.form.wanted().collect();
    let is_shown =
        |symbol: &_| worked.form.on_sheet.contains(symbol) || wanted.contains(symbol) || used.contains(symbol);
    let letter = model.symbols.iter().filter(|(symbol, _)| is_shown(symbol)).map(|(_, entry)| entry);
    letter
        .filter(|entry| entry.name.starts_with(char::is_alphabetic) && !entry.name.contains([' ', '(', '*', '/']))
        .map(|entry| Letter { name: entry.name.clone(), meaning: entry.meaning.clone() })
        .collect()
}
