//! A tape run backwards, for the derivatives of what it computed.
//! (Reverse accumulation: Griewank and Walther, Evaluating Derivatives, chapter 3.)

use super::tape::{Instruction, Operation};

/// Runs instructions backwards, as they come: the last one first. Before, a register's share is the derivative by it of some number,
/// as far as what comes after them tells; after, what they make of the register is in it too. Values are those of the run forwards.
pub(crate) fn run_back<'t>(backwards: impl Iterator<Item = &'t Instruction>, values: &[f64], shares: &mut [f64]) {
    for instruction in backwards {
        pass_back(instruction, values, shares);
    }
}

/// Gives each operand of an instruction its part in the derivative by what the instruction computes.
fn pass_back(instruction: &Instruction, values: &[f64], shares: &mut [f64]) {
    let [a, b, c] = instruction.operands;
    let (a, b, c, to) = (a as usize, b as usize, c as usize, instruction.to as usize);
    let share = shares[to];
    if share == 0.0 {
        return;
    }
    match instruction.operation {
        Operation::Add => {
            shares[a] += share;
            shares[b] += share;
        }
        Operation::Subtract => {
            shares[a] += share;
            shares[b] -= share;
        }
        Operation::Multiply => {
            shares[a] += share * values[b];
            shares[b] += share * values[a];
        }
        Operation::Divide => {
            shares[a] += share / values[b];
            shares[b] -= share * values[to] / values[b];
        }
        Operation::Negate => shares[a] -= share,
        Operation::Power(exponent) => {
            shares[a] += share * f64::from(exponent) * libm::pow(values[a], f64::from(exponent) - 1.0);
        }
        Operation::Root(degree) => shares[a] += share * values[to] / (f64::from(degree) * values[a]),
        Operation::Raise => {
            shares[a] += share * values[b] * libm::pow(values[a], values[b] - 1.0);
            shares[b] += share * values[to] * libm::log(values[a]);
        }
        Operation::Apply(function) => shares[a] += share * function.slope_at(values[a]),
        Operation::Angle => {
            let square = values[a] * values[a] + values[b] * values[b];
            shares[a] += share * values[b] / square;
            shares[b] -= share * values[a] / square;
        }
        Operation::Select => shares[if values[a] <= 0.0 { b } else { c }] += share,
        Operation::Copy => shares[a] += share,
    }
}
