//! The results of each tactic on each block, kept: the forms of a problem, the ways in which its scene can go and the
//! audits share most of their blocks, and algebra is dear.

use std::collections::BTreeMap;

use momentous_expr::Symbol;

use super::block::Block;
use super::closing::Refusal;
use crate::{Statement, Step, Tactic};

/// A tactic, the positions of the equations on which it was tried, and their unknowns.
type Tried = (Tactic, Vec<usize>, Vec<Symbol>);

/// These equations, as they stood, and what came of it.
type Attempt = (Vec<Statement>, Result<Step, Refusal>);

/// The results of tactics on the blocks of systems in which the same symbols are positive, and the same values known
/// beforehand.
#[derive(Clone, Debug, Default)]
pub struct Attempts(BTreeMap<Tried, Vec<Attempt>>);

impl Attempts {
    /// The result of a tactic on a block; found by `attempt` where it was not tried before on the same equations.
    pub(super) fn made(
        &mut self,
        block: &Block,
        tactic: Tactic,
        attempt: impl FnOnce() -> Result<Step, Refusal>,
    ) -> Result<Step, Refusal> {
        let stated = block.equations.iter().filter_map(|place| block.system.equations.get(*place));
        let stated = stated.map(|equation| &equation.statement);
        let attempts = self.0.entry((tactic, block.equations.clone(), block.unknowns.clone())).or_default();
        // What stands at a position can differ from system to system.
        if let Some((_, outcome)) = attempts.iter().find(|(tried, _)| tried.iter().eq(stated.clone())) {
            return outcome.clone();
        }
        let outcome = attempt();
        attempts.push((stated.cloned().collect(), outcome.clone()));
        outcome
    }
}
