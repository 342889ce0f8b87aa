//! # Linear
//!
//! *Closes:* k equations that are linear in k unknowns together, k at least 2.
//!
//! *On paper:* multiply one equation by a factor and add it to another so that an unknown drops out, until one is left;
//! the unknown that is asked for is the one that stays.
//!
//! *Refuses:* products of unknowns; equations that say the same twice.

use super::block::Block;
use super::closing::{Closing, Refusal};
use super::elimination::eliminate;
use crate::{Closed, Root};

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    if block.unknowns.len() < 2 {
        return Err(Refusal::NotApplicable);
    }
    let residuals = block.residuals().ok_or(Refusal::NotApplicable)?;
    let equations: Vec<_> = block.equations.iter().copied().zip(residuals).collect();
    let eliminated = eliminate(block, &equations, &block.unknowns)?;
    let values = eliminated.values.into_iter().map(|(unknown, value)| (unknown, Closed::Formula(value))).collect();
    Ok(Closing { unknowns: block.unknowns.clone(), moves: eliminated.moves, roots: vec![Root { values }] })
}
