//! The graph of a force that the sheet prints with its numbers.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;

/// A force that a sheet tells by its graph.
#[derive(Clone, Debug)]
pub struct PrintedGraph {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The name of the force.
    pub called: String,
    /// Time and force of each point: zero, a quantity, or a multiple of one.
    pub points: Vec<[Expr; 2]>,
    /// The place at which the author says so.
    pub path: Path,
}

impl PrintedGraph {
    /// The quantities whose values it prints.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> {
        self.points.iter().flatten().flat_map(Expr::symbols)
    }
}
