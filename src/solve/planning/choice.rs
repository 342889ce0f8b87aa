//! The choices of independent equations that determine unknowns.

use super::super::structure::basis::Span;
use super::super::structure::bits::Bits;
use super::super::structure::incidence::Structure;

/// Chooses rows that determine columns and contain no others.
pub(super) struct Choice<'a> {
    structure: &'a Structure,
    /// The derivatives of each row.
    gradients: &'a [Vec<f64>],
    /// For each column the rows that give it directly as cheaply as any: a choice for the column takes one of them,
    /// since any other row can be exchanged for it.
    direct: Vec<Bits>,
}

/// Rows that are chosen.
#[derive(Clone, Debug)]
struct ChosenRows {
    /// The place of the row that is chosen or left out next.
    place: usize,
    cost: u64,
    rows: Bits,
    span: Span,
}

impl<'a> Choice<'a> {
    /// Chooses by the derivatives of each row; `cheapest` is for each column the cost of the cheapest row that finds it.
    pub(crate) fn new(structure: &'a Structure, gradients: &'a [Vec<f64>], cheapest: &[u64]) -> Self {
        let direct = cheapest.iter().enumerate().map(|(column, cheapest)| {
            let alone = structure.rows.iter().enumerate().filter(|(_, row)| row.unknowns.len() == 1);
            let alone = alone.filter(|(_, row)| row.finds.contains(column));
            let any = alone.clone().any(|(_, row)| u64::from(row.cost) == *cheapest);
            Bits::of(structure.rows.len(), alone.map(|(place, _)| place).filter(|_| any))
        });
        Self { structure, gradients, direct: direct.collect() }
    }

    /// Every choice that determines the columns at this cost, with a row that is direct wherever there is one; and what the
    /// next dearer ones cost at least. Each step takes one from what is `left`; where nothing is, some may be missing.
    pub(crate) fn rows(&self, columns: &Bits, most: u64, left: &mut usize) -> (Vec<Bits>, Option<u64>) {
        let mut ways =
            vec![ChosenRows { place: 0, cost: 0, rows: Bits::empty(self.structure.rows.len()), span: Span::default() }];
        for direct in columns.iter().map(|column| &self.direct[column]).filter(|direct| !direct.is_empty()) {
            let mut more = Vec::new();
            for way in &ways {
                more.extend(direct.iter().filter_map(|row| Some(ChosenRows { place: 0, ..self.with(way, row)? })));
            }
            ways = more;
        }
        let serves = |row: &usize| {
            let row = &self.structure.rows[*row];
            columns.covers(&row.unknowns) && row.finds.iter().any(|column| self.direct[column].is_empty())
        };
        let inside: Vec<usize> = (0..self.structure.rows.len()).filter(serves).collect();
        let least = inside.iter().map(|row| u64::from(self.structure.rows[*row].cost)).min().unwrap_or(0);
        let width = columns.len();
        let (mut choices, mut next) = (Vec::new(), None::<u64>);
        while let Some(way) = ways.pop() {
            let cost = way.cost + least * (width - way.span.len()) as u64;
            if cost > most {
                next = Some(next.map_or(cost, |next| next.min(cost)));
                continue;
            }
            if *left == 0 {
                return (choices, None);
            }
            *left -= 1;
            if way.span.len() == width {
                choices.extend((cost == most).then_some(way.rows));
                continue;
            }
            let Some(row) = inside.get(way.place) else { continue };
            let with = self.with(&way, *row);
            if with.is_none() || self.are_enough(&way, inside.iter().skip(way.place + 1), width) {
                ways.push(ChosenRows { place: way.place + 1, ..way });
            }
            ways.extend(with);
        }
        (choices, next)
    }

    /// Whether the rows that are chosen say as much with these as columns need of so great a number.
    fn are_enough<'r>(&self, way: &ChosenRows, rows: impl ExactSizeIterator<Item = &'r usize>, width: usize) -> bool {
        let mut span = way.span.clone();
        span.len() + rows.len() >= width
            && rows.into_iter().any(|row| span.add(&self.gradients[*row]) && span.len() == width)
    }

    /// A choice with one more row, where that says something new.
    fn with(&self, way: &ChosenRows, row: usize) -> Option<ChosenRows> {
        let mut more = way.clone();
        more.place += 1;
        more.cost += u64::from(self.structure.rows[row].cost);
        more.rows.insert(row);
        more.span.add(&self.gradients[row]).then_some(more)
    }
}
