//! The block triangular form: which equations must be solved together, and in which order.

use super::bits::Bits;
use super::incidence::Structure;
use super::matching::Matching;

/// The irreducible blocks of a square set of rows, each after those that it depends on; `None` where the rows do not
/// determine their columns, or where a count would have to be solved together with other equations.
///
/// They are the strongly connected components of "row r contains the unknown that row s finds", in Tarjan's order.
pub(crate) fn blocks(structure: &Structure, rows: &[usize]) -> Option<Vec<Vec<usize>>> {
    let matching = Matching::new(structure, rows, &Bits::empty(structure.unknowns.len()));
    if rows.iter().any(|row| matching.found_by(*row).is_none()) {
        return None;
    }
    let unmarked = vec![None; structure.rows.len()];
    let mut tarjan =
        Tarjan { structure, matching, index: unmarked.clone(), low: unmarked, stack: Vec::new(), found: Vec::new() };
    for row in rows {
        if tarjan.index[*row].is_none() {
            tarjan.visit(*row)?;
        }
    }
    let counts_alone = |block: &Vec<usize>| {
        block.len() == 1 || block.iter().all(|row| structure.rows[*row].finds == structure.rows[*row].unknowns)
    };
    tarjan.found.iter().all(counts_alone).then_some(tarjan.found)
}

struct Tarjan<'a> {
    structure: &'a Structure,
    matching: Matching,
    index: Vec<Option<usize>>,
    low: Vec<Option<usize>>,
    stack: Vec<usize>,
    found: Vec<Vec<usize>>,
}

impl Tarjan<'_> {
    /// `None` where a column has no finder. Recursion is at most as deep as
    /// there are rows.
    fn visit(&mut self, row: usize) -> Option<()> {
        let position = self.index.iter().flatten().count();
        self.index[row] = Some(position);
        self.low[row] = Some(position);
        self.stack.push(row);
        for column in self.structure.rows[row].unknowns.iter() {
            let next = self.matching.finder(column)?;
            if self.index[next].is_none() {
                self.visit(next)?;
                self.low[row] = self.low[row].min(self.low[next]);
            } else if self.stack.contains(&next) {
                self.low[row] = self.low[row].min(self.index[next]);
            }
        }
        if self.low[row] == self.index[row] {
            let start = self.stack.iter().position(|other| *other == row)?;
            let mut block = self.stack.split_off(start);
            block.sort_unstable();
            self.found.push(block);
        }
        Some(())
    }
}
