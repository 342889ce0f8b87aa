//! The tactics that close a block of equations, one file each.

mod attempts;
mod block;
mod bracketed;
mod closing;
mod count;
mod elimination;
mod inverse;
mod isolate;
mod linear;
mod polar;
mod quadratic;
mod tangent;
mod tear;
mod tidy;

use super::super::{Closed, Step, Tactic};
use closing::Closing;

pub(crate) use attempts::Attempts;
pub(super) use block::Block;
pub(super) use closing::Refusal;

/// A tactic: what it makes of a block, or why it does not serve.
type Try = fn(&Block) -> Result<Closing, Refusal>;

/// The tactics in the order in which they are tried: what a student would try first, stands first.
/// A new tactic is a file beside this one and a line in this list.
const TACTICS: &[(Tactic, Try)] = &[
    (Tactic::Isolate, isolate::close),         // one unknown, brought to one side
    (Tactic::Linear, linear::close),           // k linear equations: add multiples until one unknown is left
    (Tactic::Tear, tear::close),               // all but one written in the last, and substituted
    (Tactic::Quadratic, quadratic::close),     // second degree: both roots
    (Tactic::Tangent, tangent::close),         // sine and cosine of one angle: its tangent
    (Tactic::Polar, polar::close),             // magnitude and angle from two components
    (Tactic::Count, count::close),             // the first integer that satisfies a condition
    (Tactic::BracketedRoot, bracketed::close), // no formula: between bounds
];

/// The step made by the first tactic that closes the block.
pub(super) fn close(block: &Block, attempts: &mut Attempts) -> Result<Step, Refusal> {
    for (tactic, closes) in TACTICS {
        match attempts.made(block, *tactic, || attempt(block, *tactic, *closes)) {
            Err(Refusal::NotApplicable) => {}
            decided => return decided,
        }
    }
    Err(Refusal::NotApplicable)
}

/// Whether a step divides by what is zero for the values that are known beforehand.
pub(super) fn divides_by_nothing(block: &Block, step: &Step) -> bool {
    let values = step.roots.iter().flat_map(|root| &root.values);
    values.into_iter().any(|(_, value)| matches!(value, Closed::Formula(term) if block.divides_by_nothing(term)))
}

/// The step by which the unknown of a block of one is brought to one side.
pub(super) fn isolate(block: &Block, attempts: &mut Attempts) -> Result<Step, Refusal> {
    attempts.made(block, Tactic::Isolate, || attempt(block, Tactic::Isolate, isolate::close))
}

fn attempt(block: &Block, tactic: Tactic, closes: Try) -> Result<Step, Refusal> {
    let Closing { unknowns, moves, mut roots } = closes(block)?;
    // What holds only where a mass is zero holds for no body: such equations are one and the same where a mass is not.
    let had_roots = !roots.is_empty();
    roots.retain(|root| !root.values.iter().any(|(symbol, value)| block.positive(*symbol) && is_nothing(value)));
    if had_roots && roots.is_empty() {
        return Err(Refusal::Dependent);
    }
    Ok(Step { equations: block.equations.clone(), unknowns, tactic, moves, roots })
}

fn is_nothing(value: &Closed) -> bool {
    matches!(value, Closed::Formula(term) if term.is_zero())
}
