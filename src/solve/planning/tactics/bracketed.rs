//! # Bracketed root
//!
//! *Closes:* one equation in one unknown for which there is no formula.
//!
//! *On paper:* sign changes are found, from zero upwards, and narrowed down; the conditions of the system choose among them.

use momentous_expr::{Expr, Function, Symbol};

use super::block::Block;
use super::closing::{Closing, Refusal};
use super::isolate::dropped_out;
use super::tidy::difference;
use crate::{Closed, Move, Root};

/// So many roots are followed at most. Of a motion that swings there are more; to see that a value is not the only one, two are enough.
const MOST_ROOTS: usize = 4;

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (_, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let residual = difference(left, right);
    if !residual.simplify().contains(unknown) {
        return Err(dropped_out(&residual));
    }
    let repeats = is_angle(&residual, unknown);
    let root = |index| {
        let value = Closed::BracketedRoot { residual: residual.clone(), index, repeats };
        Root { values: vec![(unknown, value)] }
    };
    Ok(Closing {
        unknowns: vec![unknown],
        moves: vec![Move::Numeric { unknown }],
        roots: (0..MOST_ROOTS).map(root).collect(),
    })
}

/// Whether an unknown stands only as an angle of which a turn more is the same: in sines, cosines and tangents, by itself.
fn is_angle(term: &Expr, unknown: Symbol) -> bool {
    match term {
        Expr::Symbol(symbol) => *symbol != unknown,
        Expr::Apply(Function::Sin | Function::Cos | Function::Tan, angle) => {
            let alone = |part: &Expr| matches!(part, Expr::Symbol(symbol) if *symbol == unknown);
            let is_free = |part: &Expr| match part {
                Expr::Sum(parts) => parts.iter().all(|part| alone(part) || !part.contains(unknown)),
                part => alone(part) || !part.contains(unknown),
            };
            angle.iter().all(is_free)
        }
        other => other.children().all(|part| is_angle(part, unknown)),
    }
}
