//! # Count
//!
//! *Closes:* "n is the first integer for which ...".
//!
//! *On paper:* the condition, tried at the last integer that breaks it and at the first that satisfies it.

use super::block::Block;
use super::closing::{Closing, Refusal};
use crate::{Closed, Move, Root, Statement};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let [equation] = block.equations.as_slice() else { return Err(Refusal::NotApplicable) };
    let stated = block.system.equations.get(*equation).map(|equation| &equation.statement);
    let Some(Statement::FirstInteger { unknown, from, left, relation, right }) = stated else {
        return Err(Refusal::NotApplicable);
    };
    if block.unknowns != [*unknown] {
        return Err(Refusal::NotApplicable);
    }
    let counted = Closed::FirstInteger { from: *from, left: left.clone(), relation: *relation, right: right.clone() };
    Ok(Closing {
        unknowns: vec![*unknown],
        moves: vec![Move::Count { unknown: *unknown }],
        roots: vec![Root { values: vec![(*unknown, counted)] }],
    })
}
