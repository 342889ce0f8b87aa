//! The omissions of a variant, as a share of what it keeps.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_model::ContactWeight;
use momentous_model::Model;
use momentous_model::Warning;
use momentous_solve::Condition;
use momentous_solve::Planner;

use super::super::compiling::regimes::Leaf;
use super::super::compiling::regimes::Regimes;
use super::variant::Worked;

/// From this share on, what is left out is worth a word: answers may be off by as much.
const WORTH_SAYING: f64 = 0.01;

/// A plan of what weight does in short contacts from what a form tells; none where the form's own plan finds it, or nothing does.
pub(crate) fn weighed(
    planner: &mut Planner,
    model: &Model,
    conditions: &[Condition],
    told: &BTreeSet<Symbol>,
    solver: &Regimes,
    allowed: &[Warning],
) -> Option<Regimes> {
    let terms = model.weights.iter().flat_map(ContactWeight::squares);
    let sought: BTreeSet<Symbol> =
        terms.flat_map(|term| term.symbols()).filter(|symbol| !told.contains(symbol)).collect();
    let solves = |leaf: &Leaf| {
        let steps = &leaf.audit.plan.steps;
        sought.iter().all(|symbol| steps.iter().any(|step| step.unknowns.contains(symbol)))
    };
    if solver.leaves().iter().all(solves) {
        return None;
    }
    let wanted: Vec<Symbol> = sought.iter().copied().collect();
    Regimes::plan(planner, model, &[], conditions, told, &wanted, allowed).ok()
}

impl<'a> Worked<'a> {
    /// The weights that short contacts leave out, each with its impulse as a share of the change of momentum, where that is
    /// worth a word.
    #[must_use]
    pub fn neglected(&self) -> Vec<(&'a ContactWeight, f64)> {
        let weighed = |symbol: Symbol| self.variant.weighed.get(symbol.index()).copied().flatten();
        let value =
            |symbol| self.variant.value(symbol).or_else(|| weighed(symbol)).map_or(f64::NAN, |number| number.value);
        let weights = self.problem.model().weights.iter().filter(|weight| !weight.included);
        let shares = weights.map(|weight| (weight, weight.share(&|term| term.evaluate(&value))));
        shares.filter(|(_, share)| *share >= WORTH_SAYING && share.is_finite()).collect()
    }
}
