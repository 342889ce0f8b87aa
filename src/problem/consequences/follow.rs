//! Consequences of a student's own earlier answers: the same equations with these values taken as known. Where they were solved
//! together with others, the system then says too much, so each equation of the block is left aside in turn.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_laws::Law;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_model::Model;
use momentous_model::Reason;
use momentous_model::Warning;
use momentous_solve::Bounded;
use momentous_solve::Cause;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Program;
use momentous_solve::Relation;
use momentous_solve::Statement;
use momentous_solve::System;
use momentous_solve::Verify;
use momentous_solve::Workspace;
use momentous_solve::audit;
use momentous_solve::plan;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Leaf;
use super::super::sampling::variant::Worked;
use super::following::Following;
use super::restricted::Restricted;
use super::solver::Solver;

/// At most so many ways of leaving equations aside are tried for one set of earlier answers.
const MOST_WAYS: usize = 64;
/// Energy created up to this share of what was there may come of rounding.
const ROUNDING: (i64, u32) = (102, 100);
/// Velocities that differ by no more than this share may be the same, as they are rounded.
const ROUNDED: (i64, u32) = (6, 1000);
/// A formula and a program give the same within this share.
const SAME: f64 = 1e-9;
/// Roots are told apart where they differ by more than this share: a wrong answer is rounded.
const ROOT: f64 = 0.006;

/// A consequence of earlier answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Consequence {
    /// The value, in SI units.
    pub value: f64,
    /// The laws by which it follows.
    pub by: Vec<&'static Law>,
    /// The impossibility in it, as a clause.
    pub unphysical: Option<String>,
}

/// A consequence of earlier answers, before anybody has said whether it is wanted.
pub struct Candidate<'a> {
    /// The value, in SI units.
    pub value: f64,
    asked: Symbol,
    worked: Worked<'a>,
    way: &'a Following,
    input: &'a dyn Fn(Symbol) -> Option<Bounded>,
}

impl Candidate<'_> {
    /// Whether something that comes before an earlier answer is found from it: a step before it is taken to be wrong.
    #[must_use]
    pub fn is_backwards(&self) -> bool {
        self.way.backwards
    }

    /// The formulas, in what is given and the earlier quantities, that have this value.
    #[must_use]
    pub fn formulas(&self) -> Vec<Expr> {
        let value = |symbol: Symbol| (self.input)(symbol).map_or(f64::NAN, |number| number.value);
        let mut formulas = self.worked.every_formula(&self.way.solver.plan, self.asked);
        formulas.retain(|formula| (formula.evaluate(&value) - self.value).abs() <= SAME * self.value.abs());
        formulas
    }
}

impl Worked<'_> {
    /// The values of a quantity that follow from answers to earlier ones, each in SI units, as far as `accept` wants them. The
    /// plans are made when this is first asked.
    #[must_use]
    pub fn following(
        &self,
        asked: Symbol,
        earlier: &BTreeMap<Symbol, f64>,
        accept: &mut dyn FnMut(&Candidate<'_>) -> bool,
    ) -> Vec<Consequence> {
        let from: BTreeSet<Symbol> = earlier.keys().copied().collect();
        let key = (self.variant.leaf(), asked, from);
        let known = self.form.followings.0.read().ok().and_then(|known| known.get(&key).cloned());
        let ways = known.unwrap_or_else(|| {
            let ways: Arc<[Following]> = planned(self.problem, self.form, self.leaf(), asked, &key.2).into();
            if let Ok(mut known) = self.form.followings.0.write() {
                known.insert(key, Arc::clone(&ways));
            }
            ways
        });
        let input = |symbol: Symbol| match earlier.get(&symbol) {
            Some(value) => Some(Bounded { value: *value, error: 0.0 }),
            None => self.variant.value(symbol),
        };
        let mut consequences = Vec::new();
        for way in ways.iter() {
            for value in self.consistent(&way.solver, asked, &input) {
                let candidate = Candidate { value, asked, worked: *self, way, input: &input };
                // A zero, or nothing at all, makes the question trivial: nobody is given marks for it.
                if value != 0.0 && value.is_finite() && accept(&candidate) {
                    let unphysical = way.unphysical(&input);
                    consequences.push(Consequence { value, by: way.by.clone(), unphysical });
                }
            }
        }
        consequences
    }

    /// The values by a solver. Of several roots only one that is possible follows, and only one that the right values do not have
    /// as well: a square hides a wrong sign.
    fn consistent(&self, solver: &Solver, asked: Symbol, input: &dyn Fn(Symbol) -> Option<Bounded>) -> Vec<f64> {
        let mut values = Vec::new();
        if !solver.chooses() {
            solver.values(asked, input, &mut |value| values.push(value));
            return values;
        }
        let mut roots = Vec::new();
        solver.roots(asked, &|symbol| self.variant.value(symbol), &mut |value| roots.push(value));
        solver.possible(asked, input, &mut |value| values.push(value));
        values.retain(|value| roots.iter().all(|root| (root - value).abs() > ROOT * value.abs()));
        values
    }
}

impl Following {
    /// The impossibility in the values, as a clause.
    fn unphysical(&self, input: &dyn Fn(Symbol) -> Option<Bounded>) -> Option<String> {
        let (program, reasons) = self.judge.as_ref()?;
        let inputs: Vec<Bounded> = self.solver.inputs().iter().map(|symbol| input(*symbol)).collect::<Option<_>>()?;
        let mut memory = Workspace::default();
        let outcome = program.run(&inputs, &mut memory);
        if outcome.survivors() > 0 {
            return None;
        }
        outcome.dead().iter().find_map(|death| match death.cause {
            Cause::Condition(place) => reasons.get(place).map(Reason::to_string),
            _ => None,
        })
    }
}

fn planned(problem: &Problem, form: &Form, leaf: &Leaf, asked: Symbol, from: &BTreeSet<Symbol>) -> Vec<Following> {
    let used: BTreeSet<usize> = leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
    let known: BTreeSet<Symbol> = form.told.union(from).copied().collect();
    let finding = leaf.answer_steps().iter().filter(|step| step.unknowns.iter().any(|symbol| from.contains(symbol)));
    let finding_equations: BTreeSet<usize> = finding.flat_map(|step| step.equations.iter().copied()).collect();
    let mut ways: Vec<(Vec<usize>, Following)> = Vec::new();
    for aside in left_aside(problem.model(), leaf, from).into_iter().take(MOST_WAYS) {
        let kept = Restricted::new(&leaf.system, used.difference(&aside).copied());
        let Ok(plan_kept) = plan(&kept.system, &known, &[asked]) else { continue };
        let mut equations: Vec<usize> =
            plan_kept.steps.iter().flat_map(|step| step.equations.iter().copied()).collect();
        equations.sort_unstable();
        let symbols: BTreeSet<Symbol> = equations
            .iter()
            .filter_map(|equation| kept.system.equations.get(*equation))
            .flat_map(Equation::symbols)
            .collect();
        let places: Vec<usize> = equations.iter().filter_map(|equation| kept.places.get(*equation).copied()).collect();
        // What does not need all of the earlier answers follows from fewer of them.
        if !from.is_subset(&symbols) || ways.iter().any(|(listed, _)| *listed == places) {
            continue;
        }
        let Some(solver) = Solver::new(&Restricted::new(&leaf.system, places.clone()).system, &known, &[asked]) else {
            continue;
        };
        let by = laws(problem.model(), &leaf.system, &places, from);
        let judge = judge(problem.model(), leaf, &kept, &aside, plan_kept, &known);
        let backwards = !aside.is_subset(&finding_equations);
        ways.push((places, Following { by, backwards, solver, judge }));
    }
    ways.into_iter().map(|(_, way)| way).collect()
}

/// The sets of equations that can be left aside so that what remains says no more than it must: one for each earlier answer,
/// of the block that found it first, then of the blocks before that.
fn left_aside(model: &Model, leaf: &Leaf, from: &BTreeSet<Symbol>) -> Vec<BTreeSet<usize>> {
    let mut sets: Vec<BTreeSet<usize>> = vec![BTreeSet::new()];
    for symbol in from {
        let candidates = determining(model, leaf, *symbol);
        let larger = sets.iter().flat_map(|set| {
            let fresh = candidates.iter().filter(|equation| !set.contains(equation));
            fresh
                .map(|equation| set.iter().copied().chain([*equation]).collect::<BTreeSet<usize>>())
                .collect::<Vec<_>>()
        });
        sets = larger.collect();
        let mut kept = BTreeSet::new();
        sets.retain(|set| kept.insert(set.clone()));
        sets.truncate(4 * MOST_WAYS);
    }
    sets
}

/// The equations on which a quantity depends, those of its own block first. That a weight is told in place of a mass is no step that a
/// student may have got wrong in one place and right in another.
fn determining(model: &Model, leaf: &Leaf, symbol: Symbol) -> Vec<usize> {
    let mut wanted = BTreeSet::from([symbol]);
    let mut places = Vec::new();
    for step in leaf.answer_steps().iter().rev() {
        if !step.unknowns.iter().any(|unknown| wanted.contains(unknown)) {
            continue;
        }
        places.extend(step.equations.iter().filter(|place| !is_weight(model, leaf, **place)));
        let equations = step.equations.iter().filter_map(|place| leaf.system.equations.get(*place));
        wanted.extend(equations.flat_map(Equation::symbols));
    }
    places
}

fn is_weight(model: &Model, leaf: &Leaf, place: usize) -> bool {
    let equation = leaf.system.equations.get(place);
    let instance = equation.and_then(|equation| model.instances.get(equation.tag));
    instance.is_some_and(|instance| *instance.law == force::WEIGHT)
}

/// The laws in which an earlier answer stands, under its own name or under another; where it only gets another name, that law.
fn laws(model: &Model, system: &System, places: &[usize], from: &BTreeSet<Symbol>) -> Vec<&'static Law> {
    let equations = || places.iter().filter_map(|place| system.equations.get(*place));
    let mut meant = from.clone();
    let names: Vec<&Equation> = equations().filter(|equation| is_name(equation)).collect();
    for equation in names.iter().filter(|equation| !equation.symbols().is_disjoint(from)) {
        meant.extend(equation.symbols());
    }
    let mut stating: Vec<&Equation> =
        equations().filter(|equation| !is_name(equation) && !equation.symbols().is_disjoint(&meant)).collect();
    if stating.is_empty() {
        stating = names;
    }
    let mut laws: Vec<&'static Law> = Vec::new();
    for equation in stating {
        let law = model.instances.get(equation.tag).map(|instance| instance.law);
        laws.extend(law.filter(|law| !laws.contains(law)));
    }
    laws
}

/// Whether an equation says no more than that two quantities are the same.
fn is_name(equation: &Equation) -> bool {
    matches!(&equation.statement, Statement::Equal { left: Expr::Symbol(_), right: Expr::Symbol(_) })
}

/// The program that solves the rest of the scene from the same values and judges it.
fn judge(
    model: &Model,
    leaf: &Leaf,
    kept: &Restricted,
    aside: &BTreeSet<usize>,
    mut plan: Plan,
    known: &BTreeSet<Symbol>,
) -> Option<(Program, Vec<Reason>)> {
    // What was left aside is not true of the student's values: the rest of the scene does not follow from it.
    let rest =
        Restricted::new(&leaf.system, (0..leaf.system.equations.len()).filter(|equation| !aside.contains(equation)));
    for step in &mut plan.steps {
        let place = |equation: &usize| rest.places.binary_search(kept.places.get(*equation)?).ok();
        step.equations = step.equations.iter().filter_map(place).collect();
        step.moves.clear();
    }
    let mut system = rest.system;
    let judged = leaf.system.conditions.iter().filter_map(|condition| {
        let reason = model.reasons.get(condition.tag)?;
        let warning = reason.warning()?;
        let serves = matches!(warning, Warning::PassesThrough | Warning::EnergyCreated | Warning::NoImpact);
        let mut condition = condition.clone();
        if warning == Warning::PassesThrough && condition.relation == Relation::AtLeast {
            // Velocities that are equal as they are rounded do not pass through.
            let size = |side: &Expr| Expr::apply(Function::Abs, side.clone());
            let sizes = size(&condition.left) + size(&condition.right);
            condition.left = condition.left + Expr::ratio(ROUNDED.0, ROUNDED.1) * sizes;
        }
        serves.then(|| (condition, reason.clone()))
    });
    let lost = leaf.system.equations.iter().filter_map(|equation| {
        let law = model.instances.get(equation.tag)?.law;
        let Statement::Equal { right: momentous_expr::Expr::Sum(energies), .. } = &equation.statement else {
            return None;
        };
        let (before, after) = (energies.first()?.clone(), -energies.get(1)?.clone());
        let left = momentous_expr::Expr::ratio(ROUNDING.0, ROUNDING.1) * before;
        let condition = Condition { left, relation: Relation::AtLeast, right: after, tag: equation.tag };
        (*law == energy::LOSS).then_some((condition, Reason::CreatesEnergy))
    });
    let reasons;
    (system.conditions, reasons) = judged.chain(lost).unzip();
    system.positive.clear();
    let mut whole = audit(&system, known, &plan);
    whole.checks.clear();
    let inputs: Vec<Symbol> = known.iter().copied().collect();
    let program = Program::compile(&system, &whole, &inputs, &[], Verify::Redundant).ok()?;
    Some((program, reasons))
}
