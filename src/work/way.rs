//! The values that follow from a system of equations.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Symbol;
use momentous_solve::Audit;
use momentous_solve::Bounded;
use momentous_solve::Plan;
use momentous_solve::Program;
use momentous_solve::System;
use momentous_solve::Verify;
use momentous_solve::Workspace;
use momentous_solve::plan;

/// The values of quantities, each in SI units.
pub(crate) type Values = BTreeMap<Symbol, Bounded>;

/// A way from some quantities to others.
#[derive(Clone, Debug)]
pub(crate) struct Way {
    inputs: Vec<Symbol>,
    program: Program,
    finds: BTreeSet<Symbol>,
    equations: BTreeSet<usize>,
}

impl Way {
    /// The way from what is known to what is wanted; none where no method gives it.
    pub(crate) fn new(system: &System, known: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        Self::of(system, plan(system, known, wanted).ok()?, known, wanted)
    }

    /// The way that a plan describes.
    pub(crate) fn of(system: &System, plan: Plan, known: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        let finds = plan.steps.iter().flat_map(|step| step.unknowns.iter().copied()).collect();
        let equations = plan.steps.iter().flat_map(|step| step.equations.iter().copied()).collect();
        let mentioned =
            plan.steps.iter().flat_map(|step| &step.equations).filter_map(|equation| system.equations.get(*equation));
        let mentioned: BTreeSet<Symbol> = mentioned.flat_map(momentous_solve::Equation::symbols).collect();
        let judged = system
            .conditions
            .iter()
            .flat_map(|condition| [condition.left.symbols(), condition.right.symbols()])
            .flatten();
        let mentioned: BTreeSet<Symbol> = mentioned.into_iter().chain(judged).collect();
        let inputs: Vec<Symbol> = known.intersection(&mentioned).copied().collect();
        let audit = Audit { answer_steps: plan.steps.len(), plan, checks: Vec::new() };
        let program = Program::compile(system, &audit, &inputs, wanted, Verify::Redundant).ok()?;
        Some(Self { inputs, program, finds, equations })
    }

    /// Whether it finds a quantity.
    pub(crate) fn finds(&self, symbol: Symbol) -> bool {
        self.finds.contains(&symbol)
    }

    /// Whether it uses some of these equations of its system.
    pub(crate) fn uses(&self, equations: &BTreeSet<usize>) -> bool {
        !self.equations.is_disjoint(equations)
    }

    /// The values of what it finds, in each solution.
    pub(crate) fn solve(&self, value: &dyn Fn(Symbol) -> Option<Bounded>) -> Vec<Values> {
        let Some(inputs) = self.inputs.iter().map(|symbol| value(*symbol)).collect::<Option<Vec<_>>>() else {
            return Vec::new();
        };
        let mut memory = Workspace::default();
        let outcome = self.program.run(&inputs, &mut memory);
        let first: Values = outcome
            .values()
            .filter(|(symbol, _)| self.finds(*symbol))
            .map(|(symbol, number)| (symbol, *number))
            .collect();
        if first.is_empty() {
            return Vec::new();
        }
        let mut solutions = vec![first];
        for symbol in &self.finds {
            for (place, other) in outcome.other_values(*symbol).enumerate() {
                if solutions.len() <= place + 1 {
                    solutions.push(Values::new());
                }
                solutions[place + 1].insert(*symbol, *other);
            }
        }
        solutions
    }
}
