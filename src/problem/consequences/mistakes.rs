//! The common mistakes in one form of a problem, each as the program that makes it. They are planned once, when the first
//! wrong answer asks for them; right answers never do.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;

use crate::expr::Symbol;
use crate::laws::wrong::Misconception;
use crate::laws::wrong::reading::MISREADINGS;
use crate::laws::wrong::reading::SLIPS;
use crate::laws::wrong::reading::SlipOf;
use crate::quantity::Rational;
use crate::quantity::Unit;
use crate::solve::Batch;
use crate::solve::BatchWriter;
use crate::solve::Bounded;
use crate::solve::Plan;
use crate::solve::Program;
use crate::solve::System;
use crate::solve::Verify;
use crate::solve::Workspace;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Leaf;
use super::super::sampling::variant::Worked;
use super::restricted::Restricted;

/// The mistakes of a form, for each way in which its scene can go; empty until they are asked for.
#[derive(Clone, Debug, Default)]
pub(in crate::problem) struct Mistakes(Arc<OnceLock<Vec<Planned>>>);

/// The mistakes of one way in which a scene can go, with the tape of all that are made straight on.
#[derive(Clone, Debug)]
pub(super) struct Planned {
    list: Vec<Mistake>,
    pub(in crate::problem) inputs: Vec<Symbol>,
    pub(super) batch: Batch,
    /// The quantities that are asked and whose sign is a direction.
    pub(super) directed: Vec<Symbol>,
}

/// One way of making one common mistake.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// The mistake.
    pub of: &'static Misconception,
    /// The law that is got wrong, as it is used: a position in [`crate::model::Model::instances`]; none where nothing is
    /// wrong with the laws.
    pub instance: Option<usize>,
    /// In how many places the same is got wrong: one mistake is likelier than several.
    pub places: usize,
    pub(super) made: Made,
}

impl Mistake {
    /// Whether a given is taken in another unit.
    #[must_use]
    pub fn is_misreading(&self) -> bool {
        matches!(self.made, Made::Misread(..))
    }
}

#[derive(Clone, Debug)]
pub(super) enum Made {
    /// The system has a wrong equation.
    Solved(Vec<WrongSystem>),
    /// Some givens are taken too large or too small by a factor; at this place in the batch, where it is in there.
    Misread(Arc<Solver>, Vec<(Symbol, f64)>, Option<usize>),
    /// The right value is written down wrongly.
    Written(SlipOf, fn(f64) -> f64),
}

/// How the values that come of a mistake are found.
#[derive(Clone, Debug)]
pub(super) struct WrongSystem {
    pub(in crate::problem) solver: Solver,
    /// The place in the batch, where there is nothing to choose and nothing to judge.
    pub(super) batched: Option<usize>,
}

/// A program for some of the quantities that are asked, with what chooses among its roots.
#[derive(Clone, Debug)]
pub(super) struct Solver {
    pub(in crate::problem) wanted: Vec<Symbol>,
    inputs: Vec<Symbol>,
    pub(in crate::problem) plan: Plan,
    /// With the conditions of a true solution, where there is something to choose.
    strict: Option<Program>,
    /// Without them: a wrong value need not be a possible one.
    loose: Program,
}

thread_local! {
    /// A wrong answer runs some dozens of programs; with one memory for all of them they allocate nothing.
    static MEMORY: RefCell<(Vec<Bounded>, Workspace<Bounded>)> = RefCell::default();
}

impl Mistakes {
    pub(super) fn of_leaf(&self, problem: &Problem, form: &Form, leaf: usize) -> Option<&Planned> {
        let all = self.0.get_or_init(|| form.solver.leaves().iter().map(|leaf| planned(problem, form, leaf)).collect());
        all.get(leaf)
    }
}

fn planned(problem: &Problem, form: &Form, leaf: &Leaf) -> Planned {
    let used: BTreeSet<usize> = leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
    let wanted: Vec<Symbol> = form.wanted().collect();
    let inputs: Vec<Symbol> = form.told.iter().copied().collect();
    let mut batch = BatchWriter::new(&inputs);
    let mut mistakes: Vec<Mistake> = Vec::new();
    for mistaken in problem.model().mistaken(&leaf.system, &used, &form.told, problem.units()) {
        let solvers = Solver::each(&mistaken.system, &form.told, &wanted).into_iter();
        let solvers = solvers.filter_map(|solver| solver.of_what_depends(&mistaken.system, &mistaken.wrong));
        let ways: Vec<WrongSystem> = solvers.map(|solver| solver.into_way(&mistaken.system, &mut batch)).collect();
        if !ways.is_empty() {
            let (of, instance, places) = (mistaken.of, Some(mistaken.instance), mistaken.places);
            mistakes.push(Mistake { of, instance, places, made: Made::Solved(ways) });
        }
    }
    let restricted = Restricted::new(&leaf.system, used);
    if let Some(right) = Solver::new(&restricted.system, &form.told, &wanted).map(Arc::new) {
        for (of, read) in misread(problem, form) {
            let exactly = |(symbol, factor): &(Symbol, f64)| Some((*symbol, Rational::try_from(*factor).ok()?));
            let exactly: Option<Vec<_>> = read.iter().map(exactly).collect();
            let place = exactly.and_then(|read| right.batched(&restricted.system, &read, &mut batch));
            let made = Made::Misread(Arc::clone(&right), read, place);
            mistakes.push(Mistake { of, instance: None, places: 1, made });
        }
    }
    mistakes.extend(SLIPS.iter().map(|slip| Mistake {
        of: slip.of,
        instance: None,
        places: 1,
        made: Made::Written(slip.to, slip.written),
    }));
    let directed = wanted.into_iter().filter(|symbol| problem.senses(*symbol).is_some()).collect();
    Planned { list: mistakes, inputs, batch: batch.finish(), directed }
}

/// Every unit that some given has and that is often overlooked: of all its givens, of each alone where that is told from
/// other mistakes, and by how much.
fn misread(problem: &Problem, form: &Form) -> Vec<(&'static Misconception, Vec<(Symbol, f64)>)> {
    let mut found = Vec::new();
    for row in MISREADINGS {
        let (Ok(given), Ok(taken)) = (Unit::parse(row.given), Unit::parse(row.taken)) else { continue };
        let factor = taken.in_terms_of(&given).to_f64();
        let told =
            form.told.iter().filter(|symbol| problem.unit_told(form, **symbol).is_some_and(|unit| unit == given));
        let read: Vec<(Symbol, f64)> = told.map(|symbol| (*symbol, factor)).collect();
        if read.len() > 1 && row.alone {
            found.extend(read.iter().map(|own| (row.of, vec![*own])));
        }
        if !read.is_empty() {
            found.push((row.of, read));
        }
    }
    found
}

impl Solver {
    /// A program for everything that is wanted; where the mistake leaves some of it open, one for each that it does not.
    fn each(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Vec<Self> {
        match Self::new(system, told, wanted) {
            Some(whole) => vec![whole],
            None => wanted.iter().filter_map(|symbol| Self::new(system, told, &[*symbol])).collect(),
        }
    }

    pub(in crate::problem) fn new(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        let plan = crate::solve::plan(system, told, wanted).ok()?;
        let several = plan.steps.iter().any(|step| step.roots.len() > 1);
        let audit = crate::solve::Audit { answer_steps: plan.steps.len(), plan, checks: Vec::new() };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let compile = |system: &System| Program::compile(system, &audit, &inputs, wanted, Verify::Redundant).ok();
        let strict = if several { compile(system) } else { None };
        let bare = System { conditions: Vec::new(), ..system.clone() };
        Some(Self { wanted: wanted.to_vec(), strict, loose: compile(&bare)?, inputs, plan: audit.plan.clone() })
    }

    /// The same for what depends on some wrong equation: the mistake leaves the rest as it is. None where nothing does.
    fn of_what_depends(self, system: &System, wrong: &BTreeSet<usize>) -> Option<Self> {
        let mut depending: BTreeSet<Symbol> = BTreeSet::new();
        for step in &self.plan.steps {
            let uses = |equation: &usize| {
                let statement = system.equations.get(*equation);
                wrong.contains(equation) || statement.is_some_and(|own| !own.symbols().is_disjoint(&depending))
            };
            if step.equations.iter().any(uses) {
                depending.extend(step.unknowns.iter().copied());
            }
        }
        let wanted: Vec<Symbol> = self.wanted.iter().copied().filter(|own| depending.contains(own)).collect();
        if wanted.is_empty() { None } else { Some(Self { wanted, ..self }) }
    }

    fn into_way(self, system: &System, batch: &mut BatchWriter) -> WrongSystem {
        let batched = self.batched(system, &[], batch);
        WrongSystem { solver: self, batched }
    }

    /// The place in the batch of the same with some givens misread, where there is nothing to choose and nothing to judge.
    fn batched(&self, system: &System, misread: &[(Symbol, Rational)], batch: &mut BatchWriter) -> Option<usize> {
        let plain = self.strict.is_none() && self.loose.is_plain();
        if plain { batch.add(system, &self.plan, &self.wanted, misread) } else { None }
    }

    /// What the program takes, in order.
    pub(in crate::problem) fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }

    /// Whether there are several roots, among which the conditions of a true solution choose.
    pub(super) fn chooses(&self) -> bool {
        self.strict.is_some()
    }

    /// Gives `add` the values of a quantity in every solution: those that can be, or where none can, all.
    pub(in crate::problem) fn values(
        &self,
        symbol: Symbol,
        input: &dyn Fn(Symbol) -> Option<Bounded>,
        add: &mut dyn FnMut(f64),
    ) {
        if !self.possible(symbol, input, add) {
            self.roots(symbol, input, add);
        }
    }

    /// Those that can be, where there is something to choose; whether there are any.
    pub(super) fn possible(
        &self,
        symbol: Symbol,
        input: &dyn Fn(Symbol) -> Option<Bounded>,
        add: &mut dyn FnMut(f64),
    ) -> bool {
        self.strict.as_ref().is_some_and(|program| self.run(program, symbol, input, add))
    }

    /// Those of every root, possible or not.
    pub(super) fn roots(
        &self,
        symbol: Symbol,
        input: &dyn Fn(Symbol) -> Option<Bounded>,
        add: &mut dyn FnMut(f64),
    ) -> bool {
        self.run(&self.loose, symbol, input, add)
    }

    fn run(
        &self,
        program: &Program,
        symbol: Symbol,
        input: &dyn Fn(Symbol) -> Option<Bounded>,
        add: &mut dyn FnMut(f64),
    ) -> bool {
        if !self.wanted.contains(&symbol) {
            return false;
        }
        MEMORY.with_borrow_mut(|(inputs, workspace)| {
            inputs.clear();
            inputs.extend(self.inputs.iter().map_while(|own| input(*own)));
            if inputs.len() < self.inputs.len() {
                return false;
            }
            let outcome = program.run(inputs, workspace);
            let all = outcome.value(symbol).into_iter().chain(outcome.other_values(symbol));
            let mut found = false;
            for value in all.map(|own| own.value).filter(|value| value.is_finite()) {
                found = true;
                add(value);
            }
            found
        })
    }
}

impl Problem {
    /// The unit in which a form tells a quantity.
    fn unit_told(&self, form: &Form, symbol: Symbol) -> Option<Unit> {
        let revealed = form.reveal.iter().find(|reveal| reveal.symbol == symbol).map(|reveal| reveal.unit.clone());
        revealed.or_else(|| self.unit_given(symbol))
    }
}

impl<'a> Worked<'a> {
    /// The common mistakes that can be made with this variant's form. They are planned when this is first called.
    #[must_use]
    pub fn mistakes(&self) -> &'a [Mistake] {
        self.planned().map_or(&[], |planned| planned.list.as_slice())
    }

    pub(super) fn planned(&self) -> Option<&'a Planned> {
        self.form.mistakes.of_leaf(self.problem, self.form, self.variant.leaf())
    }
}
