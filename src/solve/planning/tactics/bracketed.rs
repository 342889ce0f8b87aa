//! # Bracketed root
//!
//! *Closes:* one equation in one unknown for which there is no formula.
//!
//! *On paper:* a sign change is found and narrowed down; the first one from zero upwards is taken.

use super::block::Block;
use super::closing::{Closing, Refusal};
use super::isolate::dropped_out;
use super::tidy::difference;
use crate::{Closed, Move, Root};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (_, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let residual = difference(left, right);
    if !residual.simplify().contains(unknown) {
        return Err(dropped_out(&residual));
    }
    Ok(Closing {
        unknowns: vec![unknown],
        moves: vec![Move::Numeric { unknown }],
        roots: vec![Root { values: vec![(unknown, Closed::BracketedRoot { residual, index: 0 })] }],
    })
}
