//! A place at which all equations hold, to look at their derivatives there. Elsewhere equations may look independent that
//! are not: with `v_x = v cos(theta)` and `v_y = v sin(theta)`, `v^2 = v_x^2 + v_y^2` says nothing new, but its derivatives
//! show that only where the first two hold.

use nalgebra::{DMatrix, DVector};

use crate::expr::{Expr, Symbol};

use super::{Statement, System};

/// Places from which the search for one begins.
const STARTS: u32 = 4;

/// How many steps are taken from a start.
const STEPS: usize = 40;

/// No value changes by more in a step, so that a start far off does not lead astray.
const LONGEST: f64 = 0.5;

/// Sides that differ by less are equal; the values are near one.
const EQUAL: f64 = 1e-10;

/// Keeps redundant equations from making a step endless.
const DAMPING: f64 = 1e-9;

/// A value for each symbol of a system.
#[derive(Clone, Debug)]
pub(super) struct Sample(Vec<f64>);

impl Sample {
    /// Values at which every equation of the system holds, found by steps of least length (Gauss and Newton's) from values
    /// in no relation to each other; where that leads nowhere, as with equations that contradict each other, those values.
    pub(super) fn of(system: &System) -> Self {
        let residuals: Vec<Expr> = system.equations.iter().filter_map(|own| residual(&own.statement)).collect();
        let count = system.equations.iter().flat_map(super::Equation::symbols).map(|symbol| symbol.index() + 1).max();
        let start = |salt| Self((0..count.unwrap_or(0)).map(|index| generic(index, salt)).collect());
        (0..STARTS).find_map(|salt| start(salt).settled(&residuals)).unwrap_or_else(|| start(0))
    }

    /// The value of a symbol.
    pub(super) fn value(&self, symbol: Symbol) -> f64 {
        self.0.get(symbol.index()).copied().unwrap_or(1.0)
    }

    /// The derivatives of a term, in parts: one for each place at which a symbol stands.
    pub(super) fn slopes(&self, term: &Expr) -> Vec<(Symbol, f64)> {
        let mut slopes = Vec::new();
        term.slopes(&|symbol| self.value(symbol), 1.0, &mut |symbol, slope| slopes.push((symbol, slope)));
        slopes
    }

    fn settled(mut self, residuals: &[Expr]) -> Option<Self> {
        for _ in 0..STEPS {
            let off = DVector::from_iterator(
                residuals.len(),
                residuals.iter().map(|residual| residual.evaluate(&|symbol| self.value(symbol))),
            );
            if off.iter().all(|own| own.abs() < EQUAL) {
                return Some(self);
            }
            let rows: Vec<Vec<(Symbol, f64)>> = residuals.iter().map(|residual| self.slopes(residual)).collect();
            let shares = self.products(&rows).cholesky()?.solve(&off);
            let step = self.dense(rows.iter().zip(&shares).flat_map(|(row, share)| scaled(row, *share)));
            let longest = step.iter().fold(0.0_f64, |longest, change| longest.max(change.abs()));
            if !longest.is_finite() {
                return None;
            }
            let share = (LONGEST / longest).min(1.0);
            self.0.iter_mut().zip(&step).for_each(|(value, change)| *value -= share * change);
        }
        None
    }

    /// Each row of derivatives times each other.
    fn products(&self, rows: &[Vec<(Symbol, f64)>]) -> DMatrix<f64> {
        let mut products = DMatrix::zeros(rows.len(), rows.len());
        for (place, row) in rows.iter().enumerate() {
            let dense = self.dense(scaled(row, 1.0));
            for (other, row) in rows.iter().enumerate().skip(place) {
                let product: f64 = row.iter().map(|(symbol, slope)| slope * dense[symbol.index()]).sum();
                products[(place, other)] = product;
                products[(other, place)] = product;
            }
            products[(place, place)] += DAMPING;
        }
        products
    }

    /// The sum of what falls to each symbol, by its index.
    fn dense(&self, parts: impl Iterator<Item = (Symbol, f64)>) -> Vec<f64> {
        let mut dense = vec![0.0; self.0.len()];
        parts.for_each(|(symbol, part)| dense[symbol.index()] += part);
        dense
    }
}

fn scaled(row: &[(Symbol, f64)], by: f64) -> impl Iterator<Item = (Symbol, f64)> + '_ {
    row.iter().map(move |(symbol, slope)| (*symbol, by * slope))
}

/// Left side minus right side; none for a count.
pub(super) fn residual(statement: &Statement) -> Option<Expr> {
    match statement {
        Statement::Equal { left, right } => Some(left.clone() - right.clone()),
        Statement::FirstInteger { .. } => None,
    }
}

/// A fixed value for each symbol, between 1/2 and 3/2, in no relation to that of any other.
pub(super) fn generic(index: usize, salt: u32) -> f64 {
    let index = u32::try_from(index).unwrap_or(u32::MAX);
    let mixed = index.wrapping_add(salt.wrapping_mul(977)).wrapping_add(1).wrapping_mul(2_654_435_761);
    0.5 + f64::from(mixed ^ (mixed >> 15)) / f64::from(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::super::Equation;
    use super::super::basis::Basis;
    use super::*;
    use crate::expr::{Names, SymbolEntry, SymbolTable, parse};
    use crate::quantity::Dimension;

    fn system(lines: &[[&str; 2]]) -> System {
        struct All(SymbolTable);
        impl Names for All {
            fn symbol(&mut self, name: &str) -> Option<Symbol> {
                let entry = SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: name.into() };
                Some(self.0.find(name).unwrap_or_else(|| self.0.intern(entry)))
            }

            fn literal(&mut self, _: &str) -> Option<Symbol> {
                None
            }
        }
        let mut names = All(SymbolTable::default());
        let mut read = |text: &str| parse(text, &mut names).unwrap();
        let equations = lines
            .iter()
            .map(|[left, right]| Equation {
                statement: Statement::Equal { left: read(left), right: read(right) },
                tag: 0,
                cost: 1,
            })
            .collect();
        System { equations, ..System::default() }
    }

    #[test]
    fn equations_that_follow_from_others_are_seen_to() {
        let polar = system(&[["x", "v*cos(a)"], ["y", "v*sin(a)"], ["v^2", "x^2 + y^2"]]);
        let sample = Sample::of(&polar);
        let mut basis = Basis::default();
        let terms = polar.equations.iter().filter_map(|own| residual(&own.statement));
        let new: Vec<bool> = terms.map(|term| basis.add(&sample.dense(sample.slopes(&term).into_iter()))).collect();
        assert_eq!(new, [true, true, false]);
    }

    #[test]
    fn a_contradiction_leaves_the_values_it_began_with() {
        let never = system(&[["x", "1 + x^2"]]);
        assert_eq!(Sample::of(&never).0, [generic(0, 0)]);
    }
}
