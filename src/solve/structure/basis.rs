//! The joint content of a set of equations: the space that their derivatives span.

use super::bits::Bits;

/// The size below which the remainder of a derivative counts as nothing; the largest entry of an equation's derivatives
/// is near one.
const NEGLIGIBLE: f64 = 1e-7;

/// Independent derivatives: each has a pivot, a column in which it is 1 and all later ones are 0.
#[derive(Debug, Default)]
pub(crate) struct Span {
    pivots: Vec<usize>,
    /// The derivatives, one after the other.
    entries: Vec<f64>,
    /// The number of columns.
    width: usize,
}

/// How many more equations a copy has room for.
const ROOM: usize = 4;

impl Clone for Span {
    /// A copy is made to be added to.
    fn clone(&self) -> Self {
        let (mut pivots, mut entries) =
            (Vec::with_capacity(self.pivots.len() + ROOM), Vec::with_capacity(self.entries.len() + ROOM * self.width));
        pivots.extend_from_slice(&self.pivots);
        entries.extend_from_slice(&self.entries);
        Self { pivots, entries, width: self.width }
    }
}

impl Span {
    /// The number of equations that are in it.
    pub(crate) fn len(&self) -> usize {
        self.pivots.len()
    }

    /// Adds an equation; `false` where it says nothing new.
    pub(crate) fn add(&mut self, gradient: &[f64]) -> bool {
        self.width = gradient.len();
        let end = self.entries.len();
        self.entries.extend_from_slice(gradient);
        let (rows, rest) = self.entries.split_at_mut(end);
        for (pivot, row) in self.pivots.iter().zip(rows.chunks_exact(self.width)) {
            subtract(rest, row, *pivot);
        }
        let size = rest.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        let pivot = rest.iter().rposition(|entry| entry.abs() >= size).filter(|_| size > NEGLIGIBLE);
        let Some(pivot) = pivot else {
            self.entries.truncate(end);
            return false;
        };
        let largest = rest[pivot];
        for entry in rest.iter_mut() {
            *entry /= largest;
        }
        self.pivots.push(pivot);
        true
    }
}

/// The same in reduced form: in the pivot of each, all others are 0.
#[derive(Clone, Debug, Default)]
pub(crate) struct Basis(Span);

impl Basis {
    /// The number of equations that are in it.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// The number of numbers that it holds.
    pub(crate) fn size(&self) -> usize {
        self.0.entries.len()
    }

    /// Adds an equation; `false` where it says nothing new.
    pub(crate) fn add(&mut self, gradient: &[f64]) -> bool {
        let end = self.0.entries.len();
        let is_new = self.0.add(gradient);
        let (rows, rest) = self.0.entries.split_at_mut(end);
        if let Some(pivot) = self.0.pivots.last().filter(|_| is_new) {
            rows.chunks_exact_mut(self.0.width).for_each(|row| subtract(row, rest, *pivot));
        }
        is_new
    }

    /// The columns among these that can change while every equation holds and no column but these and the pivots changes: every
    /// change is made up of one for each of them.
    pub(crate) fn free(&self, columns: &Bits) -> impl Iterator<Item = usize> {
        columns.iter().filter(|column| !self.0.pivots.contains(column))
    }

    /// The columns that change together with a free column, itself first.
    pub(crate) fn together(&self, free: usize) -> impl Iterator<Item = usize> {
        let rows = self.0.pivots.iter().zip(self.0.entries.chunks_exact(self.0.width.max(1)));
        let moves = rows.filter(move |(_, row)| row.get(free).is_some_and(|entry| entry.abs() > NEGLIGIBLE));
        std::iter::once(free).chain(moves.map(|(pivot, _)| *pivot))
    }
}

/// Takes away from a vector its share in a row that is 1 at the pivot.
fn subtract(vector: &mut [f64], row: &[f64], pivot: usize) {
    let share = vector[pivot];
    if share != 0.0 {
        vector.iter_mut().zip(row).for_each(|(entry, other)| *entry -= share * other);
        vector[pivot] = 0.0;
    }
}
