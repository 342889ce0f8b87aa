//! The tactics that close a block of equations, one file each.

mod attempts;
mod bracketed;
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

use crate::expr::{Expr, Symbol};

use super::super::{Closed, Move, Root, Statement, Step, System, Tactic};

pub(in crate::solve) use attempts::Attempts;

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

/// An irreducible block: as many equations as unknowns, and all other symbols known.
#[derive(Clone, Debug)]
pub(super) struct Block<'a> {
    /// The system.
    pub(in crate::solve) system: &'a System,
    /// Positions of the equations.
    pub(in crate::solve) equations: Vec<usize>,
    /// The unknowns; those that are asked for first.
    pub(in crate::solve) unknowns: Vec<Symbol>,
}

/// What closes a block.
#[derive(Clone, Debug)]
pub(super) struct Closing {
    /// The unknowns in the order in which they are found.
    unknowns: Vec<Symbol>,
    /// The moves on paper.
    moves: Vec<Move>,
    /// The roots.
    roots: Vec<Root>,
}

/// Every value of one unknown, and the moves that give them.
struct Found {
    moves: Vec<Move>,
    values: Vec<Expr>,
}

impl Found {
    /// What closes a block of this unknown alone.
    fn closing(self, unknown: Symbol) -> Closing {
        let root = |value| Root { values: vec![(unknown, Closed::Formula(value))] };
        Closing { unknowns: vec![unknown], moves: self.moves, roots: self.values.into_iter().map(root).collect() }
    }
}

/// Why a tactic does not close a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Refusal {
    /// It is not for blocks of this kind.
    NotApplicable,
    /// The equations say the same twice, so that they do not determine the unknowns.
    Dependent,
    /// The unknowns drop out, and what is left is false.
    Contradiction,
}

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

impl Block<'_> {
    /// The only equation and unknown of a block of one; position, left side, right side, unknown.
    fn single(&self) -> Option<(usize, &Expr, &Expr, Symbol)> {
        let ([equation], [unknown]) = (self.equations.as_slice(), self.unknowns.as_slice()) else { return None };
        let (left, right) = self.sides(*equation)?;
        Some((*equation, left, right, *unknown))
    }

    /// The two sides of an equation that has two sides.
    fn sides(&self, equation: usize) -> Option<(&Expr, &Expr)> {
        match &self.system.equations.get(equation)?.statement {
            Statement::Equal { left, right } => Some((left, right)),
            Statement::FirstInteger { .. } => None,
        }
    }

    /// Left sides minus right sides, in the order of the equations; `None` where one is a count.
    fn residuals(&self) -> Option<Vec<Expr>> {
        let residual = |equation: &usize| self.sides(*equation).map(|(left, right)| tidy::difference(left, right));
        self.equations.iter().map(residual).collect()
    }

    fn positive(&self, symbol: Symbol) -> bool {
        self.system.positive.contains(&symbol)
    }
}
