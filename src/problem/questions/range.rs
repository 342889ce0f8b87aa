//! For which values of a quantity something holds: the boundary is solved, the side is found by trial.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Model;
use momentous_model::Warning;
use momentous_solve::Equation;
use momentous_solve::Planner;
use momentous_solve::Relation;

use super::super::compiling::lacking;
use super::super::compiling::regimes::Regimes;
use super::super::language::ask::Answered;
use super::super::language::ask::Find;
use super::super::language::ask::Range;
use super::super::language::entries::Entries;
use super::super::reading::load::Loaded;
use super::choices::comparing;
use super::number::number_part;
use super::part::Part;
use super::part::PartKind;
use super::part::RangePart;

/// Reads the question: the label, the kind, and the equation of the boundary.
pub(crate) fn read(
    loaded: &Loaded,
    ask: &Range,
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<(String, PartKind, Equation)> {
    let Some(symbol) = builder.mention(&ask.range) else {
        let fault = builder.unknown(&ask.range).at_path(path.key("range"));
        builder.fault(fault);
        return None;
    };
    let find = Find {
        id: None,
        find: ask.range.clone(),
        answered: Answered::Number,
        roots: None,
        unit: ask.unit.clone(),
        tolerance: ask.tolerance.clone(),
        figures: ask.figures,
        points: None,
        from: None,
        sense: None,
        label: None,
        expect: Entries::default(),
    };
    let number = number_part(loaded, &find, symbol, builder, path)?;
    let (question, claim) = comparing::claim(loaded, &ask.condition, builder, &path.key("where"))?;
    if let Relation::Differs | Relation::Equals = claim.relation {
        let fault = Fault::new(Code::Value, "`=` and `!=` define no interval");
        builder.fault(fault.help("compare with `<`, `<=`, `>` or `>=`").at_path(path.key("where")));
        return None;
    }
    let boundary = builder.boundary(claim.left.clone(), claim.right.clone());
    let entry = builder.symbols().entry(symbol);
    let quantity = match entry.meaning.as_str() {
        "" => ask.range.clone(),
        meaning => format!("values of {meaning}, {},", ask.range),
    };
    let label = format!("For which {quantity} is {question}?");
    Some((label, PartKind::Range(RangePart { number, claim }), boundary))
}

/// Plans that give the sides of each claim from a value of the quantity whose range is asked, by that quantity.
pub(crate) fn trials(
    planner: &mut Planner,
    model: &Model,
    parts: &[Part],
    told: &BTreeSet<Symbol>,
    allowed: &[Warning],
) -> Result<Vec<(Symbol, Regimes)>, Fault> {
    let ranges = parts.iter().filter_map(|part| match &part.kind {
        PartKind::Range(range) => Some(range),
        _ => None,
    });
    let trial = |range: &RangePart| {
        let symbol = range.number.symbol;
        let mut alone = || Regimes::plan(planner, model, &[], &[], told, &range.claim.quantities, allowed);
        if !range.claim.symbols().contains(&symbol) && alone().is_ok() {
            let name = &model.symbols.entry(symbol).name;
            let message = format!("whether the condition holds does not depend on `{name}`");
            let help = format!("ask about something that depends on `{name}`: `where: v_A2 < 0 m/s`");
            return Err(Fault::new(Code::UnderDetermined, message).help(help));
        }
        let told = told.iter().copied().chain([symbol]).collect();
        let planned = Regimes::plan(planner, model, &[], &[], &told, &range.claim.quantities, allowed);
        let planned = planned.map_err(|unplanned| lacking::fault(planner, model, &unplanned))?;
        Ok((symbol, planned))
    };
    ranges.map(trial).collect()
}
