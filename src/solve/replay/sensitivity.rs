//! How much a value moves with each of the values on the way to it.

use std::cell::RefCell;
use std::collections::BTreeSet;

use momentous_expr::{Expr, Symbol};

use super::super::{Closed, Step};
use super::backward::run_back;
use super::tape::{Instruction, Register, Stretch, run};
use super::workspace::{Constants, Workspace};
use super::writer::Writer;

/// The formulas of a plan's steps on a tape, for the derivatives of one value by those that it was made from.
///
/// ```
/// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
/// use momentous_quantity::Dimension;
/// use momentous_solve::{Equation, Sensitivity, Statement, System, plan};
///
/// let mut table = SymbolTable::default();
/// let [m, v, p, energy] = ["m", "v", "p", "T"].map(|name| {
///     table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: name.into() })
/// });
/// let equal = |left: Expr, right: Expr| Equation { statement: Statement::Equal { left, right }, tag: 0, cost: 1 };
/// let [m_, v_, p_] = [m, v, p].map(Expr::from);
/// let twice = Expr::integer(2) * Expr::from(energy);
/// let equations = vec![equal(p_.clone(), m_.clone() * v_), equal(twice * m_, p_.powi(2))];
/// let steps = plan(&System { equations, ..System::default() }, &[m, v].into(), &[energy]).unwrap().steps;
///
/// // A mass of 2 at a speed of 3: the energy rises with the momentum by p/m.
/// let value = |symbol| if symbol == m { 2.0 } else if symbol == v { 3.0 } else if symbol == p { 6.0 } else { 9.0 };
/// let mut slopes = Vec::new();
/// Sensitivity::of(&steps).each(energy, value, &[], |symbol, slope| slopes.push((symbol, slope)));
/// assert_eq!(slopes, [(energy, 1.0), (p, 3.0)]);
/// ```
#[derive(Clone, Debug)]
pub struct Sensitivity {
    tape: Vec<Instruction>,
    constants: Constants<f64>,
    symbols: Vec<Symbol>,
    registers: Vec<Register>,
    /// By step and root.
    steps: Vec<Vec<Vec<ValueStep>>>,
}

/// How one value is made in a step; a stretch of the tape where that is by a formula. Of symbols it has the places in the list.
#[derive(Clone, Debug)]
struct ValueStep {
    unknown: usize,
    by: Option<(Stretch, Register, Vec<usize>)>,
}

/// The memory of a run, which the next one takes.
#[derive(Debug, Default)]
struct ReusedBuffers {
    workspace: Workspace<f64>,
    /// By register.
    shares: Vec<f64>,
    /// By place in the list of symbols, like the slopes.
    values: Vec<f64>,
    slopes: Vec<f64>,
}

thread_local! {
    static MEMORY: RefCell<ReusedBuffers> = RefCell::default();
}

impl Sensitivity {
    /// The sensitivity of the values which these steps make.
    #[must_use]
    pub fn of(steps: &[Step]) -> Self {
        let values_of_steps = || steps.iter().flat_map(|step| &step.roots).flat_map(|root| &root.values);
        let parts = values_of_steps().filter_map(|(_, closed)| formula(closed)).flat_map(Expr::symbols);
        let symbols: BTreeSet<Symbol> = values_of_steps().map(|(unknown, _)| *unknown).chain(parts).collect();
        let mut writer = Writer::default();
        let symbols: Vec<Symbol> = symbols.into_iter().collect();
        let registers = symbols.iter().map(|symbol| writer.input(*symbol)).collect();
        let place = |symbol: &Symbol| symbols.partition_point(|smaller| smaller < symbol);
        let mut step_of = |(unknown, closed): &(Symbol, Closed)| {
            // What formulas share is computed for each: a slope that one of them has not would spoil the others'.
            let before = writer.mark();
            let by = formula(closed).and_then(|formula| {
                let (stretch, result) = writer.stretch(|writer| writer.expr(formula));
                Some((stretch, result?, formula.symbols().iter().map(place).collect()))
            });
            writer.forget(before);
            ValueStep { unknown: place(unknown), by }
        };
        let steps = steps.iter().map(|step| {
            let root = |values: &Vec<_>| values.iter().map(&mut step_of).collect();
            step.roots.iter().map(|root| &root.values).map(root).collect()
        });
        let steps = steps.collect();
        Self { steps, constants: Constants::new(&writer), registers, tape: writer.tape, symbols }
    }

    /// Gives `each` the values on the way to `asked`, itself first, with the derivative of `asked` by it: the sum over all that is
    /// made from it. `value` gives the value of a symbol, `roots` those that were taken, step by step. A derivative that a formula
    /// does not have at these values is left out.
    pub fn each(
        &self,
        asked: Symbol,
        value: impl Fn(Symbol) -> f64,
        roots: &[usize],
        mut each: impl FnMut(Symbol, f64),
    ) {
        self.back(asked, value, roots, |symbol, slope, is_computed| {
            if is_computed {
                each(symbol, slope);
            }
        });
    }

    /// The same for the values from which the steps start, with the whole derivative of `asked` by each of them.
    pub fn each_input(
        &self,
        asked: Symbol,
        value: impl Fn(Symbol) -> f64,
        roots: &[usize],
        mut each: impl FnMut(Symbol, f64),
    ) {
        self.back(asked, value, roots, |symbol, slope, is_computed| {
            if !is_computed {
                each(symbol, slope);
            }
        });
    }

    /// From `asked` back to what it is made from; says of each whether a step made it.
    fn back(
        &self,
        asked: Symbol,
        value: impl Fn(Symbol) -> f64,
        roots: &[usize],
        mut each: impl FnMut(Symbol, f64, bool),
    ) {
        let Ok(asked) = self.symbols.binary_search(&asked) else { return };
        MEMORY.with_borrow_mut(|ReusedBuffers { workspace, shares, values, slopes }| {
            [&mut *values, &mut *shares, &mut *slopes].into_iter().for_each(Vec::clear);
            values.extend(self.symbols.iter().map(|symbol| value(*symbol)));
            workspace.prepare(&self.constants, &self.registers, values.iter());
            shares.resize(workspace.registers.len(), 0.0);
            slopes.resize(self.symbols.len(), 0.0);
            slopes[asked] = 1.0;
            for (step, roots_made) in self.steps.iter().enumerate().rev() {
                let root = roots.get(step).and_then(|taken| roots_made.get(*taken)).or(roots_made.first());
                for value in root.into_iter().flatten().rev() {
                    // What is left in the list at the end was made by no step.
                    let slope = std::mem::take(&mut slopes[value.unknown]);
                    if slope == 0.0 {
                        continue;
                    }
                    each(self.symbols[value.unknown], slope, true);
                    let Some((stretch, result, parts)) = &value.by else { continue };
                    run(&self.tape, stretch, &mut workspace.registers);
                    shares[*result as usize] = slope;
                    run_back(self.tape[stretch.clone()].iter().rev(), &workspace.registers, shares);
                    for part in parts {
                        let share = std::mem::take(&mut shares[self.registers[*part] as usize]);
                        slopes[*part] += if share.is_finite() { share } else { 0.0 };
                    }
                }
            }
            for (symbol, slope) in self.symbols.iter().zip(slopes.iter()).filter(|(_, slope)| **slope != 0.0) {
                each(*symbol, *slope, false);
            }
        });
    }
}

fn formula(closed: &Closed) -> Option<&Expr> {
    match closed {
        Closed::Formula(formula) => Some(formula),
        _ => None,
    }
}
