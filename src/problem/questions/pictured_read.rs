//! Reading a choice between pictures.

use std::collections::BTreeSet;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::model::Builder;

use super::super::language::ask;
use super::super::language::form::Question;
use super::super::reading::load::Loaded;
use super::comparing;
use super::concept;
use super::decision::ChoicePart;
use super::part::PartKind;
use super::pictured::Ends;
use super::pictured::Pictured;

/// A choice between pictures, asked as the part of that letter.
pub(in crate::problem) fn read(
    loaded: &Loaded,
    question: &Question,
    ask: &ask::Choose,
    letter: &str,
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<PartKind> {
    if !ask.options.is_empty() || ask.last.is_some() {
        let key = if ask.options.is_empty() { "last" } else { "options" };
        let fault = Fault::new(Code::Value, format!("`pictures` and `{key}` are alternatives"));
        builder.fault(fault.help(format!("remove `{key}`: the program draws the pictures")).at_path(path.key(key)));
        return None;
    }
    let stage = concept::stage(ask.stage.as_deref(), builder, path)?;
    let path = path.key("pictures");
    let Some(rows) = rows(stage, builder) else {
        let fault = Fault::new(Code::Value, format!("{} has no diagram to choose", builder.phrase_of(stage)));
        let help = "ask for a sudden stage along one or two axes, with one impulse on each body: an impact, a blow, a separation";
        builder.fault(fault.help(help).at_path(path));
        return None;
    };
    let all: BTreeSet<Symbol> =
        rows.iter().flat_map(|row: &Ends| row.before.iter().chain(&row.after)).flat_map(Expr::symbols).collect();
    let quantities = comparing::to_solve_unrevealed(loaded, question, builder, &all);
    let stream = question.stream(letter);
    Some(PartKind::Choice(ChoicePart::Pictured(Box::new(Pictured { stream, stage, rows, quantities }))))
}

/// The momenta of each body on which the stage gives an impulse; none where its diagram has other arrows.
fn rows(stage: usize, builder: &mut Builder<'_>) -> Option<Vec<Ends>> {
    if !(1..=2).contains(&builder.axis_letters().len()) {
        return None;
    }
    let own = builder.impulses().iter().filter(|impulse| impulse.stage == stage);
    let bodies: Vec<String> = own.clone().map(|impulse| impulse.on.clone()).collect();
    let is_once = bodies.iter().collect::<BTreeSet<_>>().len() == bodies.len();
    let is_sudden = own.into_iter().all(|impulse| impulse.impulsive);
    if bodies.is_empty() || !is_once || !is_sudden {
        return None;
    }
    let row = |body: String| {
        let [before, after] = [stage + 1, stage + 2].map(|instant| builder.moves_with(&body, instant));
        let before = builder.momentum_with(&body, &before?, stage + 1);
        let after = builder.momentum_with(&body, &after?, stage + 2);
        Some(Ends { body, before, after })
    };
    bodies.into_iter().map(row).collect()
}
