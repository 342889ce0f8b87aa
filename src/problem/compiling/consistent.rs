//! Whether fixed values say of each other what the laws say, and determine what is asked: looked at beside the plan, which uses no
//! more of them than it needs.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::QuantityKind;
use momentous_quantity::round_to_figures;
use momentous_solve::Bounded;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Program;
use momentous_solve::Statement;
use momentous_solve::Step;
use momentous_solve::Tactic;
use momentous_solve::Ties;
use momentous_solve::Verify;
use momentous_solve::Workspace;
use momentous_solve::audit;
use momentous_solve::has_enough;
use momentous_solve::is_singular;
use momentous_solve::plan;

use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::sampling::sampler::Sampler;
use super::planned::Form;
use super::planned::Problem;

/// From this share on, a value contradicts the one that follows from the others: what is given may be rounded.
const CONTRADICTS: f64 = 0.01;

/// The figures with which a value that follows is told.
const FIGURES: usize = 4;

/// A fault where the fixed values of a form, for which a solution was just found, contradict each other or leave what is asked open.
pub(super) fn inconsistent(problem: &Problem, form: &Form, sampler: &Sampler<'_>) -> Option<Fault> {
    let ties = Ties::new(&form.solver.leaf(sampler.leaf()).system);
    let redundant = redundant(problem, form, sampler, &ties);
    left_open(problem, form, sampler, &ties, !redundant.is_empty()).or_else(|| {
        redundant.into_iter().find_map(|(known, follows)| {
            let given = sampler.answer(known.symbol)?;
            let apart = |value: &Bounded| (value.value - given.value).abs();
            let nearest = follows.iter().min_by(|one, other| apart(one).total_cmp(&apart(other)))?;
            let allowed = CONTRADICTS * given.value.abs().max(nearest.value.abs()) + given.error + nearest.error;
            (apart(nearest) > allowed).then(|| contradiction(known, [given.value, nearest.value]))
        })
    })
}

/// The fixed values that follow from the others, the last one first, with what follows.
fn redundant<'f>(
    problem: &Problem,
    form: &'f Form,
    sampler: &Sampler<'_>,
    ties: &Ties,
) -> Vec<(&'f Known, Vec<Bounded>)> {
    // What is revealed is rounded, and the givens that it follows from are not: they are no contradiction of the author's.
    if !form.reveal.is_empty() {
        return Vec::new();
    }
    let is_told = |known: &&Known| {
        let is_fixed = matches!(known.origin, Origin::Fixed(_)) && form.told.contains(&known.symbol);
        is_fixed && !matches!(problem.model().name(known.symbol).kind, QuantityKind::Gravity)
    };
    let told = form.known.iter().rev().filter(is_told).filter(|known| ties.fix(known.symbol, &form.told));
    let with_values = told.filter_map(|known| Some((known, following(form, sampler, known.symbol)?)));
    with_values.filter(|(_, follows)| !follows.is_empty()).collect()
}

/// A fault where what is asked was found by equations that hold for any value of it: they tell nothing there, or a given in its place.
fn left_open(problem: &Problem, form: &Form, sampler: &Sampler<'_>, ties: &Ties, has_redundant: bool) -> Option<Fault> {
    let leaf = form.solver.leaf(sampler.leaf());
    let mut asked = form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
    let open = asked.find(|symbol| !form.told.contains(symbol) && ties.leave_open(*symbol, &form.told))?;
    let value = |symbol| sampler.answer(symbol).map_or(f64::NAN, |value| value.value);
    let is_singular = |step: &Step| is_singular(&leaf.system, step, &value);
    // A time of zero leaves every distance open, but for the mean velocity.
    let breaks = |equation: &Equation| {
        let Statement::Equal { left, right } = &equation.statement else { return false };
        let [left, right] = [left, right].map(|side| side.evaluate(&value));
        (left - right).abs() > CONTRADICTS * left.abs().max(right.abs())
    };
    let is_found_falsely = leaf.answer_steps().iter().any(is_singular) || problem.model().distances.iter().any(breaks);
    if !has_redundant && !is_found_falsely {
        return None;
    }
    let name = &problem.model().symbols.entry(open).name;
    let message = format!("the values hold for any `{name}`, and do not determine it");
    let help = "give a quantity that depends on it in place of one that follows from the others";
    Some(Fault::new(Code::UnderDetermined, message).help(help))
}

/// The values of a given that follow from the others; none where no formula gives it.
fn following(form: &Form, sampler: &Sampler<'_>, given: Symbol) -> Option<Vec<Bounded>> {
    let system = &form.solver.leaf(sampler.leaf()).system;
    let others: BTreeSet<Symbol> = form.told.iter().copied().filter(|other| *other != given).collect();
    let formulas = |plan: &Plan| plan.steps.iter().all(|step| step.tactic != Tactic::BracketedRoot);
    let plan = has_enough(system, &others, &[given]).then(|| plan(system, &others, &[given]).ok())?;
    let plan = plan.filter(formulas)?;
    let inputs: Vec<Symbol> = others.into_iter().collect();
    let known: BTreeSet<Symbol> = inputs.iter().copied().collect();
    let audit = audit(system, &known, &plan);
    let program = Program::compile(system, &audit, &inputs, &[given], Verify::Redundant).ok()?;
    let values: Option<Vec<Bounded>> = inputs.iter().map(|symbol| sampler.answer(*symbol)).collect();
    let mut memory = Workspace::default();
    let outcome = program.run(&values?, &mut memory);
    // Where its own equations do not tell it, it is one of the values for which they hold.
    let is_told = |solution: &usize| {
        let value = |symbol| outcome.value_in(*solution, symbol).map_or(f64::NAN, |value| value.value);
        !plan.steps.iter().any(|step| is_singular(system, step, &value))
    };
    let solutions = (0..outcome.survivors()).filter(is_told);
    let solutions = solutions.map(|solution| outcome.value_in(solution, given).copied());
    solutions.collect::<Option<Vec<Bounded>>>().filter(|values| values.iter().all(|value| value.error.is_finite()))
}

fn contradiction(known: &Known, values: [f64; 2]) -> Fault {
    let [given, follows] = values.map(|value| {
        let number = value / known.unit.factor().to_f64();
        let number = round_to_figures(number, FIGURES).map_or_else(|| number.to_string(), |number| number.to_string());
        format!("{number} {}", known.unit).trim_end().to_owned()
    });
    let name = &known.name;
    let message = format!(
        "the values contradict each other: `{name}` is given as {given}, and from the others follows {follows}"
    );
    let help = format!("remove `{name}`, or give the value that follows");
    Fault::new(Code::OverDetermined, message).help(help)
}
