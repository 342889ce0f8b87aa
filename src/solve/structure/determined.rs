//! Which unknowns the equations determine, and which equations are enough for those that are wanted, by matchings.

use super::bits::Bits;
use super::incidence::Structure;
use super::matching::Matching;

impl Structure {
    /// The columns that the equations determine, counting equations only: everything outside the under-determined
    /// part of the Dulmage-Mendelsohn decomposition. `known` columns count as known.
    pub(crate) fn determined(&self, known: &Bits) -> Bits {
        let mut usable: Vec<usize> = (0..self.rows.len()).collect();
        loop {
            let matching = Matching::new(self, &usable, known);
            let mut under: Vec<usize> = (0..self.unknowns.len())
                .filter(|column| !known.contains(*column) && !matching.finds(*column))
                .collect();
            let mut lost = Bits::empty(self.unknowns.len());
            while let Some(column) = under.pop() {
                if lost.contains(column) {
                    continue;
                }
                lost.insert(column);
                let rows = usable.iter().filter(|row| self.rows[**row].finds.contains(column));
                under.extend(rows.filter_map(|row| matching.found_by(*row)));
            }
            let before = usable.len();
            usable.retain(|row| {
                self.rows[*row].finds == self.rows[*row].unknowns || !self.rows[*row].unknowns.meets(&lost)
            });
            if usable.len() == before {
                let mut determined = Bits::of(self.unknowns.len(), 0..self.unknowns.len());
                determined.subtract(&lost);
                return determined;
            }
        }
    }

    /// Some rows that determine the wanted columns, the cheap ones preferred, though not the cheapest set; found
    /// without any search. They are what the wanted columns depend on in one maximum matching of the rows not `avoided`; `known`
    /// columns count as known.
    pub(crate) fn sufficient(&self, wanted: &Bits, known: &Bits, avoided: &Bits) -> Option<Vec<usize>> {
        let mut rows: Vec<usize> = (0..self.rows.len()).filter(|row| !avoided.contains(*row)).collect();
        rows.sort_by_key(|row| (self.rows[*row].cost, self.rows[*row].unknowns.len()));
        let matching = Matching::new(self, &rows, known);
        let mut chosen = Bits::empty(self.rows.len());
        let mut open: Vec<usize> = wanted.iter().collect();
        while let Some(column) = open.pop() {
            let row = matching.finder(column)?;
            if !chosen.contains(row) {
                chosen.insert(row);
                open.extend(self.rows[row].unknowns.iter().filter(|column| !known.contains(*column)));
            }
        }
        Some(chosen.iter().collect())
    }
}
