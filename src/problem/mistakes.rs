//! The usual mistakes in one form of a problem, each as the program that makes it. They are planned once, when the first
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
use crate::quantity::Unit;
use crate::solve::Batch;
use crate::solve::BatchWriter;
use crate::solve::Bounded;
use crate::solve::Plan;
use crate::solve::Program;
use crate::solve::Real;
use crate::solve::System;
use crate::solve::Verify;
use crate::solve::Workspace;

use super::planned::Form;
use super::planned::Problem;
use super::regimes::Leaf;
use super::restricted::Restricted;
use super::variant::Worked;

/// The mistakes of a form, for each way in which its scene can go; empty until they are asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Mistakes(Arc<OnceLock<Vec<Planned>>>);

/// The mistakes of one way in which a scene can go, with the tape of all that are made straight on.
#[derive(Clone, Debug)]
pub(super) struct Planned {
    list: Vec<Mistake>,
    pub(super) inputs: Vec<Symbol>,
    pub(super) batch: Batch,
    /// The quantities that are asked and whose sign is a direction.
    pub(super) directed: Vec<Symbol>,
}

/// One way of making one usual mistake.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// The mistake.
    pub of: &'static Misconception,
    /// The law that is got wrong, as it is used: a position in [`crate::model::Model::instances`]; none where nothing is
    /// wrong with the laws.
    pub instance: Option<usize>,
    pub(super) made: Made,
}

#[derive(Clone, Debug)]
pub(super) enum Made {
    /// The system has a wrong equation.
    Solved(Vec<Way>),
    /// Some givens are taken too large or too small by a factor.
    Misread(Arc<Solver>, Vec<(Symbol, f64)>),
    /// The right value is written down wrongly.
    Written(SlipOf, fn(f64) -> f64),
}

/// How the values that come of a mistake are found.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub(super) solver: Solver,
    /// The place in the batch, where there is nothing to choose and nothing to judge.
    pub(super) batched: Option<usize>,
}

/// A program for some of the quantities that are asked, with what chooses among its roots.
#[derive(Clone, Debug)]
pub(super) struct Solver {
    pub(super) wanted: Vec<Symbol>,
    inputs: Vec<Symbol>,
    pub(super) plan: Plan,
    /// With the conditions of a true solution, where there is something to choose.
    strict: Option<Program>,
    /// Without them: a wrong value need not be a possible one.
    loose: Program,
}

thread_local! {
    /// A wrong answer runs some dozens of programs; with one memory for all of them they allocate nothing.
    static MEMORY: RefCell<Workspace<Bounded>> = RefCell::default();
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
        let ways: Vec<Way> = solvers.map(|solver| solver.into_way(&mistaken.system, &mut batch)).collect();
        if !ways.is_empty() {
            mistakes.push(Mistake { of: mistaken.of, instance: Some(mistaken.instance), made: Made::Solved(ways) });
        }
    }
    let right = Restricted::new(&leaf.system, used);
    if let Some(right) = Solver::new(&right.system, &form.told, &wanted).map(Arc::new) {
        mistakes.extend(misread(problem, form, &right));
    }
    mistakes.extend(SLIPS.iter().map(|slip| Mistake {
        of: slip.of,
        instance: None,
        made: Made::Written(slip.to, slip.written),
    }));
    let directed = wanted.into_iter().filter(|symbol| problem.senses(*symbol).is_some()).collect();
    Planned { list: mistakes, inputs, batch: batch.finish(), directed }
}

/// Every unit that some given has and that is often overlooked: of all its givens, and of each alone.
fn misread(problem: &Problem, form: &Form, right: &Arc<Solver>) -> Vec<Mistake> {
    let mut mistakes = Vec::new();
    for row in MISREADINGS {
        let (Ok(given), Ok(taken)) = (Unit::parse(row.given), Unit::parse(row.taken)) else { continue };
        let factor = (taken.factor() * given.factor().power(-1)).to_f64();
        let told =
            form.told.iter().filter(|symbol| problem.unit_told(form, **symbol).is_some_and(|unit| unit == given));
        let read: Vec<(Symbol, f64)> = told.map(|symbol| (*symbol, factor)).collect();
        let mistake = |read: Vec<(Symbol, f64)>| Mistake {
            of: row.of,
            instance: None,
            made: Made::Misread(Arc::clone(right), read),
        };
        if read.len() > 1 {
            mistakes.extend(read.iter().map(|own| mistake(vec![*own])));
        }
        if !read.is_empty() {
            mistakes.push(mistake(read));
        }
    }
    mistakes
}

impl Solver {
    /// A program for everything that is wanted; where the mistake leaves some of it open, one for each that it does not.
    fn each(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Vec<Self> {
        match Self::new(system, told, wanted) {
            Some(whole) => vec![whole],
            None => wanted.iter().filter_map(|symbol| Self::new(system, told, &[*symbol])).collect(),
        }
    }

    pub(super) fn new(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        let plan = crate::solve::plan(system, told, wanted).ok()?;
        let several = plan.steps.iter().any(|step| step.roots.len() > 1);
        let audit = crate::solve::Audit { answer_steps: plan.steps.len(), plan, checks: Vec::new() };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let compile = |system: &System| Program::compile(system, &audit, &inputs, wanted, Verify::Redundant).ok();
        let strict = if several { compile(system) } else { None };
        let bare = System { conditions: Vec::new(), ..system.clone() };
        Some(Self { wanted: wanted.to_vec(), strict, loose: compile(&bare)?, inputs, plan: audit.plan.clone() })
    }

    fn into_way(self, system: &System, batch: &mut BatchWriter) -> Way {
        let plain = self.strict.is_none() && self.loose.is_plain();
        let batched = if plain { batch.add(system, &self.plan, &self.wanted) } else { None };
        Way { solver: self, batched }
    }

    /// What the program takes, in order.
    pub(super) fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }

    /// The values of a quantity in every solution: those that can be, or where none can, all.
    pub(super) fn values(&self, symbol: Symbol, input: &dyn Fn(Symbol) -> Option<Bounded>) -> Vec<f64> {
        if !self.wanted.contains(&symbol) {
            return Vec::new();
        }
        let inputs: Option<Vec<Bounded>> = self.inputs.iter().map(|own| input(*own)).collect();
        let Some(inputs) = inputs else { return Vec::new() };
        MEMORY.with_borrow_mut(|memory| {
            let mut run = |program: &Program| {
                let outcome = program.run(&inputs, memory);
                let first = outcome.value(symbol).into_iter();
                let all = first.chain(outcome.other_values(symbol)).filter(|value| value.is_real());
                all.map(|value| value.value).filter(|value| value.is_finite()).collect::<Vec<f64>>()
            };
            let possible = self.strict.as_ref().map(&mut run).unwrap_or_default();
            if possible.is_empty() { run(&self.loose) } else { possible }
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
    /// The usual mistakes that can be made with this variant's form. They are planned when this is first called.
    #[must_use]
    pub fn mistakes(&self) -> &'a [Mistake] {
        self.planned().map_or(&[], |planned| planned.list.as_slice())
    }

    pub(super) fn planned(&self) -> Option<&'a Planned> {
        self.form.mistakes.of_leaf(self.problem, self.form, self.variant.leaf())
    }
}
