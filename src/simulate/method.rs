//! The interface of every numerical method: a name, and a run within a budget that ends in a trajectory or in a named refusal.

use super::budget::Budget;
use super::refusal::Refusal;
use super::trajectory::Trajectory;
use super::world::World;

/// A numerical method for worlds of `D` dimensions.
pub trait Method<const D: usize>: Send + Sync {
    /// Its name, as tables print it.
    fn name(&self) -> &'static str;

    /// Runs a world from time 0 until the budget ends.
    ///
    /// # Errors
    /// The scene is one that the method cannot treat, by name.
    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal>;
}
