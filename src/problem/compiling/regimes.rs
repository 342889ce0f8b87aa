//! The ways in which a scene can go, each planned and compiled: the one whose conditions hold is taken.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Model;
use momentous_model::Warning;
use momentous_solve::Audit;
use momentous_solve::Bounded;
use momentous_solve::Cause;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Exact;
use momentous_solve::Outcome;
use momentous_solve::Plan;
use momentous_solve::Planner;
use momentous_solve::Precision;
use momentous_solve::Program;
use momentous_solve::Real;
use momentous_solve::Reason;
use momentous_solve::Step;
use momentous_solve::Stuck;
use momentous_solve::System;
use momentous_solve::Tree;
use momentous_solve::TreeWorkspace;
use momentous_solve::Verify;

use super::super::language::domain::Domain;
use super::input::Input;

/// The cost of an equation that is to be taken before others that say the same.
const CHEAP: u32 = 1;

/// One way in which the scene can go.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// The course of events, as clauses: `the crate stays at rest`; empty where there is only one way.
    pub words: Vec<String>,
    /// The equations and conditions of this way.
    pub system: System,
    /// How many of the conditions do not tell this way from the others; they come first.
    pub in_common: usize,
    /// The plan, and what only judging needs.
    pub audit: Audit,
}

/// Why a form has no plan.
#[derive(Clone, Debug)]
pub(crate) enum Unplanned {
    /// In one of the ways in which the scene can go, what is wanted does not follow, or no method finds it.
    Stuck { stuck: Box<Stuck>, system: Box<System>, wanted: Vec<Symbol> },
    /// Its program would need what is not known.
    Unknown(String),
}

/// The plans of a form, one for each way in which the scene can go, and their programs.
#[derive(Clone, Debug)]
pub struct Regimes {
    leaves: Vec<Leaf>,
    tree: Tree,
    inputs: Vec<Symbol>,
}

impl Leaf {
    /// The steps of the answer plan.
    #[must_use]
    pub fn answer_steps(&self) -> &[Step] {
        self.audit.plan.steps.get(..self.audit.answer_steps).unwrap_or(&self.audit.plan.steps)
    }
}

impl Regimes {
    /// Plans how to find what is wanted from what is given, in every way in which the scene can go. A way in which the
    /// question has no answer (when does it start to slide, where it does not) is left out: numbers that lead there are
    /// not drawn.
    pub(crate) fn plan(
        planner: &mut Planner,
        model: &Model,
        equations: &[Equation],
        conditions: &[Condition],
        told: &BTreeSet<Symbol>,
        wanted: &[Symbol],
        allowed: &[Warning],
    ) -> Result<Self, Unplanned> {
        let applies = |condition: &Condition| {
            let warning = model.reasons.get(condition.tag).and_then(momentous_model::Reason::warning);
            warning.is_none_or(|warning| !allowed.contains(&warning))
        };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let mut leaves = Vec::new();
        let mut programs = Vec::new();
        let mut first = None;
        let mut hidden: Vec<(Vec<String>, Unplanned)> = Vec::new();
        let mut systems = model.systems();
        // Where a net force is zero, the time cannot be found from the change of momentum, but from the distance.
        if !model.distances.is_empty() {
            systems.extend(systems.clone().into_iter().map(|(words, mut system)| {
                system
                    .equations
                    .extend(model.distances.iter().map(|equation| Equation { cost: CHEAP, ..equation.clone() }));
                (words, system)
            }));
        }
        for (words, mut system) in systems {
            system.equations.extend(equations.iter().cloned());
            // Those of the way, which tell it from the others, and the author's.
            let mut judging = system.conditions.split_off(model.system.conditions.len());
            let own = judging.clone();
            judging.extend(conditions.iter().cloned());
            judging.retain(applies);
            system.conditions.retain(applies);
            let in_common = system.conditions.len();
            system.conditions.extend(judging.iter().cloned());
            let planned = match planner.plan(&system, told, wanted) {
                Ok(planned) => planned,
                Err(stuck) => {
                    let is_hidden = matches!(stuck.reason, Reason::NoTactic { .. })
                        && !words.is_empty()
                        && !is_told_apart(planner, model, told, &own);
                    let (stuck, system, wanted) = (Box::new(stuck), Box::new(system), wanted.to_vec());
                    let unplanned = Unplanned::Stuck { stuck, system, wanted };
                    if is_hidden {
                        hidden.push((words, unplanned.clone()));
                    }
                    first.get_or_insert(unplanned);
                    continue;
                }
            };
            let uses = |place: &usize| model.distances.iter().any(|equation| is_tagged(&system, *place, equation.tag));
            let by_distance = |plan: &Plan| plan.steps.iter().flat_map(|step| &step.equations).any(uses);
            // A way by the mean velocity that needs none is the same as one of those before it.
            if leaves.iter().any(|leaf: &Leaf| leaf.words == words) && !by_distance(&planned) {
                continue;
            }
            let audit = judged(planner, &system, told, &planned, &judging);
            let program = Program::compile(&system, &audit, &inputs, wanted, Verify::Redundant)
                .map_err(|unknown| Unplanned::Unknown(unknown.to_string()))?;
            programs.push(program);
            leaves.push(Leaf { words, system, in_common, audit });
        }
        if let (true, Some(unplanned)) = (leaves.is_empty(), first) {
            return Err(unplanned);
        }
        // Values may lead to a way that no method solves, and nobody would know.
        let is_left_out = |(words, _): &(Vec<String>, Unplanned)| leaves.iter().all(|leaf| leaf.words != *words);
        if let Some((_, unplanned)) = hidden.into_iter().find(is_left_out) {
            return Err(unplanned);
        }
        Ok(Self { leaves, tree: Tree { leaves: programs }, inputs })
    }

    /// The ways, in the order in which they are tried.
    #[must_use]
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// One of the ways; the first where the position is of another form.
    #[must_use]
    pub fn leaf(&self, position: usize) -> &Leaf {
        // There is always one: a model without choices has one system.
        self.leaves.get(position).unwrap_or(&self.leaves[0])
    }

    /// Whether every condition that tells a way from the others is judged.
    fn is_judged(&self, position: usize) -> bool {
        let in_common = self.leaf(position).in_common;
        self.tree.leaves.get(position).is_some_and(|program| program.unchecked().iter().all(|place| *place < in_common))
    }

    /// The programs.
    #[must_use]
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The inputs of the programs, in order.
    #[must_use]
    pub fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }
}

/// Whether the equation at that place of a system has that tag.
fn is_tagged(system: &System, place: usize, tag: usize) -> bool {
    system.equations.get(place).is_some_and(|equation| equation.tag == tag)
}

/// Whether what tells one way from the others is told, or follows whichever way the scene goes: then what is asked decides nothing.
fn is_told_apart(planner: &mut Planner, model: &Model, told: &BTreeSet<Symbol>, judging: &[Condition]) -> bool {
    let sides = judging.iter().flat_map(|condition| [&condition.left, &condition.right]);
    let open: BTreeSet<Symbol> = sides.flat_map(Expr::symbols).filter(|symbol| !told.contains(symbol)).collect();
    open.is_empty() || planner.plan(&model.system, told, &open.into_iter().collect::<Vec<_>>()).is_ok()
}

/// The audit of a plan, in which whatever those conditions compare is found, too, where it follows: none is passed over.
fn judged(
    planner: &mut Planner,
    system: &System,
    told: &BTreeSet<Symbol>,
    plan: &Plan,
    conditions: &[Condition],
) -> Audit {
    let audit = planner.audit(system, told, plan);
    let unknowns = |plan: &Plan| -> BTreeSet<Symbol> {
        told.iter().copied().chain(plan.steps.iter().flat_map(|step| step.unknowns.iter().copied())).collect()
    };
    let compared = conditions.iter().flat_map(|condition| [&condition.left, &condition.right]).flat_map(Expr::symbols);
    let of_the_scene: BTreeSet<Symbol> = system.equations.iter().flat_map(Equation::symbols).collect();
    let judged = unknowns(&audit.plan);
    let open: BTreeSet<Symbol> =
        compared.filter(|symbol| of_the_scene.contains(symbol) && !judged.contains(symbol)).collect();
    let mut whole = plan.clone();
    for symbol in open {
        let known = unknowns(&whole);
        if !known.contains(&symbol)
            && let Ok(further) = planner.plan(system, &known, &[symbol])
        {
            whole.steps.extend(further.steps);
        }
    }
    if whole.steps.len() == plan.steps.len() {
        return audit;
    }
    Audit { answer_steps: audit.answer_steps, ..planner.audit(system, told, &whole) }
}

/// The memory of solving: kept between variants, so that a replay allocates little.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    workspace: TreeWorkspace,
    inputs: Vec<Bounded>,
    taken: Option<usize>,
}

impl Scratch {
    /// Memory for replays of that precision.
    pub(crate) fn new(precision: Precision) -> Self {
        Self { workspace: TreeWorkspace::new(precision), ..Self::default() }
    }

    /// Solves from the inputs; gives the number of admissible solutions.
    pub(crate) fn run(&mut self, regimes: &Regimes, inputs: &[Input], domains: &[Option<Domain>]) -> usize {
        if !self.take(regimes, |symbol| inputs.get(symbol.index()).and_then(Input::bounded)) {
            return 0;
        }
        let exact = || exact(regimes, inputs, domains);
        self.taken = regimes.tree.solve_from(&self.inputs, &exact, &mut self.workspace);
        self.survivors(regimes)
    }

    /// The ways behind the one that was taken in which the scene could go as well, from the same inputs: whatever tells each from the
    /// others is judged.
    pub(crate) fn others(&mut self, regimes: &Regimes, inputs: &[Input], domains: &[Option<Domain>]) -> Vec<usize> {
        let Some(taken) = self.taken.filter(|taken| taken + 1 < regimes.leaves.len()) else { return Vec::new() };
        let exact = || exact(regimes, inputs, domains);
        let mut others = regimes.tree.solve_others(taken, &self.inputs, &exact, &mut self.workspace);
        others.retain(|other| regimes.is_judged(*other));
        others
    }

    /// Looks at another of the ways that were solved; gives the one that was taken.
    pub(crate) fn turn_to(&mut self, leaf: usize) -> usize {
        self.taken.replace(leaf).unwrap_or(leaf)
    }

    /// The same for a limiting case, in which conditions may hold with nothing to spare, in floating point alone.
    pub(crate) fn run_limit(&mut self, regimes: &Regimes, input: impl Fn(&Symbol) -> Option<Bounded>) -> usize {
        if !self.take(regimes, input) {
            return 0;
        }
        self.taken = regimes.tree.solve_limit(&self.inputs, &mut self.workspace);
        self.survivors(regimes)
    }

    /// Takes the inputs of the programs; whether all are there.
    fn take(&mut self, regimes: &Regimes, input: impl Fn(&Symbol) -> Option<Bounded>) -> bool {
        self.inputs.clear();
        self.inputs.extend(regimes.inputs.iter().map_while(input));
        self.inputs.len() == regimes.inputs.len()
    }

    fn outcome<'a>(&'a self, regimes: &'a Regimes) -> Option<Outcome<'a, Bounded>> {
        regimes.tree.outcome(self.taken?, &self.workspace)
    }

    /// The number of solutions that the last run found.
    pub(crate) fn survivors(&self, regimes: &Regimes) -> usize {
        self.outcome(regimes).map_or(0, |outcome| outcome.survivors())
    }

    /// A solved quantity in SI units, with a bound on its error.
    pub(crate) fn value(&self, regimes: &Regimes, symbol: Symbol) -> Option<Bounded> {
        self.value_in(regimes, 0, symbol)
    }

    /// A quantity in the solution at that position.
    pub(crate) fn value_in(&self, regimes: &Regimes, position: usize, symbol: Symbol) -> Option<Bounded> {
        self.outcome(regimes)?.value_in(position, symbol).copied().filter(Real::is_real)
    }

    /// Rules out the solutions that have a reason, unless all have one.
    pub(crate) fn rule_out(&mut self, regimes: &Regimes, reasons: &[Option<usize>]) {
        if let Some(taken) = self.taken {
            regimes.tree.rule_out(taken, reasons, &mut self.workspace);
        }
    }

    /// All quantities, by symbol, in SI units; `count` symbols in all.
    pub(crate) fn values(&self, regimes: &Regimes, count: usize) -> Vec<Option<Bounded>> {
        let mut values = vec![None; count];
        let Some(outcome) = self.outcome(regimes) else { return values };
        for (symbol, value) in outcome.values() {
            if let Some(place) = values.get_mut(symbol.index()) {
                *place = Some(*value).filter(Real::is_real);
            }
        }
        values
    }

    /// A quantity in each further solution.
    pub(crate) fn other_values(&self, regimes: &Regimes, symbol: Symbol) -> Vec<Bounded> {
        let outcome = self.outcome(regimes);
        outcome.map(|outcome| outcome.other_values(symbol).copied().collect()).unwrap_or_default()
    }

    /// The way that the scene goes.
    pub(crate) fn leaf(&self) -> usize {
        self.taken.unwrap_or(0)
    }

    /// The root taken in each step.
    pub(crate) fn roots(&self, regimes: &Regimes) -> Vec<usize> {
        self.outcome(regimes).map(|outcome| outcome.choices().to_vec()).unwrap_or_default()
    }

    /// The roots that are not solutions.
    pub(crate) fn dead(&self, regimes: &Regimes) -> Vec<Dead> {
        self.dead_of(regimes, self.leaf())
    }

    /// The roots that are not solutions in one of the ways that were tried.
    pub(crate) fn dead_of(&self, regimes: &Regimes, leaf: usize) -> Vec<Dead> {
        let Some(outcome) = regimes.tree.outcome(leaf, &self.workspace) else { return Vec::new() };
        let dead = outcome.dead().iter().map(|death| Dead {
            step: death.step,
            cause: death.cause,
            values: outcome.values_at_death(death).to_vec(),
        });
        dead.collect()
    }
}

/// The inputs without rounding: every one has a value, so none is left out.
fn exact(regimes: &Regimes, inputs: &[Input], domains: &[Option<Domain>]) -> Vec<Exact> {
    let input = |symbol: &Symbol| {
        let domain = domains.get(symbol.index()).and_then(Option::as_ref);
        inputs.get(symbol.index()).and_then(|input| input.exact(domain))
    };
    regimes.inputs.iter().filter_map(input).collect()
}

/// A root that is not a solution.
#[derive(Clone, Debug)]
pub struct Dead {
    /// The step of the plan; none where the givens themselves break a condition.
    pub step: Option<usize>,
    /// The cause of its failure.
    pub cause: Cause,
    /// The values of the step's unknowns, in the step's order.
    pub values: Vec<Bounded>,
}
