//! Reading a choice between pictures.

use std::collections::BTreeSet;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;

use super::super::super::language::ask;
use super::super::super::language::ask::Pictures;
use super::super::super::language::form::Question;
use super::super::super::reading::load::Loaded;
use super::super::choices::choice::ChoicePart;
use super::super::choices::settled;
use super::super::part::PartKind;
use super::super::to_solve::to_solve_unrevealed;
use super::diagram::Diagram;
use super::diagram::Ends;
use super::graph::Plotted;
use super::graph_read;
use super::pictured::Pictured;
use super::pictured::Subject;

/// A choice between pictures, asked as the part of that letter, and its label.
pub(crate) fn read(
    loaded: &Loaded,
    question: &Question,
    ask: &ask::Choose,
    pictures: Pictures,
    letter: &str,
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<(String, PartKind)> {
    if !ask.options.is_empty() || ask.last.is_some() {
        let key = if ask.options.is_empty() { "last" } else { "options" };
        let fault = Fault::new(Code::Value, format!("`pictures` and `{key}` are alternatives"));
        builder.fault(fault.help(format!("remove `{key}`: the program draws the pictures")).at_path(path.key(key)));
        return None;
    }
    let plotted = match pictures {
        Pictures::ImpulseMomentum => None,
        Pictures::VelocityTime => Some(Plotted::Velocity),
        Pictures::MomentumTime => Some(Plotted::Momentum),
        Pictures::ForceTime => Some(Plotted::Force),
    };
    let stages: Vec<usize> = match &ask.stage {
        None if plotted.is_some() && !builder.scene().stages.is_empty() => (0..builder.scene().stages.len()).collect(),
        named => vec![settled::stage(named.as_deref(), builder, path)?],
    };
    let subject = match (plotted, &stages[..]) {
        (None, stages) => Subject::Diagram(diagram(ask, *stages.first()?, builder, path)?),
        (Some(plotted), stages) => Subject::Graph(graph_read::read(ask, (plotted, stages), builder, path)?),
    };
    let quantities = to_solve_unrevealed(loaded, question, builder, &subject.symbols());
    let label = match &subject {
        Subject::Diagram(_) => ask.choose.clone(),
        // Which sense is positive is a matter of the axis, and the sheet draws none.
        Subject::Graph(graph) => format!("{} {}", ask.choose, graph.positive),
    };
    let pictured = Pictured { stream: question.stream(letter), subject, quantities };
    Some((label, PartKind::Choice(ChoicePart::Pictured(Box::new(pictured)))))
}

fn diagram(ask: &ask::Choose, stage: usize, builder: &mut Builder<'_>, path: &Path) -> Option<Diagram> {
    for (key, is_written) in [("of", ask.of.is_some()), ("along", ask.along.is_some())] {
        if is_written {
            let fault = Fault::new(Code::Value, format!("`{key}` is for graphs against time"));
            builder
                .fault(fault.help("remove it: the diagram shows every body along every axis").at_path(path.key(key)));
            return None;
        }
    }
    let Some(rows) = rows(stage, builder) else {
        let fault = Fault::new(Code::Value, format!("{} has no diagram to choose", builder.phrase_of(stage)));
        let help = "ask for a sudden stage along one or two axes, with one impulse on each body: an impact, a blow, a separation";
        builder.fault(fault.help(help).at_path(path.key("pictures")));
        return None;
    };
    Some(Diagram { stage, rows })
}

/// The momenta of each body on which the stage gives an impulse; none where its diagram has other arrows.
fn rows(stage: usize, builder: &mut Builder<'_>) -> Option<Vec<Ends>> {
    if !(1..=2).contains(&builder.axis_letters().len()) {
        return None;
    }
    let impulses = builder.impulses().iter().filter(|impulse| impulse.stage == stage);
    let bodies: Vec<String> = impulses.clone().map(|impulse| impulse.on.clone()).collect();
    let is_once = bodies.iter().collect::<BTreeSet<_>>().len() == bodies.len();
    let is_sudden = impulses.into_iter().all(|impulse| impulse.impulsive);
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
