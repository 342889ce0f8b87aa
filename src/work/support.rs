//! The laws that a line is made of. On the scene's own values a line that follows is, to first order, a sum of multiples of equations:
//! its slopes by the unknowns are the same sum of theirs. The fewest equations of which that is true are the laws of the line.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::ground::{Ground, Place};

/// The length of the remainder of a row of length one that counts as nothing.
const NOTHING: f64 = 1e-7;

/// The slopes of the equations at one place, ready to be compared with those of lines.
pub(crate) struct Slopes {
    unknowns: Vec<Symbol>,
    sizes: Vec<f64>,
    names: Basis,
    /// The rows of laws that only name something, each with the position of its equation.
    naming: Vec<(usize, Row)>,
    /// The rows of laws, without what names explain: each with the position of its equation.
    laws: Vec<(usize, Row)>,
    /// The rows of laws as they are.
    whole: Vec<(usize, Row)>,
    /// The quantities in each equation.
    letters: Vec<BTreeSet<Symbol>>,
}

type Row = Vec<f64>;

/// Orthonormal rows.
#[derive(Clone, Debug, Default)]
struct Basis(Vec<Row>);

impl Basis {
    /// The part of a row that is none of this, of length one; `None` where nothing is left.
    fn rest(&self, row: &Row) -> Option<Row> {
        let length = norm(row);
        if length == 0.0 || !length.is_finite() {
            return None;
        }
        let mut rest: Row = row.iter().map(|part| part / length).collect();
        // Twice is enough (Kahan, in Parlett, The Symmetric Eigenvalue Problem, 6.9).
        for _ in 0..2 {
            for base in &self.0 {
                let along = dot(base, &rest);
                rest.iter_mut().zip(base).for_each(|(rest, component)| *rest -= along * component);
            }
        }
        let left = norm(&rest);
        if left < NOTHING {
            return None;
        }
        Some(rest.into_iter().map(|part| part / left).collect())
    }

    fn add(&mut self, row: &Row) {
        if let Some(rest) = self.rest(row) {
            self.0.push(rest);
        }
    }
}

fn dot(one: &Row, other: &Row) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

fn norm(row: &Row) -> f64 {
    dot(row, row).sqrt()
}

/// The support of a line: the laws of which it is made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Support {
    /// The positions of the ground's equations.
    pub(crate) laws: BTreeSet<usize>,
    /// Whether more than names stands in it.
    pub(crate) is_step: bool,
}

impl Slopes {
    /// The slopes at a place, for lines in some quantities.
    pub(crate) fn new(ground: &Ground, place: Place<'_>, mentioned: &BTreeSet<Symbol>) -> Self {
        let all = ground.equations.iter().flat_map(|stated| stated.residual.symbols()).chain(mentioned.iter().copied());
        let unknowns: BTreeSet<Symbol> = all.filter(|symbol| !ground.told.contains(symbol)).collect();
        let valued: Vec<(Symbol, f64)> =
            unknowns.into_iter().filter_map(|symbol| Some((symbol, place.value(symbol)?.value))).collect();
        let sizes = valued.iter().map(|(_, value)| if *value == 0.0 { 1.0 } else { value.abs() }).collect();
        let unknowns = valued.into_iter().map(|(symbol, _)| symbol).collect();
        let letters = ground.equations.iter().map(|stated| stated.residual.symbols()).collect();
        let mut slopes = Self {
            unknowns,
            sizes,
            names: Basis::default(),
            naming: Vec::new(),
            laws: Vec::new(),
            whole: Vec::new(),
            letters,
        };
        let rows = ground
            .equations
            .iter()
            .enumerate()
            .filter_map(|(position, stated)| Some((position, stated, slopes.row(place, &stated.residual)?)));
        let rows: Vec<_> = rows.collect();
        for (.., row) in rows.iter().filter(|(_, stated, _)| stated.is_naming) {
            slopes.names.add(row);
        }
        let mut laws: Vec<_> = rows.iter().filter(|(_, stated, _)| !stated.is_naming).collect();
        laws.sort_by_key(|(_, stated, _)| !stated.is_used);
        let nothing = Basis::default();
        let naming = rows.iter().filter(|(_, stated, _)| stated.is_naming);
        slopes.naming = naming.filter_map(|(position, _, row)| Some((*position, nothing.rest(row)?))).collect();
        slopes.whole = laws.iter().filter_map(|(position, _, row)| Some((*position, nothing.rest(row)?))).collect();
        slopes.laws = laws.iter().filter_map(|(position, _, row)| Some((*position, slopes.names.rest(row)?))).collect();
        slopes
    }

    /// The slopes of a term by the unknowns, each in the unknown's own size; none where one has no value.
    fn row(&self, place: Place<'_>, residual: &Expr) -> Option<Row> {
        let mut row = vec![0.0; self.unknowns.len()];
        let value = |symbol: Symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
        let mut is_known = true;
        residual.slopes(&value, 1.0, &mut |symbol, slope| {
            if let Ok(at) = self.unknowns.binary_search(&symbol) {
                row[at] += slope * self.sizes[at];
            }
            is_known &= slope.is_finite() && value(symbol).is_finite();
        });
        (is_known && row.iter().all(|part| part.is_finite())).then_some(row)
    }

    /// The laws of a line with that difference of its sides.
    pub(crate) fn support(&self, place: Place<'_>, residual: &Expr) -> Support {
        let Some(row) = self.row(place, residual) else { return Support::default() };
        let step = |laws: &[usize]| Support { laws: laws.iter().copied().collect(), is_step: true };
        let letters = residual.symbols();
        let alike = |rows: &[(usize, Row)], rest: &Row| {
            // Of equations that say the same here, the one in the same letters.
            let same = rows.iter().filter(|(_, law)| is_multiple(law, rest)).map(|(position, _)| *position);
            let apart = |position: &usize| {
                self.letters
                    .get(*position)
                    .map_or(usize::MAX, |letters_of_law| letters_of_law.symmetric_difference(&letters).count())
            };
            same.min_by_key(apart)
        };
        if let Some(position) = Basis::default().rest(&row).and_then(|row| alike(&self.whole, &row)) {
            return step(&[position]);
        }
        let Some(rest) = self.names.rest(&row) else { return Support::default() };
        if let Some(position) = alike(&self.laws, &rest) {
            return step(&[position]);
        }
        for (at, (first, law)) in self.laws.iter().enumerate() {
            let Some(rest) = without(&rest, law) else { continue };
            for (second, other) in self.laws.iter().skip(at + 1) {
                if without(other, law).is_some_and(|other| is_multiple(&other, &rest)) {
                    return step(&[*first, *second]);
                }
            }
        }
        self.in_all(&rest).map_or_else(Support::default, |laws| step(&laws))
    }

    /// The only equation that names something and says the same as a line.
    pub(crate) fn naming(&self, place: Place<'_>, residual: &Expr) -> Option<usize> {
        let row = Basis::default().rest(&self.row(place, residual)?)?;
        self.naming.iter().find(|(_, law)| is_multiple(law, &row)).map(|(position, _)| *position)
    }

    /// The laws of an independent set, those that are used first, of which a row is a sum.
    fn in_all(&self, row: &Row) -> Option<Vec<usize>> {
        // Each row of the basis as a sum of laws.
        let mut basis: Vec<(Row, Vec<f64>)> = Vec::new();
        let mut chosen: Vec<usize> = Vec::new();
        let project = |basis: &[(Row, Vec<f64>)], row: &Row, count: usize| {
            let (mut rest, mut parts) = (row.clone(), vec![0.0; count]);
            for _ in 0..2 {
                for (base, sum) in basis {
                    let along = dot(base, &rest);
                    rest.iter_mut().zip(base).for_each(|(rest, component)| *rest -= along * component);
                    parts.iter_mut().zip(sum).for_each(|(part, coefficient)| *part += along * coefficient);
                }
            }
            (rest, parts)
        };
        for (position, law) in &self.laws {
            let (mut rest, parts) = project(&basis, law, chosen.len());
            let left = norm(&rest);
            if left >= NOTHING {
                rest = rest.into_iter().map(|part| part / left).collect();
                let sum = parts.iter().map(|part| -part / left).chain([1.0 / left]).collect();
                basis.push((rest, sum));
                chosen.push(*position);
            }
            let (rest, parts) = project(&basis, row, chosen.len());
            if norm(&rest) < NOTHING {
                let used = chosen.iter().zip(parts).filter(|(_, part)| part.abs() > NOTHING);
                return Some(used.map(|(position, _)| *position).collect());
            }
        }
        None
    }

    /// The positions of the laws that follow from lines with those differences of their sides.
    pub(crate) fn established<'e>(&self, place: Place<'_>, lines: impl Iterator<Item = &'e Expr>) -> BTreeSet<usize> {
        let mut known = self.names.clone();
        lines.filter_map(|residual| self.row(place, residual)).for_each(|row| known.add(&row));
        self.laws.iter().filter(|(_, law)| known.rest(law).is_none()).map(|(position, _)| *position).collect()
    }
}

/// Whether a row is a multiple of another, both of length one.
fn is_multiple(one: &Row, other: &Row) -> bool {
    without(one, other).is_none()
}

/// The part of a row of length one that is no multiple of another, of length one.
fn without(row: &Row, other: &Row) -> Option<Row> {
    Basis(vec![other.clone()]).rest(row)
}
