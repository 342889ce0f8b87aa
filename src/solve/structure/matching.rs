//! Which equation finds which unknown: a maximum matching, by augmenting paths.

use super::bits::Bits;
use super::incidence::Structure;

/// A matching of rows and columns; no row and no column is used twice.
#[derive(Clone, Debug)]
pub(super) struct Matching {
    by_column: Vec<Option<usize>>,
    by_row: Vec<Option<usize>>,
}

impl Matching {
    /// A maximum matching of these rows; `known` columns are left out.
    pub(crate) fn new(structure: &Structure, rows: &[usize], known: &Bits) -> Self {
        let mut matching =
            Self { by_column: vec![None; structure.unknowns.len()], by_row: vec![None; structure.rows.len()] };
        for row in rows {
            let mut visited = known.clone();
            matching.augment(structure, *row, &mut visited);
        }
        matching
    }

    /// Finds a column for the row, moving other rows to other columns where needed.
    /// Recursion is as deep as an augmenting path: at most the number of rows.
    fn augment(&mut self, structure: &Structure, row: usize, visited: &mut Bits) -> bool {
        for column in structure.rows[row].finds.iter() {
            if visited.contains(column) {
                continue;
            }
            visited.insert(column);
            if self.by_column[column].is_none_or(|other| self.augment(structure, other, visited)) {
                self.by_column[column] = Some(row);
                self.by_row[row] = Some(column);
                return true;
            }
        }
        false
    }

    /// Whether some row finds the column.
    pub(crate) fn finds(&self, column: usize) -> bool {
        self.by_column[column].is_some()
    }

    /// The row that finds the column.
    pub(super) fn finder(&self, column: usize) -> Option<usize> {
        self.by_column[column]
    }

    /// The column that the row finds.
    pub(super) fn found_by(&self, row: usize) -> Option<usize> {
        self.by_row[row]
    }
}
