//! Equations on a tape, for their values and all derivatives at many places. A symbol that stands alone on one side is computed
//! from the other, so that only what no equation defines must be sought.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{DMatrix, DVector};

use momentous_expr::{Expr, Symbol};

use super::super::Statement;
use super::super::replay::backward::run_back;
use super::super::replay::symbol_registers::SymbolRegisters;
use super::super::replay::tape::{Instruction, Register, run};
use super::super::replay::workspace::{Constants, Workspace};
use super::super::replay::writer::Writer;
use super::incidence::ascending;

/// The residuals, zero where all equations hold, as a function of the symbols that no equation defines.
#[derive(Debug)]
pub(super) struct Residuals {
    tape: Vec<Instruction>,
    constants: Constants<f64>,
    /// The symbols that are sought.
    pub(crate) free: Vec<Symbol>,
    /// Their registers.
    inputs: Vec<Register>,
    /// Every symbol.
    symbols: SymbolRegisters,
    zeros: Vec<Zero>,
}

impl Residuals {
    /// The residuals of these equations; counts have none.
    pub(crate) fn of<'s>(stated: &[&'s Statement]) -> Self {
        let mut definitions = Definitions::of(stated);
        let (mut writer, mut free) = (Writer::default(), Vec::new());
        let sides = |statement: &&'s Statement| match statement {
            Statement::Equal { left, right } => Some([left, right]),
            Statement::FirstInteger { .. } => None,
        };
        let sides: Vec<Option<[&Expr; 2]>> = stated.iter().map(sides).collect();
        for symbol in ascending(sides.iter().flatten().flatten().copied()) {
            definitions.write(symbol, &mut writer, &mut free);
        }
        let open = sides.iter().enumerate().filter(|(place, _)| !definitions.used.contains(place));
        let zeros = open.filter_map(|(_, sides)| {
            let [left, right] = sides.as_ref()?;
            writer.difference(left, right)
        });
        let zeros: Vec<Register> = zeros.collect();
        Self {
            constants: Constants::new(&writer),
            free: free.iter().map(|(symbol, _)| *symbol).collect(),
            inputs: free.into_iter().map(|(_, register)| register).collect(),
            zeros: zeros.into_iter().map(|register| Zero::of(register, &writer)).collect(),
            tape: writer.tape,
            symbols: writer.symbols,
        }
    }

    /// Everything that is computed from values of the free symbols.
    pub(crate) fn at(&self, place: &[f64]) -> Values {
        let mut workspace = Workspace::default();
        workspace.prepare(&self.constants, &self.inputs, place.iter());
        run(&self.tape, &(0..self.tape.len()), &mut workspace.registers);
        Values(workspace.registers)
    }

    /// The value of each symbol.
    pub(crate) fn symbols<'a>(&'a self, values: &'a Values) -> impl Iterator<Item = (Symbol, f64)> + 'a {
        self.symbols.iter().map(|(symbol, register)| (symbol, values.get(register)))
    }

    /// How far off zero each residual is; none where one has no value.
    pub(super) fn off(&self, values: &Values) -> Option<DVector<f64>> {
        let off = DVector::from_iterator(self.zeros.len(), self.zeros.iter().map(|zero| values.get(zero.register)));
        off.iter().all(|residual| residual.is_finite()).then_some(off)
    }

    /// The derivatives of each residual, a column, in the free symbols: by one backward run of the tape for each.
    pub(crate) fn slopes(&self, values: &Values) -> DMatrix<f64> {
        let mut slopes = DMatrix::zeros(self.free.len(), self.zeros.len());
        let mut shares = vec![0.0; values.0.len()];
        for (zero, mut column) in self.zeros.iter().zip(slopes.column_iter_mut()) {
            shares.fill(0.0);
            shares[zero.register as usize] = 1.0;
            run_back(zero.made_by.iter().filter_map(|place| self.tape.get(*place)), &values.0, &mut shares);
            column.iter_mut().zip(&self.inputs).for_each(|(slope, input)| *slope = shares[*input as usize]);
        }
        slopes
    }
}

/// The residuals: zero where all equations hold.
#[derive(Debug)]
struct Zero {
    register: Register,
    /// The places on the tape of what it is computed by, the last one first.
    made_by: Vec<usize>,
}

impl Zero {
    fn of(register: Register, writer: &Writer) -> Self {
        let mut needed = vec![false; writer.registers as usize];
        needed[register as usize] = true;
        let serves = |(place, instruction): (usize, &Instruction)| {
            let serves = needed[instruction.to as usize];
            if serves {
                instruction.operands.iter().for_each(|operand| needed[*operand as usize] = true);
            }
            serves.then_some(place)
        };
        let made_by = writer
            .tape
            .iter()
            .enumerate()
            .rev()
            .skip_while(|(_, instruction)| instruction.to != register)
            .filter_map(serves);
        let made_by = made_by.collect();
        Self { register, made_by }
    }
}

/// The value in each register after a run.
#[derive(Clone, Debug)]
pub(crate) struct Values(Vec<f64>);

impl Values {
    fn get(&self, register: Register) -> f64 {
        self.0.get(register as usize).copied().unwrap_or(f64::NAN)
    }
}

/// The equations that define a symbol: it stands alone on one side, and not on the other.
struct Definitions<'a> {
    by_symbol: BTreeMap<Symbol, (usize, &'a Expr)>,
    /// The symbols on the way to which the definition of another is being written.
    open: BTreeSet<Symbol>,
    /// The equations that define something.
    used: BTreeSet<usize>,
}

impl<'a> Definitions<'a> {
    fn of(stated: &[&'a Statement]) -> Self {
        let mut by_symbol = BTreeMap::new();
        for (place, statement) in stated.iter().enumerate() {
            let Statement::Equal { left, right } = statement else { continue };
            for (side, other) in [(left, right), (right, left)] {
                if let Expr::Symbol(symbol) = side
                    && !by_symbol.contains_key(symbol)
                    && !other.contains(*symbol)
                {
                    by_symbol.insert(*symbol, (place, other));
                    break;
                }
            }
        }
        Self { by_symbol, open: BTreeSet::new(), used: BTreeSet::new() }
    }

    /// Gives a symbol its register, after those that it is defined by. Of symbols that define each other in a circle, one is free.
    /// Recursion is at most as deep as there are symbols.
    fn write(&mut self, symbol: Symbol, writer: &mut Writer, free: &mut Vec<(Symbol, Register)>) {
        if writer.symbols.holds(symbol) {
            return;
        }
        if self.open.insert(symbol)
            && let Some((place, other)) = self.by_symbol.get(&symbol).copied()
        {
            for part in ascending([other]) {
                self.write(part, writer, free);
            }
            if !writer.symbols.holds(symbol)
                && let Some(register) = writer.expr(other)
            {
                self.used.insert(place);
                writer.symbols.insert(symbol, register);
                return;
            }
        }
        if !writer.symbols.holds(symbol) {
            free.push((symbol, writer.input(symbol)));
        }
    }
}
