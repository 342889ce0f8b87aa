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

/// What a leaf gives.
struct Solved {
    solutions: usize,
    /// Whether every value has a bound on its error.
    is_certain: bool,
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
        self.first(workspace, &|leaf, memory| {
            let outcome = leaf.solve_from(inputs, exact, memory);
            // Where there is one leaf alone, nothing is to be chosen.
            let is_certain = self.leaves.len() < 2 || outcome.values().all(|(_, value)| value.error.is_finite());
            Solved { solutions: outcome.survivors(), is_certain }
        })
    }

    /// The leaves behind the one that was taken which have solutions from the same inputs, too.
    pub fn solve_others(
        &self,
        taken: usize,
        inputs: &[Bounded],
        exact: &dyn Fn() -> Vec<Exact>,
        workspace: &mut TreeWorkspace,
    ) -> Vec<usize> {
        let behind = self.leaves.iter().zip(&mut workspace.leaves).enumerate().skip(taken + 1);
        let others = behind.filter_map(|(place, (leaf, memory))| {
            let outcome = leaf.solve_from(inputs, exact, memory);
            let is_certain = outcome.survivors() > 0 && outcome.values().all(|(_, value)| value.error.is_finite());
            is_certain.then_some(place)
        });
        let others = others.collect();
        workspace.tried = self.leaves.len();
        others
    }

    /// The same for a limiting case, by [`Program::solve_limit`].
    pub fn solve_limit(&self, inputs: &[Bounded], workspace: &mut TreeWorkspace) -> Option<usize> {
        self.first(workspace, &|leaf, memory| Solved {
            solutions: leaf.solve_limit(inputs, memory).survivors(),
            is_certain: true,
        })
    }

    /// The first leaf with a solution; one in which something may be divided by zero only where no other has any.
    fn first(
        &self,
        workspace: &mut TreeWorkspace,
        solve: &dyn Fn(&Program, &mut Workspaces) -> Solved,
    ) -> Option<usize> {
        let precision = workspace.precision;
        workspace.leaves.resize_with(self.leaves.len(), || Workspaces::new(precision));
        let mut uncertain = None;
        for (place, (leaf, memory)) in self.leaves.iter().zip(&mut workspace.leaves).enumerate() {
            workspace.tried = place + 1;
            match solve(leaf, memory) {
                Solved { solutions: 0, .. } => {}
                Solved { is_certain: true, .. } => return Some(place),
                Solved { is_certain: false, .. } => uncertain = uncertain.or(Some(place)),
            }
        }
        uncertain
    }

    /// Rules out those solutions of a leaf that have a reason, unless all have one: in the order of [`Outcome::value_in`].
    pub fn rule_out(&self, leaf: usize, reasons: &[Option<usize>], workspace: &mut TreeWorkspace) {
        if let (Some(program), Some(memory)) = (self.leaves.get(leaf), workspace.leaves.get_mut(leaf)) {
            memory.fast.rule_out(program, reasons);
        }
    }

    /// The result of the last [`Tree::solve`] for a leaf; `None` of one that it did not try.
    #[must_use]
    pub fn outcome<'a>(&'a self, leaf: usize, workspace: &'a TreeWorkspace) -> Option<Outcome<'a, Bounded>> {
        let memory = workspace.leaves.get(leaf).filter(|_| leaf < workspace.tried)?;
        Some(Outcome { program: self.leaves.get(leaf)?, workspace: &memory.fast, exact: memory.replayed })
    }
}
