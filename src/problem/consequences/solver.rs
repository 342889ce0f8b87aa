//! Programs for quantities by a changed system: with a wrong equation, or without some.

use std::cell::RefCell;
use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_quantity::Rational;
use momentous_solve::BatchWriter;
use momentous_solve::Bounded;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Program;
use momentous_solve::Statement;
use momentous_solve::System;
use momentous_solve::Verify;
use momentous_solve::Workspace;

/// A program for some of the quantities that are asked, with what chooses among its roots.
#[derive(Clone, Debug)]
pub(crate) struct Solver {
    pub(crate) wanted: Vec<Symbol>,
    inputs: Vec<Symbol>,
    pub(crate) plan: Plan,
    /// With the conditions of a true solution, where there is something to choose.
    strict: Option<Program>,
    /// Without them: a wrong value need not be a possible one.
    loose: Program,
}

thread_local! {
    /// A wrong answer runs some dozens of programs; with one memory for all of them they allocate nothing.
    static MEMORY: RefCell<(Vec<Bounded>, Workspace<Bounded>)> = RefCell::default();
}

impl Solver {
    /// A program for everything that is wanted; where the mistake leaves some of it open, or may leave nothing to count, one for
    /// each that it does not.
    pub(super) fn each(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Vec<Self> {
        let counts = |own: &Equation| matches!(own.statement, Statement::FirstInteger { .. });
        let whole = if system.equations.iter().any(counts) { None } else { Self::new(system, told, wanted) };
        match whole {
            Some(whole) => vec![whole],
            None => wanted.iter().filter_map(|symbol| Self::new(system, told, &[*symbol])).collect(),
        }
    }

    pub(crate) fn new(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        let plan = momentous_solve::plan(system, told, wanted).ok()?;
        let several = plan.steps.iter().any(|step| step.roots.len() > 1);
        let audit = momentous_solve::Audit { answer_steps: plan.steps.len(), plan, checks: Vec::new() };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let compile = |system: &System| Program::compile(system, &audit, &inputs, wanted, Verify::Redundant).ok();
        let strict = if several { compile(system) } else { None };
        let bare = System { conditions: Vec::new(), ..system.clone() };
        Some(Self { wanted: wanted.to_vec(), strict, loose: compile(&bare)?, inputs, plan: audit.plan.clone() })
    }

    /// The same for what depends on some wrong equation: the mistake leaves the rest as it is. None where nothing does.
    pub(super) fn of_what_depends(self, system: &System, wrong: &BTreeSet<usize>) -> Option<Self> {
        let mut depending: BTreeSet<Symbol> = BTreeSet::new();
        for step in &self.plan.steps {
            let uses = |equation: &usize| {
                let statement = system.equations.get(*equation);
                wrong.contains(equation)
                    || statement.is_some_and(|equation| !equation.symbols().is_disjoint(&depending))
            };
            if step.equations.iter().any(uses) {
                depending.extend(step.unknowns.iter().copied());
            }
        }
        let wanted: Vec<Symbol> = self.wanted.iter().copied().filter(|symbol| depending.contains(symbol)).collect();
        if wanted.is_empty() { None } else { Some(Self { wanted, ..self }) }
    }

    /// The place in the batch of the same with some givens misread, where there is nothing to choose and nothing to judge.
    pub(super) fn batched(
        &self,
        system: &System,
        misread: &[(Symbol, Rational)],
        batch: &mut BatchWriter,
    ) -> Option<usize> {
        let plain = self.strict.is_none() && self.loose.is_plain();
        if plain { batch.add(system, &self.plan, &self.wanted, misread) } else { None }
    }

    /// The inputs of the program, in order.
    pub(crate) fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }

    /// Whether there are several roots, among which the conditions of a true solution choose.
    pub(super) fn chooses(&self) -> bool {
        self.strict.is_some()
    }

    /// Gives `add` the values of a quantity in every solution: those that can be, or where none can, all.
    pub(crate) fn values(&self, symbol: Symbol, input: &dyn Fn(Symbol) -> Option<Bounded>, add: &mut dyn FnMut(f64)) {
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
            inputs.extend(self.inputs.iter().map_while(|symbol| input(*symbol)));
            if inputs.len() < self.inputs.len() {
                return false;
            }
            let outcome = program.run(inputs, workspace);
            let all = outcome.value(symbol).into_iter().chain(outcome.other_values(symbol));
            let mut has_values = false;
            for value in all.map(|number| number.value).filter(|value| value.is_finite()) {
                has_values = true;
                add(value);
            }
            has_values
        })
    }
}
