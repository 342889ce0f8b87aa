//! Many straight plans side by side on one tape: what they share is computed once, and nothing is judged on the way.

use std::cell::RefCell;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::super::number::real::Real;
use super::super::{Closed, Plan, System};
use super::symbol_registers::SymbolRegisters;
use super::tape::{Instruction, Register, run};
use super::workspace::{Constants, Workspace};
use super::writer::Writer;

/// The bound below zero, in SI units, down to which a value may be the rounding of one that is nothing.
const ROUNDED: f64 = 1e-9;

/// Plans without any choice, on one tape.
#[derive(Clone, Debug)]
pub struct Batch {
    tape: Vec<Instruction>,
    inputs: Vec<Register>,
    constants: Constants<f64>,
    members: Vec<Member>,
}

/// One plan: its unknowns, and whether each is positive; and where to find what is wanted.
#[derive(Clone, Debug)]
struct Member {
    unknowns: Vec<(Register, bool)>,
    wanted: Vec<(Symbol, Register)>,
}

/// Writes a batch.
#[derive(Debug)]
pub struct BatchWriter {
    writer: Writer,
    given: SymbolRegisters,
    inputs: Vec<Register>,
    members: Vec<Member>,
}

/// The results of every plan of a batch, for one set of inputs.
#[derive(Debug)]
pub struct BatchValues<'a> {
    batch: &'a Batch,
    workspace: Workspace<f64>,
}

thread_local! {
    /// The memory of the last run, which the next one takes.
    static MEMORY: RefCell<Workspace<f64>> = RefCell::default();
}

impl Drop for BatchValues<'_> {
    fn drop(&mut self) {
        MEMORY.set(std::mem::take(&mut self.workspace));
    }
}

impl BatchWriter {
    /// A batch over these inputs, in their order.
    #[must_use]
    pub fn new(inputs: &[Symbol]) -> Self {
        let mut writer = Writer::default();
        let inputs = inputs.iter().map(|symbol| writer.input(*symbol)).collect();
        Self { given: writer.symbols.clone(), writer, inputs, members: Vec::new() }
    }

    /// Adds a plan and gives its place; some inputs are `misread`, so many times too large. `None` where it has a choice of roots,
    /// or a search, or uses what is not given.
    pub fn add(
        &mut self,
        system: &System,
        plan: &Plan,
        wanted: &[Symbol],
        misread: &[(Symbol, Rational)],
    ) -> Option<usize> {
        self.writer.symbols.clone_from(&self.given);
        for (symbol, factor) in misread {
            let register = self.writer.expr(&(Expr::Number(factor.clone()) * Expr::from(*symbol)))?;
            self.writer.symbols.insert(*symbol, register);
        }
        let mut unknowns = Vec::new();
        for step in &plan.steps {
            let [root] = step.roots.as_slice() else { return None };
            for (symbol, value) in &root.values {
                let Closed::Formula(formula) = value else { return None };
                let register = self.writer.expr(formula)?;
                self.writer.symbols.insert(*symbol, register);
            }
            for symbol in &step.unknowns {
                unknowns.push((self.writer.symbols.get(*symbol)?, system.positive.contains(symbol)));
            }
        }
        let wanted = wanted.iter().filter_map(|symbol| Some((*symbol, self.writer.symbols.get(*symbol)?)));
        self.members.push(Member { unknowns, wanted: wanted.collect() });
        Some(self.members.len() - 1)
    }

    /// The batch of all that was added.
    #[must_use]
    pub fn finish(self) -> Batch {
        Batch {
            constants: Constants::new(&self.writer),
            tape: self.writer.tape,
            inputs: self.inputs,
            members: self.members,
        }
    }
}

impl Batch {
    /// Runs every plan from these inputs.
    #[must_use]
    pub fn run(&self, inputs: &[f64]) -> BatchValues<'_> {
        let mut workspace = MEMORY.take();
        workspace.prepare(&self.constants, &self.inputs, inputs.iter());
        run(&self.tape, &(0..self.tape.len()), &mut workspace.registers);
        BatchValues { batch: self, workspace }
    }
}

impl BatchValues<'_> {
    /// A quantity in the solution of the plan at that place, if it `is_wanted`; `None` also where the plan does not find it, and
    /// where some unknown is not real, or is negative though it never can be.
    #[must_use]
    pub fn value(&self, place: usize, symbol: Symbol, is_wanted: &dyn Fn(f64) -> bool) -> Option<f64> {
        let member = self.batch.members.get(place)?;
        let at = |register: Register| self.workspace.registers.get(register as usize);
        let can_be = |(register, positive): &(Register, bool)| {
            at(*register).is_some_and(|number| number.is_real() && !(*positive && *number < -ROUNDED))
        };
        let (_, register) = member.wanted.iter().find(|(wanted, _)| *wanted == symbol)?;
        let value = *at(*register)?;
        // Few values are wanted, so that is asked first.
        (value.is_finite() && is_wanted(value) && member.unknowns.iter().all(can_be)).then_some(value)
    }
}
