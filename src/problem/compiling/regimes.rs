//! The ways in which a scene can go, each planned and compiled: the one whose conditions hold is taken.

use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Model;
use momentous_model::QuantityKind;
use momentous_model::Warning;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_solve::Audit;
use momentous_solve::Bounded;
use momentous_solve::Cause;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Outcome;
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

/// One way in which the scene can go.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// What happens, as clauses: `the crate stays at rest`; empty where there is only one way.
    pub words: Vec<String>,
    /// The equations and conditions of this way.
    pub system: System,
    /// The plan, and what only judging needs.
    pub audit: Audit,
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
    ) -> Result<Self, Fault> {
        let applies = |condition: &Condition| {
            let warning = model.reasons.get(condition.tag).and_then(momentous_model::Reason::warning);
            warning.is_none_or(|warning| !allowed.contains(&warning))
        };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let mut leaves = Vec::new();
        let mut programs = Vec::new();
        let mut stuck_at = None;
        for (words, mut system) in model.systems() {
            system.equations.extend(equations.iter().cloned());
            system.conditions.extend(conditions.iter().cloned());
            system.conditions.retain(applies);
            let planned = match planner.plan(&system, told, wanted) {
                Ok(planned) => planned,
                Err(stuck) => {
                    stuck_at.get_or_insert_with(|| {
                        let is_fixed = stuck.remaining.iter().all(|own| planner.is_fixed(&system, told, *own));
                        let ways = match open_scale(planner, &system, &stuck, wanted) {
                            Some(open) => Ways { instead: Vec::new(), is_fixed, open: Some(open) },
                            None => {
                                let instead = ways_out(planner, model, &system, &stuck, wanted);
                                Ways { instead, is_fixed, open: None }
                            }
                        };
                        fault(model, &system, &stuck, &ways)
                    });
                    continue;
                }
            };
            let audit = planner.audit(&system, told, &planned);
            let program = Program::compile(&system, &audit, &inputs, wanted, Verify::Redundant)
                .map_err(|unknown| Fault::new(Code::Stuck, unknown.to_string()))?;
            programs.push(program);
            leaves.push(Leaf { words, system, audit });
        }
        if let (true, Some(fault)) = (leaves.is_empty(), stuck_at) {
            return Err(fault);
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

    /// The programs.
    #[must_use]
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// What the programs take, in order.
    #[must_use]
    pub fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }
}

/// The most ways out that a message names: each costs a plan.
const MOST_WAYS: usize = 4;

/// What an author may do where a form cannot be solved.
struct Ways {
    /// Quantities to be told, each in place of a given.
    instead: Vec<(Symbol, Symbol)>,
    /// Whether what is asked is fixed as it is, so that the values of further quantities do not matter.
    is_fixed: bool,
    /// A quantity that is open, and on which what is asked does not depend: the size of an orbit of which only the shape is told.
    open: Option<Symbol>,
}

/// Where no tactic closes some equations: a quantity that they leave open, with which the rest is found.
fn open_scale(planner: &mut Planner, system: &System, stuck: &Stuck, wanted: &[Symbol]) -> Option<Symbol> {
    let Reason::NoTactic { equations, unknowns } = &stuck.reason else { return None };
    // These equations alone: others, such as that of the time along an orbit, have no derivative at its ends.
    let block = equations.iter().filter_map(|position| system.equations.get(*position)).cloned().collect();
    let block = system.with(block);
    let is_fixed = |planner: &Planner, symbol: &Symbol| planner.is_fixed(&block, &stuck.known, *symbol);
    if !unknowns.iter().filter(|symbol| wanted.contains(symbol)).all(|symbol| is_fixed(planner, symbol)) {
        return None;
    }
    let lets_find = |symbol: &&Symbol| {
        let known: BTreeSet<Symbol> = stuck.known.iter().copied().chain([**symbol]).collect();
        let is_open = !wanted.contains(symbol) && !is_fixed(planner, symbol);
        is_open && planner.plan(system, &known, wanted).is_ok()
    };
    unknowns.iter().rev().find(lets_find).copied()
}

/// Where no tactic closes some equations: quantities that let the rest be found, each with a given whose place it has to take.
fn ways_out(
    planner: &mut Planner,
    model: &Model,
    system: &System,
    stuck: &Stuck,
    wanted: &[Symbol],
) -> Vec<(Symbol, Symbol)> {
    let Reason::NoTactic { equations, unknowns } = &stuck.reason else { return Vec::new() };
    let within = equations.iter().filter_map(|position| system.equations.get(*position)).flat_map(Equation::symbols);
    let can_be_left_out = |symbol: &Symbol| {
        let is_number = model.literals.iter().any(|(own, _)| own == symbol);
        stuck.known.contains(symbol) && !is_number && model.name(*symbol).kind != QuantityKind::Gravity
    };
    let givens: BTreeSet<Symbol> = within.filter(can_be_left_out).collect();
    let replaced = |symbol: &Symbol| {
        // What is told of masses mostly stays: later symbols are those of the motion.
        let mut givens = givens.iter().rev().copied();
        let given = givens.find(|given| {
            let known = stuck.known.iter().copied().filter(|own| own != given).chain([*symbol]).collect();
            planner.plan(system, &known, wanted).is_ok()
        })?;
        Some((*symbol, given))
    };
    unknowns.iter().filter(|symbol| !wanted.contains(symbol)).filter_map(replaced).take(MOST_WAYS).collect()
}

/// The question whether a given was meant by a missing quantity whose name differs from it in capitals only; empty where none is.
fn other_case(model: &Model, stuck: &Stuck, enough: &[Vec<Symbol>]) -> String {
    let name = |symbol: &Symbol| model.symbols.entry(*symbol).name.as_str();
    let alike = |missing: &Symbol| {
        let mut given = stuck.known.iter().map(name);
        let given = given.find(|given| given.eq_ignore_ascii_case(name(missing)) && *given != name(missing))?;
        Some(format!("; did you mean `{given}` by `{}`? Capitals count", name(missing)))
    };
    enough.iter().flatten().find_map(alike).unwrap_or_default()
}

/// Why a form cannot be solved, in the author's terms.
fn fault(model: &Model, system: &System, stuck: &Stuck, own: &Ways) -> Fault {
    let any = |symbol: &Symbol| {
        let unit = coherent_unit(model.symbols.entry(*symbol).dimension, UnitSystem::Si);
        format!("`{}: any {unit}`", model.symbols.entry(*symbol).name)
    };
    let name = |symbol: &Symbol| format!("`{}`", model.symbols.entry(*symbol).name);
    let names = |symbols: &[Symbol]| symbols.iter().map(name).collect::<Vec<_>>().join(", ");
    let laws = |equations: &[usize]| {
        let law = |position: &usize| {
            let equation = system.equations.get(*position)?;
            model.instances.get(equation.tag).map(|instance| instance.law.name)
        };
        equations.iter().filter_map(law).collect::<Vec<_>>().join(", ")
    };
    match &stuck.reason {
        Reason::Underdetermined { wanted, enough } => {
            let follow = if wanted.len() == 1 { "does not follow" } else { "do not follow" };
            let message = format!("{} {follow} from what is given", names(wanted));
            let spoken = |set: &&Vec<Symbol>| set.iter().all(|symbol| !model.symbols.entry(*symbol).name.contains(' '));
            let ways: Vec<String> = enough.iter().filter(spoken).take(4).map(|set| names(set)).collect();
            let known: Vec<Symbol> = stuck.known.iter().copied().collect();
            let help = if ways.is_empty() {
                format!("the givens are {}; describe the scene further, or give more values", names(&known))
            } else {
                let first = enough.first().filter(|_| own.is_fixed).and_then(|first| first.first());
                let any = first
                    .map_or_else(String::new, |first| format!("; its value does not matter: {} will do", any(first)));
                format!("give also {}{any}{}", ways.join(", or "), other_case(model, stuck, enough))
            };
            Fault::new(Code::UnderDetermined, message).help(help)
        }
        Reason::NoTactic { equations, unknowns } => {
            let message = format!("no known method gives {} from {}", names(unknowns), laws(equations));
            let help = match (&own.open, &own.instead[..]) {
                (Some(open), _) => {
                    format!("{} is open, and what is asked does not depend on it: give {}", name(open), any(open))
                }
                (None, []) => "describe the scene by other quantities, or ask for another".to_owned(),
                (None, ways) => {
                    let way = |(own, given): &(Symbol, Symbol)| format!("{} in place of {}", name(own), name(given));
                    format!("give {}", ways.iter().map(way).collect::<Vec<_>>().join(", or "))
                }
            };
            Fault::new(Code::Stuck, message).help(help)
        }
        Reason::Contradiction { equations } => {
            let message = format!("the givens contradict each other in {}", laws(equations));
            Fault::new(Code::OverDetermined, message).help("remove one of the givens that these laws connect")
        }
    }
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
        let exact = || {
            let input = |symbol: &Symbol| {
                let domain = domains.get(symbol.index()).and_then(Option::as_ref);
                inputs.get(symbol.index()).and_then(|input| input.exact(domain))
            };
            // Every input has a value here, so none is left out.
            regimes.inputs.iter().filter_map(input).collect()
        };
        self.taken = regimes.tree.solve_from(&self.inputs, &exact, &mut self.workspace);
        self.survivors(regimes)
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

    /// How many solutions the last run found.
    pub(crate) fn survivors(&self, regimes: &Regimes) -> usize {
        self.outcome(regimes).map_or(0, |outcome| outcome.survivors())
    }

    /// A solved quantity in SI units, with a bound on its error.
    pub(crate) fn value(&self, regimes: &Regimes, symbol: Symbol) -> Option<Bounded> {
        self.outcome(regimes)?.value(symbol).copied().filter(Real::is_real)
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
        let tried = self.taken.unwrap_or(0);
        let Some(outcome) = regimes.tree.outcome(tried, &self.workspace) else { return Vec::new() };
        let dead = outcome.dead().iter().map(|death| Dead {
            step: death.step,
            cause: death.cause,
            values: outcome.values_at_death(death).to_vec(),
        });
        dead.collect()
    }
}

/// A root that is not a solution.
#[derive(Clone, Debug)]
pub struct Dead {
    /// The step of the plan; none where the givens themselves break a condition.
    pub step: Option<usize>,
    /// What is wrong with it.
    pub cause: Cause,
    /// The values of the step's unknowns, in the step's order.
    pub values: Vec<Bounded>,
}
