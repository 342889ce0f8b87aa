//! Writing terms onto a tape, each common part once.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Piecewise;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::super::Exact;
use super::symbol_registers::SymbolRegisters;
use super::tape::{Instruction, Operation, Register, Stretch};

/// Writes a tape. Constants and symbols have their registers; what is computed once is found again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Writer {
    /// The tape so far.
    pub(crate) tape: Vec<Instruction>,
    /// The registers that hold numbers.
    pub(super) constants: BTreeMap<Exact, Register>,
    /// The registers that hold symbols.
    pub(crate) symbols: SymbolRegisters,
    /// The number of registers.
    pub(crate) registers: Register,
    computed: FxHashMap<Computation, Register>,
    /// The computations, in the order in which they were written.
    history: Vec<Computation>,
}

type Computation = (Operation, [Register; 3]);

/// How much had been computed at some point of the tape.
#[derive(Clone, Copy)]
pub(super) struct Mark(usize);

impl Writer {
    /// A register that nothing else uses.
    pub(crate) fn register(&mut self) -> Register {
        self.registers += 1;
        self.registers - 1
    }

    /// The register of a symbol whose value comes from outside, made if need be.
    pub(crate) fn input(&mut self, symbol: Symbol) -> Register {
        self.symbols.get(symbol).unwrap_or_else(|| {
            let register = self.register();
            self.symbols.insert(symbol, register);
            register
        })
    }

    /// Remembers what is computed so far.
    pub(super) fn mark(&self) -> Mark {
        Mark(self.history.len())
    }

    /// Forgets what was computed since: it is not computed on every way through the tape.
    pub(super) fn forget(&mut self, mark: Mark) {
        for computation in self.history.drain(mark.0.min(self.history.len())..) {
            self.computed.remove(&computation);
        }
    }

    /// The instructions that `write` writes.
    pub(super) fn stretch<T>(&mut self, write: impl FnOnce(&mut Self) -> T) -> (Stretch, T) {
        let start = self.tape.len();
        let result = write(self);
        (start..self.tape.len(), result)
    }

    /// Copies a register.
    pub(crate) fn copy(&mut self, from: Register, to: Register) {
        self.tape.push(Instruction { operation: Operation::Copy, operands: [from, 0, 0], to });
    }

    /// The register that holds the term's value; `None` where a symbol has no register.
    /// Recursion is as deep as the term, whose depth the parser bounds.
    pub(crate) fn expr(&mut self, expr: &Expr) -> Option<Register> {
        match expr {
            Expr::Number(value) => Some(self.constant(value.clone().into())),
            Expr::Pi => Some(self.constant(Exact { rational: Rational::ONE, pi_power: 1 })),
            Expr::Symbol(symbol) => self.symbols.get(*symbol),
            Expr::Sum(terms) => self.sum(terms),
            Expr::Product(factors) => self.product(factors),
            Expr::Power(pair) => self.power(&pair.0, &pair.1),
            Expr::Apply(Function::Atan2, parts) => {
                let [y, x] = parts.as_ref() else { return None };
                let (y, x) = (self.expr(y)?, self.expr(x)?);
                Some(self.compute(Operation::Angle, [y, x, 0]))
            }
            Expr::Apply(function, parts) => {
                let argument = self.expr(parts.first()?)?;
                Some(self.compute(Operation::Apply(*function), [argument, 0, 0]))
            }
            Expr::Piecewise(piecewise) => self.piecewise(piecewise),
        }
    }

    /// The register of `left - right`.
    pub(crate) fn difference(&mut self, left: &Expr, right: &Expr) -> Option<Register> {
        let (left, right) = (self.expr(left)?, if right.is_zero() { None } else { Some(self.expr(right)?) });
        Some(right.map_or(left, |right| self.compute(Operation::Subtract, [left, right, 0])))
    }

    fn constant(&mut self, value: Exact) -> Register {
        if let Some(register) = self.constants.get(&value) {
            return *register;
        }
        let register = self.register();
        self.constants.insert(value, register);
        register
    }

    fn compute(&mut self, operation: Operation, mut operands: [Register; 3]) -> Register {
        if matches!(operation, Operation::Add | Operation::Multiply) && operands[0] > operands[1] {
            operands.swap(0, 1);
        }
        if operation == Operation::Subtract && operands[0] == operands[1] {
            // Exactly, while the difference of two roundings would only be small: nothing then looks undecided.
            return self.constant(Rational::ZERO.into());
        }
        if let Some(register) = self.computed.get(&(operation, operands)) {
            return *register;
        }
        let to = self.register();
        self.tape.push(Instruction { operation, operands, to });
        self.computed.insert((operation, operands), to);
        self.history.push((operation, operands));
        to
    }

    fn sum(&mut self, terms: &[Expr]) -> Option<Register> {
        let first = terms.iter().position(|term| Size::after_minus(term).is_none()).unwrap_or(0);
        let mut total = self.expr(terms.get(first)?)?;
        for (_, term) in terms.iter().enumerate().filter(|(place, _)| *place != first) {
            let (operation, value) = match Size::after_minus(term) {
                Some(size) => (Operation::Subtract, self.size(&size)?),
                None => (Operation::Add, self.expr(term)?),
            };
            total = self.compute(operation, [total, value, 0]);
        }
        Some(total)
    }

    fn product(&mut self, factors: &[Expr]) -> Option<Register> {
        match Size::of(factors) {
            Some(size) => {
                let size = self.size(&size)?;
                Some(self.compute(Operation::Negate, [size, 0, 0]))
            }
            None => self.fraction(factors.iter()),
        }
    }

    fn size(&mut self, size: &Size) -> Option<Register> {
        match (&size.number, size.factors) {
            (None, [only]) => self.expr(only),
            (number, factors) => self.fraction(number.iter().chain(factors)),
        }
    }

    /// The product of the factors, those with a negative exponent below the bar.
    fn fraction<'e>(&mut self, factors: impl Iterator<Item = &'e Expr>) -> Option<Register> {
        let inverse = |factor: &Expr| match factor {
            Expr::Power(pair) => {
                let exponent = pair.1.as_number().filter(|exponent| **exponent < Rational::ZERO)?;
                Some(pair.0.clone().power(Expr::Number(-exponent.clone())))
            }
            _ => None,
        };
        let (mut above, mut below) = (None, None);
        for factor in factors {
            let inverse = inverse(factor);
            let value = self.expr(inverse.as_ref().unwrap_or(factor))?;
            let side = if inverse.is_some() { &mut below } else { &mut above };
            *side = Some(side.map_or(value, |other| self.compute(Operation::Multiply, [other, value, 0])));
        }
        let above = above.unwrap_or_else(|| self.constant(Rational::ONE.into()));
        Some(below.map_or(above, |below| self.compute(Operation::Divide, [above, below, 0])))
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Register> {
        let whole = |integer: &dashu::Integer| i32::try_from(integer.clone()).ok();
        if let Some(exponent) = exponent.as_number()
            && let Some(power) = whole(exponent.numerator())
            && let Ok(degree) = u32::try_from(exponent.denominator().clone())
            && power.unsigned_abs() <= 1024
            && degree <= 64
        {
            let mut value = self.expr(base)?;
            if degree > 1 {
                value = self.compute(Operation::Root(degree), [value, 0, 0]);
            }
            return Some(match power {
                1 => value,
                -1 => {
                    let one = self.constant(Rational::ONE.into());
                    self.compute(Operation::Divide, [one, value, 0])
                }
                2 => self.compute(Operation::Multiply, [value, value, 0]),
                power => self.compute(Operation::Power(power), [value, 0, 0]),
            });
        }
        let (base, exponent) = (self.expr(base)?, self.expr(exponent)?);
        Some(self.compute(Operation::Raise, [base, exponent, 0]))
    }

    /// The last piece, chosen against by each earlier one in turn from the back.
    fn piecewise(&mut self, piecewise: &Piecewise) -> Option<Register> {
        let mut pieces = piecewise.pieces.iter().rev();
        let (_, last) = pieces.next()?;
        let mut value = self.expr(last)?;
        for (until, piece) in pieces {
            let piece = self.expr(piece)?;
            let Some(until) = until else {
                value = piece;
                continue;
            };
            let beyond = self.difference(&piecewise.variable, until)?;
            value = self.compute(Operation::Select, [beyond, piece, value]);
        }
        Some(value)
    }
}

/// The size behind the minus of a product that is written with one.
struct Size<'e> {
    /// The number, unless it is 1.
    number: Option<Expr>,
    /// The other factors.
    factors: &'e [Expr],
}

impl<'e> Size<'e> {
    /// The size behind the minus of a term.
    fn after_minus(term: &'e Expr) -> Option<Self> {
        if let Expr::Product(factors) = term { Self::of(factors) } else { None }
    }

    /// The size behind the minus of a product.
    fn of(factors: &'e [Expr]) -> Option<Self> {
        let (first, factors) = factors.split_first()?;
        let size = -first.as_number().filter(|number| **number < Rational::ZERO)?.clone();
        Some(Self { number: (!size.is_one()).then_some(Expr::Number(size)), factors })
    }
}
