//! What a set of equations says together: the space that their derivatives span.

use super::bits::Bits;

/// What is left of a derivative below this counts as nothing; the largest entry of an equation's derivatives is near one.
const NEGLIGIBLE: f64 = 1e-7;

/// Independent derivatives in reduced form: each has a column of its own, in which it is 1 and all others are 0.
#[derive(Clone, Debug, Default)]
pub(super) struct Basis {
    pivots: Vec<usize>,
    /// The derivatives, one after the other.
    entries: Vec<f64>,
    /// How many columns there are.
    width: usize,
}

impl Basis {
    /// How many equations are in it.
    pub(super) fn len(&self) -> usize {
        self.pivots.len()
    }

    /// How many numbers it holds.
    pub(super) fn size(&self) -> usize {
        self.entries.len()
    }

    /// Adds an equation; `false` where it says nothing new.
    pub(super) fn add(&mut self, gradient: &[f64]) -> bool {
        let width = gradient.len();
        self.width = width;
        let end = self.entries.len();
        self.entries.extend_from_slice(gradient);
        let (rows, rest) = self.entries.split_at_mut(end);
        for (pivot, row) in self.pivots.iter().zip(rows.chunks_exact(width)) {
            subtract(rest, row, *pivot);
        }
        let (mut pivot, mut largest) = (0, 0.0_f64);
        for (column, entry) in rest.iter().enumerate() {
            if entry.abs() >= largest.abs() {
                (pivot, largest) = (column, *entry);
            }
        }
        if largest.abs() <= NEGLIGIBLE {
            self.entries.truncate(end);
            return false;
        }
        for entry in rest.iter_mut() {
            *entry /= largest;
        }
        for row in rows.chunks_exact_mut(width) {
            subtract(row, rest, pivot);
        }
        self.pivots.push(pivot);
        true
    }

    /// The columns among these that can change while every equation holds and no column but these and the pivots changes: every
    /// change is made up of one for each of them.
    pub(super) fn free(&self, columns: &Bits) -> impl Iterator<Item = usize> {
        columns.iter().filter(|column| !self.pivots.contains(column))
    }

    /// What changes together with a free column, itself first.
    pub(super) fn together(&self, free: usize) -> impl Iterator<Item = usize> {
        let rows = self.pivots.iter().zip(self.entries.chunks_exact(self.width.max(1)));
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
