//! Whether values say of each other what the laws say, and determine what is asked: looked at beside the plan, which uses no
//! more of them than it needs.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
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
use momentous_solve::System;
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

/// The figures with which a value that follows is told, and the most where it is near the one that is given.
const FIGURES: usize = 4;
const MOST_FIGURES: usize = 15;

/// A fault where the values of a form, for which a solution was just found, contradict each other or leave what is asked open.
pub(super) fn inconsistent(problem: &Problem, form: &Form, sampler: &Sampler<'_>) -> Option<Fault> {
    unlike(problem, form, sampler, &Ties::new(&form.solver.leaf(sampler.leaf()).system))
}

impl Problem {
    /// The first of so many seeds of a form whose drawn values contradict each other off the way to the answers, and how.
    #[must_use]
    pub fn contradicted(&self, position: usize, seeds: u64) -> Option<(u64, String)> {
        let form = self.forms().get(position)?;
        let mut sampler = Sampler::new(self, position).ok()?;
        let may_differ = |leaf: usize| {
            let ties = Ties::new(&form.solver.leaf(leaf).system);
            let is_open = asked(form).any(|symbol| ties.leave_open(symbol, &form.told));
            (is_open || !redundant(self, form, &ties).is_empty()).then_some(ties)
        };
        let mut ways: BTreeMap<usize, Option<Ties>> = BTreeMap::new();
        (1..=seeds).find_map(|seed| {
            sampler.draw(seed).ok()?;
            let leaf = sampler.leaf();
            let ties = ways.entry(leaf).or_insert_with(|| may_differ(leaf)).as_ref()?;
            unlike(self, form, &sampler, ties).map(|fault| (seed, fault.message))
        })
    }
}

fn unlike(problem: &Problem, form: &Form, sampler: &Sampler<'_>, ties: &Ties) -> Option<Fault> {
    let redundant = redundant(problem, form, ties);
    let follows = |known: &&Known| following(form, sampler, known.symbol).is_some_and(|values| !values.is_empty());
    let has_redundant = || redundant.iter().any(follows);
    left_open(problem, form, sampler, ties, &has_redundant).or_else(|| {
        redundant.iter().find_map(|known| {
            let Differing { values, help } = differing(form, sampler, known, CONTRADICTS)?;
            let message = format!("the values contradict each other: {values}");
            Some(Fault::new(Code::OverDetermined, message).help(help))
        })
    })
}

/// The fixed value of a form that does not follow from the others, where one that lies on the way to the answers contradicts them,
/// however little.
pub(super) fn told_otherwise(problem: &Problem, form: &Form, sampler: &Sampler<'_>) -> Option<Differing> {
    let ties = Ties::new(&form.solver.leaf(sampler.leaf()).system);
    redundant(problem, form, &ties).into_iter().find_map(|known| differing(form, sampler, known, 0.0))
}

/// A value that differs from the one that follows from the others by more than a share of it.
fn differing(form: &Form, sampler: &Sampler<'_>, known: &Known, share: f64) -> Option<Differing> {
    let follows = following(form, sampler, known.symbol)?;
    let given = sampler.answer(known.symbol)?;
    let apart = |value: &Bounded| (value.value - given.value).abs();
    let nearest = follows.iter().min_by(|one, other| apart(one).total_cmp(&apart(other)))?;
    let size = given.value.abs().max(nearest.value.abs());
    let allowed = share * size + given.error + nearest.error;
    let is_near = apart(nearest) <= CONTRADICTS * size;
    (apart(nearest) > allowed).then(|| Differing::new(known, [given.value, nearest.value], is_near))
}

/// The values that follow from the others, the last one first.
fn redundant<'f>(problem: &Problem, form: &'f Form, ties: &Ties) -> Vec<&'f Known> {
    // What is revealed is rounded, and the givens that it follows from are not: they are no contradiction of the author's.
    if !form.reveal.is_empty() {
        return Vec::new();
    }
    let is_told = |known: &&Known| {
        let has_value = !matches!(known.origin, Origin::Any) && form.told.contains(&known.symbol);
        has_value && !matches!(problem.model().name(known.symbol).kind, QuantityKind::Gravity)
    };
    form.known.iter().rev().filter(is_told).filter(|known| ties.fix(known.symbol, &form.told)).collect()
}

/// The quantities that are asked and not told.
fn asked(form: &Form) -> impl Iterator<Item = Symbol> {
    let asked = form.parts.iter().flat_map(|part| part.kind.numbers()).map(|number| number.symbol);
    asked.filter(|symbol| !form.told.contains(symbol))
}

/// A fault where what is asked was found by equations that hold for any value of it: they tell nothing there, or a given in its place.
fn left_open(
    problem: &Problem,
    form: &Form,
    sampler: &Sampler<'_>,
    ties: &Ties,
    has_redundant: &dyn Fn() -> bool,
) -> Option<Fault> {
    let leaf = form.solver.leaf(sampler.leaf());
    let open = asked(form).find(|symbol| ties.leave_open(*symbol, &form.told))?;
    let value = |symbol| sampler.answer(symbol).map_or(f64::NAN, |value| value.value);
    let is_singular = |step: &Step| is_singular(&leaf.system, step, &value);
    // A time of zero leaves every distance open, but for the mean velocity.
    let breaks = |equation: &Equation| {
        let Statement::Equal { left, right } = &equation.statement else { return false };
        let [left, right] = [left, right].map(|side| side.evaluate(&value));
        (left - right).abs() > CONTRADICTS * left.abs().max(right.abs())
    };
    let is_found_falsely = leaf.answer_steps().iter().any(is_singular) || problem.model().distances.iter().any(breaks);
    if !is_found_falsely && !has_redundant() || is_fixed_there(form, &leaf.system, open) {
        return None;
    }
    let name = &problem.model().symbols.entry(open).name;
    let message = format!("the values hold for any `{name}`, and do not determine it");
    let help = "give a quantity that depends on it in place of one that follows from the others";
    Some(Fault::new(Code::UnderDetermined, message).help(help))
}

/// Whether a quantity has no freedom left where the fixed values are what they are: at other values it may have some.
fn is_fixed_there(form: &Form, system: &System, symbol: Symbol) -> bool {
    let told = form.known.iter().filter(|known| form.told.contains(&known.symbol));
    let fixed = told.filter_map(|known| match &known.origin {
        Origin::Fixed(value) => Some((known.symbol, Expr::measured(value, &known.unit))),
        Origin::Drawn(_) | Origin::Any => None,
    });
    Ties::new(&System { fixed: fixed.collect(), ..system.clone() }).fix(symbol, &form.told)
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

/// A value that is given otherwise than it follows from the others.
pub(super) struct Differing {
    /// Both values, as a clause.
    pub values: String,
    /// The way out.
    pub help: String,
}

impl Differing {
    fn new(known: &Known, values: [f64; 2], is_near: bool) -> Self {
        let written = |figures: usize| {
            values.map(|value| {
                let number = value / known.unit.factor().to_f64();
                let number =
                    round_to_figures(number, figures).map_or_else(|| number.to_string(), |number| number.to_string());
                format!("{number} {}", known.unit).trim_end().to_owned()
            })
        };
        let apart = (FIGURES..MOST_FIGURES).map(&written).find(|[given, follows]| given != follows);
        let [given, follows] = apart.unwrap_or_else(|| written(MOST_FIGURES));
        let name = &known.name;
        let values = format!("`{name}` is given as {given}, and from the others follows {follows}");
        let help = if is_near {
            format!("remove `{name}`: the answer is found from it as well as from the others, which must agree exactly")
        } else {
            format!("remove `{name}`, or give the value that follows")
        };
        Self { values, help }
    }
}
