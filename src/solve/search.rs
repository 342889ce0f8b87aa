//! The cheapest sets of equations that determine what is wanted, best first.

use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use super::bits::Bits;
use super::structure::{Row, Structure};

/// How many states are kept before the search gives up. Far more than the bank needs; it bounds a hostile file.
const BUDGET: usize = 40_000;

/// A best-first search (A*) from what is wanted: each unknown that is still open takes one equation, which may open others.
///
/// The estimate of what remains is the sum over the open unknowns of the cheapest equation that contains each; it never
/// exceeds the true cost, since each open unknown needs an equation of its own.
pub(super) struct Search<'a> {
    structure: &'a Structure,
    cheapest: Vec<u64>,
    heap: BinaryHeap<Reverse<State>>,
    seen: BTreeSet<(Bits, Bits)>,
    forbidden: Vec<Bits>,
    left: usize,
}

/// Ordered by what it will cost at least, then by how much is open, then by the equations: the earlier first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct State {
    estimate: u64,
    open_count: usize,
    rows: Vec<usize>,
    chosen: Bits,
    open: Bits,
    covered: Bits,
    cost: u64,
}

impl<'a> Search<'a> {
    /// A search for sets that determine the columns `wanted`.
    pub(super) fn new(structure: &'a Structure, wanted: &Bits) -> Self {
        let columns = 0..structure.unknowns.len();
        let containing = |column: usize| structure.rows.iter().filter(move |row| row.finds.contains(column));
        let cheapest =
            columns.map(|column| containing(column).map(|row| u64::from(row.cost)).min().unwrap_or(0)).collect();
        let mut search = Self {
            structure,
            cheapest,
            heap: BinaryHeap::new(),
            seen: BTreeSet::new(),
            forbidden: Vec::new(),
            left: BUDGET,
        };
        let chosen = Bits::empty(structure.rows.len());
        search.push(Vec::new(), chosen, wanted.clone(), wanted.clone(), 0);
        search
    }

    /// No set that contains all of these rows is worth looking at: they depend on each other.
    pub(super) fn forbid(&mut self, rows: Bits) {
        self.forbidden.push(rows);
    }

    /// Whether states were left out because there were too many.
    pub(super) fn is_exhausted(&self) -> bool {
        self.left == 0
    }

    /// All sets of the next cost, each as ascending rows; empty when there are no more.
    pub(super) fn next_batch(&mut self) -> BTreeSet<Vec<usize>> {
        let mut batch = BTreeSet::new();
        let mut cost = None;
        while let Some(Reverse(state)) = self.heap.pop() {
            if cost.is_some_and(|cost| state.estimate > cost) {
                self.heap.push(Reverse(state));
                break;
            }
            if self.forbidden.iter().any(|rows| state.chosen.covers(rows)) {
                continue;
            }
            if state.open.is_empty() {
                cost = Some(state.cost);
                batch.insert(state.rows);
            } else {
                self.expand(&state);
            }
        }
        batch
    }

    /// Gives the open unknown with the fewest equations each of them in turn. Where one has no other unknown and is as
    /// cheap as any, those that have others are left out: any set with one of them can exchange it for the direct one.
    fn expand(&mut self, state: &State) {
        let structure = self.structure;
        let options = |column: usize| {
            let direct = |row: &Row| u64::from(row.cost) == self.cheapest[column] && row.unknowns.len() == 1;
            let finds = move |row: &Row| row.finds.contains(column);
            let any_direct = structure.rows.iter().any(|row| finds(row) && direct(row));
            let rows = structure.rows.iter().enumerate();
            rows.filter(move |(place, row)| {
                finds(row) && (!any_direct || row.unknowns.len() == 1) && !state.chosen.contains(*place)
            })
        };
        let Some(column) = state.open.iter().min_by_key(|column| options(*column).count()) else { return };
        for (row, content) in options(column) {
            let mut chosen = state.chosen.clone();
            chosen.insert(row);
            let mut rows = state.rows.clone();
            rows.insert(rows.partition_point(|other| *other < row), row);
            let mut fresh = content.unknowns.clone();
            fresh.subtract(&state.covered);
            let mut covered = state.covered.clone();
            covered.join(&fresh);
            let mut open = state.open.clone();
            open.join(&fresh);
            open.remove(column);
            self.push(rows, chosen, open, covered, state.cost + u64::from(content.cost));
        }
    }

    fn push(&mut self, rows: Vec<usize>, chosen: Bits, open: Bits, covered: Bits, cost: u64) {
        if self.left > 0 && self.seen.insert((chosen.clone(), open.clone())) {
            self.left -= 1;
            let estimate = cost + open.iter().map(|column| self.cheapest[column]).sum::<u64>();
            self.heap.push(Reverse(State { estimate, open_count: open.len(), rows, chosen, open, covered, cost }));
        }
    }
}
