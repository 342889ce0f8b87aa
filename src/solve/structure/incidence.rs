//! Which equation contains which unknown: all that the choice of equations looks at.

use std::collections::{BTreeMap, BTreeSet};

use momentous_expr::{Expr, Symbol};

use super::super::{Equation, Statement, System};
use super::bits::Bits;

/// The incidence of equations (rows) and unknowns (columns).
#[derive(Clone, Debug)]
pub(crate) struct Structure {
    /// The unknown of each column.
    pub(crate) unknowns: Vec<Symbol>,
    /// The equations that contain an unknown.
    pub(crate) rows: Vec<Row>,
}

/// One equation, as the choice of equations sees it.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// Its position in the system.
    pub(crate) equation: usize,
    /// The cost of using it.
    pub(crate) cost: u32,
    /// The columns that it contains.
    pub(crate) unknowns: Bits,
    /// The columns that it may be solved for: one only where the equation is a count.
    pub(crate) finds: Bits,
    /// The column that stands alone on one side, and not on the other: it is found without any algebra.
    pub(crate) alone: Option<usize>,
}

impl Structure {
    /// The incidence of a system, once `known` is known.
    pub(crate) fn new(system: &System, known: &BTreeSet<Symbol>) -> Self {
        let contents: Vec<Vec<Symbol>> = system.equations.iter().map(|equation| equation.unknowns(known)).collect();
        let unknowns = distinct(contents.iter().flatten().copied().collect());
        let columns: BTreeMap<Symbol, usize> = unknowns.iter().copied().zip(0..).collect();
        let bits = |symbols: &mut dyn Iterator<Item = &Symbol>| {
            Bits::of(unknowns.len(), symbols.filter_map(|symbol| columns.get(symbol).copied()))
        };
        let rows = contents.iter().zip(&system.equations).enumerate().filter_map(|(equation, (content, stated))| {
            let all = bits(&mut content.iter());
            let finds = stated.counts().map_or_else(|| all.clone(), |integer| bits(&mut std::iter::once(&integer)));
            let alone = stated.alone().and_then(|symbol| columns.get(&symbol).copied());
            (!finds.is_empty()).then_some(Row { equation, cost: stated.cost, unknowns: all, finds, alone })
        });
        Self { rows: rows.collect(), unknowns }
    }

    /// The columns that any of these rows contains.
    pub(crate) fn columns(&self, rows: &[usize]) -> Bits {
        Bits::of(self.unknowns.len(), rows.iter().flat_map(|row| self.rows[*row].unknowns.iter()))
    }

    /// The column of a symbol, where it is an unknown.
    pub(crate) fn column(&self, symbol: Symbol) -> Option<usize> {
        self.unknowns.binary_search(&symbol).ok()
    }

    /// Whether what is wanted depends on each of these blocks, which stand in the order in which they are solved.
    pub(crate) fn needs_all(&self, blocks: &[Vec<usize>], wanted: &Bits) -> bool {
        let mut columns_so_far = Bits::empty(self.unknowns.len());
        let new = |rows: &Vec<usize>| {
            let all = self.columns(rows);
            let mut new = all.clone();
            new.subtract(&columns_so_far);
            columns_so_far.join(&all);
            (all, new)
        };
        let contents: Vec<(Bits, Bits)> = blocks.iter().map(new).collect();
        let mut needed = wanted.clone();
        contents.iter().rev().all(|(all, new)| {
            let serves = new.meets(&needed);
            needed.join(all);
            serves
        })
    }

    /// How many of these blocks take algebra: all but single equations with their unknown alone on one side.
    pub(crate) fn rearranged(&self, blocks: &[Vec<usize>]) -> usize {
        let mut columns_so_far = Bits::empty(self.unknowns.len());
        let mut count = 0;
        for rows in blocks {
            let mut columns = self.columns(rows);
            columns.subtract(&columns_so_far);
            let alone =
                matches!(rows[..], [row] if self.rows[row].alone.is_some_and(|column| columns.contains(column)));
            count += usize::from(!alone);
            columns_so_far.join(&columns);
        }
        count
    }

    /// Drops the rows that cannot serve: those with a column that is not determined, and (again and again) those
    /// with a column that stands nowhere else and is not wanted.
    pub(crate) fn prune(&mut self, determined: &Bits, wanted: &Bits) {
        self.rows.retain(|row| determined.covers(&row.unknowns));
        loop {
            let mut count = vec![0_usize; self.unknowns.len()];
            for column in self.rows.iter().flat_map(|row| row.unknowns.iter()) {
                count[column] += 1;
            }
            let before = self.rows.len();
            self.rows.retain(|row| row.unknowns.iter().all(|column| count[column] > 1 || wanted.contains(column)));
            if self.rows.len() == before {
                return;
            }
        }
    }

    /// Drops the columns that no row contains and that are not wanted; gives the wanted ones by their new places.
    pub(crate) fn narrow(&mut self, wanted: &Bits) -> Bits {
        let mut kept = wanted.clone();
        self.rows.iter().for_each(|row| kept.join(&row.unknowns));
        let places: BTreeMap<usize, usize> = kept.iter().zip(0..).collect();
        let moved =
            |columns: &Bits| Bits::of(places.len(), columns.iter().filter_map(|column| places.get(&column).copied()));
        for row in &mut self.rows {
            (row.unknowns, row.finds) = (moved(&row.unknowns), moved(&row.finds));
            row.alone = row.alone.and_then(|column| places.get(&column).copied());
        }
        self.unknowns = kept.iter().map(|column| self.unknowns[column]).collect();
        moved(wanted)
    }
}

/// Every symbol of some terms, ascending, each once.
pub(crate) fn ascending<'e>(terms: impl IntoIterator<Item = &'e Expr>) -> Vec<Symbol> {
    let mut symbols = Vec::new();
    terms.into_iter().for_each(|term| term.add_symbols(&mut symbols));
    distinct(symbols)
}

/// Symbols ascending, each once.
fn distinct(mut symbols: Vec<Symbol>) -> Vec<Symbol> {
    symbols.sort_unstable();
    symbols.dedup();
    symbols
}

impl Equation {
    /// Every symbol that the equation contains.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.unknowns(&BTreeSet::new()).into_iter().collect()
    }

    /// Every symbol that the equation contains and that is not known, ascending.
    pub(crate) fn unknowns(&self, known: &BTreeSet<Symbol>) -> Vec<Symbol> {
        let (Statement::Equal { left, right } | Statement::FirstInteger { left, right, .. }) = &self.statement;
        let count = self.counts().map(Expr::from);
        let mut unknowns = ascending([left, right].into_iter().chain(&count));
        unknowns.retain(|symbol| !known.contains(symbol));
        unknowns
    }

    /// The symbol that stands alone on one side and does not stand on the other; the left side's first.
    fn alone(&self) -> Option<Symbol> {
        let Statement::Equal { left, right } = &self.statement else { return None };
        let alone = |side: &Expr, other: &Expr| match side {
            Expr::Symbol(symbol) if !other.contains(*symbol) => Some(*symbol),
            _ => None,
        };
        alone(left, right).or_else(|| alone(right, left))
    }

    /// The integer that the equation finds by counting, where it is a count.
    #[must_use]
    pub fn counts(&self) -> Option<Symbol> {
        match &self.statement {
            Statement::Equal { .. } => None,
            Statement::FirstInteger { unknown, .. } => Some(*unknown),
        }
    }
}
