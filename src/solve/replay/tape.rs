//! The tape: straight-line instructions over registers, and their execution with any kind of number.

use std::ops::Range;

use momentous_expr::Function;

use super::super::number::real::{Real, Sign};

/// The place in which a number is kept.
pub(crate) type Register = u32;

/// A stretch of the tape.
pub(super) type Stretch = Range<usize>;

/// The operation of an instruction on its operands a, b and c.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Operation {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a b
    Multiply,
    /// a / b
    Divide,
    /// -a
    Negate,
    /// a to an integer power
    Power(i32),
    /// A root of a
    Root(u32),
    /// a to the power b
    Raise,
    /// A function of a
    Apply(Function),
    /// The angle of the point (b, a)
    Angle,
    /// b where a is at most zero, else c
    Select,
    /// a
    Copy,
}

/// One instruction; operands that it does not need are register 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Instruction {
    pub(super) operation: Operation,
    pub(crate) operands: [Register; 3],
    pub(crate) to: Register,
}

impl Instruction {
    /// Computes one register from others. Registers are below the length: the compiler of the tape made them.
    #[inline]
    fn execute<R: Real>(&self, registers: &mut [R]) {
        let [a, b, c] = &self.operands;
        let at = |register: &Register| &registers[*register as usize];
        let (a, b, c) = (at(a), || at(b), || at(c));
        let value = match self.operation {
            Operation::Add => a.add(b()),
            Operation::Subtract => a.sub(b()),
            Operation::Multiply => a.mul(b()),
            Operation::Divide => a.div(b()),
            Operation::Negate => a.neg(),
            Operation::Power(exponent) => a.powi(exponent),
            Operation::Root(degree) => a.root(degree),
            Operation::Raise => a.raise(b()),
            Operation::Apply(function) => a.apply(function),
            Operation::Angle => a.atan2(b()),
            Operation::Select => match a.sign() {
                Sign::Negative | Sign::Zero => b().clone(),
                Sign::Positive => c().clone(),
                Sign::Unsure => either(b(), c()),
                Sign::NotReal => R::not_real(),
            },
            Operation::Copy => a.clone(),
        };
        registers[self.to as usize] = value;
    }
}

/// A number that covers both, where it is not known which holds.
fn either<R: Real>(one: &R, other: &R) -> R {
    match (one.is_real(), other.is_real()) {
        (true, true) => one.hull(other),
        (true, false) => one.clone(),
        (false, _) => other.clone(),
    }
}

/// Runs a stretch of the tape.
#[inline]
pub(crate) fn run<R: Real>(tape: &[Instruction], stretch: &Stretch, registers: &mut [R]) {
    for instruction in &tape[stretch.clone()] {
        instruction.execute(registers);
    }
}
