//! The cheapest sets of equations that determine what is wanted, best first.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::super::structure::basis::Basis;
use super::super::structure::bits::Bits;
use super::super::structure::incidence::Structure;
use super::choice::Choice;

/// The number of sets that are looked at before the search gives up. Far more than the bank needs; it bounds a hostile file.
const BUDGET: usize = 40_000;

/// The number of numbers that are kept of what was found on the way. Far more than the bank needs; beyond, they are found again.
const ROOM: usize = 4_000_000;

/// A best-first search (A*) over sets of unknowns that are to be found together. It begins with what is wanted. As long as
/// the equations that contain no other unknowns leave something open, one more equation must speak of what they leave
/// open, and brings its own unknowns. Where they leave nothing open, each choice of independent ones is a set to try.
///
/// Of the equations that could come next, each is tried without those before it: a set is come to in one way only.
///
/// What is independent, and what is left open, is judged by derivatives at sampled values: two equations that say the same
/// do not count twice. The estimate of what a set of unknowns costs never exceeds the true cost, since each unknown
/// needs an equation of its own.
pub(super) struct Search<'a> {
    structure: &'a Structure,
    /// The derivatives of each row.
    gradients: &'a [Vec<f64>],
    /// For each column the cost of the cheapest row that finds it.
    cheapest: Vec<u64>,
    /// The cost of the cheapest row.
    least: u64,
    choice: Choice<'a>,
    /// For each column the rows that contain it.
    containing: Vec<Bits>,
    /// The entries yet to be looked at, by their estimate, and by when they were found.
    open: BTreeMap<(u64, usize), Entry>,
    /// The number of times that something was put there.
    arrivals: usize,
    forbidden: Vec<Bits>,
    left: usize,
    /// How many more numbers may be kept with what is yet to be looked at.
    room: usize,
}

/// An entry that the search has yet to look at.
#[derive(Clone, Debug)]
enum Entry {
    /// Rows that determine their unknowns.
    Rows(Bits),
    /// Unknowns, to be widened.
    Columns(Within),
    /// Unknowns that the rows within determine, to be given rows of that cost.
    Determined(Bits),
}

/// Unknowns that are to be found together.
#[derive(Clone, Debug)]
struct Within {
    columns: Bits,
    /// Rows that are not to come within: what they lead to is looked at elsewhere.
    without: Bits,
    /// The restriction to a narrower set of columns, where that was kept.
    narrower: Option<Rc<Restriction>>,
}

/// The rows that lie within some columns.
#[derive(Clone, Debug)]
struct Restriction {
    rows: Bits,
    basis: Basis,
}

impl<'a> Search<'a> {
    /// A search for sets that determine the columns `wanted`; `gradients` are the derivatives of each row.
    pub(crate) fn new(structure: &'a Structure, gradients: &'a [Vec<f64>], wanted: &Bits) -> Self {
        let columns = 0..structure.unknowns.len();
        let cost = |row: &usize| u64::from(structure.rows[*row].cost);
        let finding = |column| (0..structure.rows.len()).filter(move |row| structure.rows[*row].finds.contains(column));
        let cheapest: Vec<u64> =
            columns.map(|column| finding(column).map(|row| cost(&row)).min().unwrap_or(0)).collect();
        let mut containing = vec![Bits::empty(structure.rows.len()); structure.unknowns.len()];
        for (place, row) in structure.rows.iter().enumerate() {
            row.unknowns.iter().for_each(|column| containing[column].insert(place));
        }
        let mut search = Self {
            structure,
            gradients,
            least: cheapest.iter().copied().min().unwrap_or(0),
            choice: Choice::new(structure, gradients, &cheapest),
            cheapest,
            containing,
            open: BTreeMap::new(),
            arrivals: 0,
            forbidden: Vec::new(),
            left: BUDGET,
            room: ROOM,
        };
        let wanted = Within { columns: wanted.clone(), without: Bits::empty(structure.rows.len()), narrower: None };
        search.widen(search.estimate(&wanted.columns), wanted);
        search
    }

    /// No set that contains all of these rows is worth looking at: they depend on each other.
    pub(super) fn forbid(&mut self, rows: Bits) {
        self.forbidden.push(rows);
    }

    /// All sets of the next cost, each as ascending rows; empty when there are no more.
    pub(super) fn next_batch(&mut self) -> BTreeSet<Vec<usize>> {
        let mut batch = BTreeSet::new();
        let mut cost = None;
        while let Some(first) = self.open.first_entry() {
            let (estimate, _) = *first.key();
            if cost.is_some_and(|cost| estimate > cost) {
                break;
            }
            match first.remove() {
                Entry::Columns(within) => self.expand(estimate, within),
                Entry::Determined(columns) => self.choose(estimate, columns),
                Entry::Rows(rows) if self.forbidden.iter().any(|forbidden| rows.covers(forbidden)) => {}
                Entry::Rows(rows) => {
                    cost = Some(estimate);
                    batch.insert(rows.iter().collect());
                }
            }
        }
        batch
    }

    /// Widens a set of columns by the unknowns of each row of which one must be taken.
    fn expand(&mut self, estimate: u64, within: Within) {
        let Within { mut columns, mut without, narrower } = within;
        let none = || Restriction { rows: Bits::empty(self.structure.rows.len()), basis: Basis::default() };
        let mut said = narrower.map_or_else(none, Rc::unwrap_or_clone);
        let unknowns = |row: usize| &self.structure.rows[row].unknowns;
        let mut widened = false;
        let (determined, next) = loop {
            let beyond = self.beyond(&columns, &without, &mut said);
            // Of the ways in which the columns can still change together, some row must stop each: the one with the fewest
            // rows is followed. Where they cannot change, what is dearer may still come with any row.
            let stops = |free: usize| {
                let mut stops = self.containing(said.basis.together(free));
                stops.keep(&beyond);
                stops
            };
            let next = said.basis.free(&columns).map(stops).min_by_key(Bits::len);
            match &next {
                // Of one there is nothing to choose.
                Some(only) if only.len() == 1 => only.iter().for_each(|row| columns.join(unknowns(row))),
                _ => break (next.is_none(), next.unwrap_or(beyond)),
            }
            widened = true;
        };
        let free = columns.len() - said.basis.len();
        let narrower = self.keep(said);
        if widened {
            let estimate = self.estimate(&columns) + if determined { 0 } else { self.least };
            self.widen(estimate, Within { columns, without, narrower });
            return;
        }
        let estimate_here = self.estimate(&columns);
        let wider = |row: usize| {
            let mut new = unknowns(row).clone();
            new.subtract(&columns);
            let mut more = columns.clone();
            more.join(&new);
            (estimate_here + self.at_least(free, &new, &more), row, more)
        };
        let mut next: Vec<(u64, usize, Bits)> = next.iter().map(wider).collect();
        // The dearest first, so that those that are looked at first are without most others.
        next.sort_by(|a, b| b.cmp(a));
        for (estimate, row, columns) in next {
            self.widen(estimate, Within { columns, without: without.clone(), narrower: narrower.clone() });
            without.insert(row);
        }
        if determined {
            self.put(estimate, Entry::Determined(columns));
        }
    }

    /// The least cost of finding `new` columns, where narrower columns leave so many of theirs free, and all together
    /// are `more`: where too few rows come within, one more column must.
    fn at_least(&self, free: usize, new: &Bits, more: &Bits) -> u64 {
        let needed = free + new.len();
        let covered = self.containing(new.iter());
        let covered =
            covered.iter().filter(|row| more.covers(&self.structure.rows[*row].unknowns)).take(needed).count();
        self.estimate(new) + if covered < needed { self.least } else { 0 }
    }

    /// The rows that contain some of the columns and others, and may come within. What lies within is added to what is said.
    fn beyond(&self, columns: &Bits, without: &Bits, said: &mut Restriction) -> Bits {
        let missing = |row: usize| {
            let mut missing = self.structure.rows[row].unknowns.clone();
            missing.subtract(columns);
            missing
        };
        let never: Vec<Bits> = without.iter().map(missing).collect();
        let mut beyond = Bits::empty(self.structure.rows.len());
        for place in self.containing(columns.iter()).iter() {
            let unknowns = &self.structure.rows[place].unknowns;
            if !columns.covers(unknowns) {
                if !never.iter().any(|never| unknowns.covers(never)) {
                    beyond.insert(place);
                }
            } else if !said.rows.contains(place) {
                said.rows.insert(place);
                said.basis.add(&self.gradients[place]);
            }
        }
        beyond
    }

    /// The rows that contain any of these columns.
    fn containing(&self, columns: impl Iterator<Item = usize>) -> Bits {
        let mut rows = Bits::empty(self.structure.rows.len());
        columns.for_each(|column| rows.join(&self.containing[column]));
        rows
    }

    /// Whether any of these rows lies within the columns.
    fn has_any(&self, columns: &Bits, rows: &Bits) -> bool {
        rows.iter().any(|row| columns.covers(&self.structure.rows[row].unknowns))
    }

    /// Shares what rows say with the wider sets, as long as there is room.
    fn keep(&mut self, said: Restriction) -> Option<Rc<Restriction>> {
        let size = said.basis.size();
        let fits = size <= self.room;
        self.room -= if fits { size } else { 0 };
        fits.then(|| Rc::new(said))
    }

    /// Puts every choice of rows that determine the columns at this cost on the list; and the columns again, where there are
    /// choices that cost more.
    fn choose(&mut self, most: u64, columns: Bits) {
        let (choices, next) = self.choice.rows(&columns, most, &mut self.left);
        for rows in choices {
            self.put(most, Entry::Rows(rows));
        }
        if let Some(next) = next {
            self.put(next, Entry::Determined(columns));
        }
    }

    /// Puts columns on the list, unless they bring what is left out.
    fn widen(&mut self, estimate: u64, within: Within) {
        if self.left > 0 && !self.has_any(&within.columns, &within.without) {
            self.left -= 1;
            self.put(estimate, Entry::Columns(within));
        }
    }

    fn put(&mut self, estimate: u64, entry: Entry) {
        self.arrivals += 1;
        self.open.insert((estimate, self.arrivals), entry);
    }

    /// A lower bound of the cost of finding these columns.
    fn estimate(&self, columns: &Bits) -> u64 {
        columns.iter().map(|column| self.cheapest[column]).sum()
    }
}
