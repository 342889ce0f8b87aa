//! The audit plan: what else follows cheaply, and which equations then serve as checks.

use std::collections::{BTreeMap, BTreeSet};

use momentous_expr::{Expr, Function, Symbol};
use momentous_quantity::Rational;

use super::super::{Closed, Plan, Statement, Step, System, Tactic};
use super::tactics::{Attempts, Block, close, isolate};

/// A plan extended for judging.
#[derive(Clone, Debug)]
pub struct Audit {
    /// The steps of the answer plan, then the steps that only judging needs.
    pub plan: Plan,
    /// The number of the steps that are the answer plan's.
    pub answer_steps: usize,
    /// Positions of the equations that no step uses, and whose symbols are all found: each must hold at the answer.
    pub checks: Vec<usize>,
}

/// Extends a plan by every symbol that one equation, or two equations for two symbols, give in closed form with one root, again and
/// again.
#[must_use]
pub fn audit(system: &System, known: &BTreeSet<Symbol>, plan: &Plan) -> Audit {
    extended(system, known, plan, &mut Attempts::default())
}

/// The same with a memory of what tactics made of blocks.
pub(super) fn extended(system: &System, known: &BTreeSet<Symbol>, plan: &Plan, attempts: &mut Attempts) -> Audit {
    let mut determined = known.clone();
    let mut used: BTreeSet<usize> = BTreeSet::new();
    for step in &plan.steps {
        determined.extend(&step.unknowns);
        used.extend(&step.equations);
    }
    let mut extended = plan.clone();
    let mut open = Open::of(system, &determined);
    let mut order: Vec<usize> = (0..system.equations.len()).collect();
    order.sort_by_key(|place| system.equations[*place].cost);
    // An equation with one unknown gives it or does not, whatever else is found.
    let mut tried = used.clone();
    let mut postponed: Vec<Step> = Vec::new();
    loop {
        let mut progress = false;
        for place in &order {
            let [unknown] = *open.without(&determined, *place) else { continue };
            if !tried.insert(*place) {
                continue;
            }
            let block = Block { system, equations: vec![*place], unknowns: vec![unknown] };
            let Ok(step) = isolate(&block, attempts) else { continue };
            if step.roots.len() != 1 {
                continue;
            }
            if divides_by_a_turn(&step) {
                postponed.push(step);
                continue;
            }
            determined.insert(unknown);
            used.insert(*place);
            extended.steps.push(step);
            progress = true;
        }
        if !progress {
            postponed.retain(|step| !step.unknowns.iter().any(|unknown| determined.contains(unknown)));
            // Two at once only where nothing follows alone: an impact of which neither velocity is known.
            let step = (!postponed.is_empty()).then(|| postponed.remove(0));
            let step = step.or_else(|| pair(system, &order, &mut open, &determined, &used, attempts));
            let Some(step) = step else { break };
            determined.extend(&step.unknowns);
            used.extend(&step.equations);
            extended.steps.push(step);
        }
    }
    let mut is_check = |place: &usize| {
        let equal = matches!(system.equations[*place].statement, Statement::Equal { .. });
        equal && !used.contains(place) && open.without(&determined, *place).is_empty()
    };
    let checks = (0..system.equations.len()).filter(|place| is_check(place)).collect();
    Audit { plan: extended, answer_steps: plan.steps.len(), checks }
}

/// Whether a step divides by the sine or cosine of an angle, which may be drawn as zero or as a right angle: another equation gives the
/// same without.
fn divides_by_a_turn(step: &Step) -> bool {
    let values = step.roots.iter().flat_map(|root| &root.values);
    values.into_iter().any(|(_, value)| matches!(value, Closed::Formula(term) if has_a_turn_below(term)))
}

fn has_a_turn_below(term: &Expr) -> bool {
    match term {
        Expr::Power(power) => {
            let (base, exponent) = &**power;
            let divides = exponent.as_number().is_some_and(|exponent| *exponent < Rational::ZERO);
            (divides && has_a_turn(base)) || has_a_turn_below(base)
        }
        other => other.children().any(has_a_turn_below),
    }
}

fn has_a_turn(term: &Expr) -> bool {
    match term {
        Expr::Apply(Function::Sin | Function::Cos | Function::Tan, angle) => {
            angle.iter().any(|angle| !angle.all_symbols(&|_| false))
        }
        other => other.children().any(has_a_turn),
    }
}

/// The symbols of each equation that were not found when it was last looked at.
struct Open(Vec<Vec<Symbol>>);

impl Open {
    fn of(system: &System, known: &BTreeSet<Symbol>) -> Self {
        Self(system.equations.iter().map(|equation| equation.unknowns(known)).collect())
    }

    /// Reduces an equation to what it says beyond the symbols already found, which stay so.
    fn without(&mut self, known: &BTreeSet<Symbol>, equation: usize) -> &[Symbol] {
        let open = &mut self.0[equation];
        open.retain(|symbol| !known.contains(symbol));
        open
    }
}

/// The cheapest two equations that hold the same two open symbols and give both.
fn pair(
    system: &System,
    order: &[usize],
    open: &mut Open,
    known: &BTreeSet<Symbol>,
    used: &BTreeSet<usize>,
    attempts: &mut Attempts,
) -> Option<Step> {
    let mut pairs_of_open: BTreeMap<Vec<Symbol>, Vec<usize>> = BTreeMap::new();
    for place in order.iter().filter(|place| !used.contains(place)) {
        let two = open.without(known, *place);
        if two.len() != 2 {
            continue;
        }
        let others = pairs_of_open.entry(two.to_vec()).or_default();
        let with = |other: &usize| {
            let block = Block { system, equations: vec![*other, *place], unknowns: two.to_vec() };
            let step = close(&block, attempts).ok()?;
            (step.tactic == Tactic::Linear && step.roots.len() == 1).then_some(step)
        };
        if let Some(step) = others.iter().find_map(with) {
            return Some(step);
        }
        others.push(*place);
    }
    None
}
