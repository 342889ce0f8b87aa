//! Quantities that the arrows of a stage of one body need and its solution does not: a mass that cancels, and the time in which
//! forces that do not change make the momentum what it is. It is solved from the equations of the solution.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::ActingForce;
use momentous_solve::Closed;
use momentous_solve::plan;

use super::diagram_plan::Besides;
use super::quantities::Quantities;

impl Besides {
    /// The quantities that the arrows of that body need in a stage.
    pub(super) fn of(quantities: &Quantities<'_>, stage: usize, body: &str) -> Self {
        let mass = quantities.mass_symbol(body, stage + 1).filter(|_| quantities.mass(body, stage + 1).is_none());
        let assumed = mass.map_or_else(|| quantities.clone(), |mass| quantities.assuming(mass, 1.0));
        let mut forces = assumed.model().forces.iter().filter(|force| force.stage == stage && force.on == body);
        let end = forces.next().map(|ActingForce { during: [_, end], .. }| end);
        let formulas = match end {
            Some(Expr::Symbol(time)) if assumed.evaluate(&(*time).into()).is_none() => solved(&assumed, mass, *time),
            _ => Vec::new(),
        };
        Self { mass, formulas }
    }

    /// The quantities of a variant with these.
    pub(super) fn added_to<'a>(&self, quantities: &Quantities<'a>) -> Quantities<'a> {
        let assumed = self.mass.map_or_else(|| quantities.clone(), |mass| quantities.assuming(mass, 1.0));
        self.formulas.iter().fold(assumed, |assumed, (symbol, formula)| match assumed.evaluate(formula) {
            Some(value) => assumed.assuming(*symbol, value),
            None => assumed,
        })
    }
}

/// How a time follows from what the solution has found.
fn solved(quantities: &Quantities<'_>, mass: Option<Symbol>, time: Symbol) -> Vec<(Symbol, Expr)> {
    let worked = quantities.worked;
    let symbols = worked.problem.model().symbols.iter().map(|(symbol, _)| symbol);
    let known: BTreeSet<Symbol> =
        symbols.filter(|symbol| worked.variant.value(*symbol).is_some()).chain(mass).collect();
    let Ok(plan) = plan(&worked.leaf().system, &known, &[time]) else { return Vec::new() };
    let roots = plan.steps.iter().filter_map(|step| step.roots.first());
    let formulas = roots.flat_map(|root| &root.values).filter_map(|(symbol, closed)| match closed {
        Closed::Formula(formula) => Some((*symbol, formula.clone())),
        _ => None,
    });
    formulas.collect()
}
