//! Regimes: starts to slide or not, catches up or not. One program each, with the conditions under which it holds.

use super::super::number::real::Real;
use super::super::{Bounded, Exact, Outcome, Program};
use super::workspace::{Precision, Workspaces};

/// Programs for alternative regimes of one problem, with the same inputs. Each one's conditions say when it holds.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// The regimes, in the order in which they are tried.
    pub leaves: Vec<Program>,
}

/// The memory of a tree's replays: one for each leaf, so that one can still be asked why it does not hold.
#[derive(Clone, Debug, Default)]
pub struct TreeWorkspace {
    precision: Precision,
    leaves: Vec<Workspaces>,
    tried: usize,
}

impl TreeWorkspace {
    /// Memory for replays of that precision.
    #[must_use]
    pub fn new(precision: Precision) -> Self {
        Self { precision, ..Self::default() }
    }
}

impl Tree {
    /// Tries the leaves in order until one has a solution all of whose conditions hold; its position, if there is one.
    pub fn solve(&self, inputs: &[Exact], workspace: &mut TreeWorkspace) -> Option<usize> {
        let bounded: Vec<Bounded> = inputs.iter().map(Bounded::from_exact).collect();
        self.solve_from(&bounded, &|| inputs.to_vec(), workspace)
    }

    /// The same from floating-point inputs with bounds. `exact` gives the inputs without rounding, and is asked only where
    /// floating point leaves something open.
    pub fn solve_from(
        &self,
        inputs: &[Bounded],
        exact: &dyn Fn() -> Vec<Exact>,
        workspace: &mut TreeWorkspace,
    ) -> Option<usize> {
        self.first(workspace, &|leaf, memory| leaf.solve_from(inputs, exact, memory).survivors())
    }

    /// The same for a limiting case, by [`Program::solve_limit`].
    pub fn solve_limit(&self, inputs: &[Bounded], workspace: &mut TreeWorkspace) -> Option<usize> {
        self.first(workspace, &|leaf, memory| leaf.solve_limit(inputs, memory).survivors())
    }

    /// The first leaf with a solution.
    fn first(
        &self,
        workspace: &mut TreeWorkspace,
        solutions: &dyn Fn(&Program, &mut Workspaces) -> usize,
    ) -> Option<usize> {
        let precision = workspace.precision;
        workspace.leaves.resize_with(self.leaves.len(), || Workspaces::new(precision));
        for (place, (leaf, memory)) in self.leaves.iter().zip(&mut workspace.leaves).enumerate() {
            workspace.tried = place + 1;
            if solutions(leaf, memory) > 0 {
                return Some(place);
            }
        }
        None
    }

    /// The result of the last [`Tree::solve`] for a leaf; `None` of one that it did not try.
    #[must_use]
    pub fn outcome<'a>(&'a self, leaf: usize, workspace: &'a TreeWorkspace) -> Option<Outcome<'a, Bounded>> {
        let memory = workspace.leaves.get(leaf).filter(|_| leaf < workspace.tried)?;
        Some(Outcome { program: self.leaves.get(leaf)?, workspace: &memory.fast, exact: memory.replayed })
    }
}
