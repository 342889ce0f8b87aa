//! A place at which all equations hold, to look at their derivatives there. Elsewhere equations may look independent that
//! are not: with `v_x = v cos(theta)` and `v_y = v sin(theta)`, `v^2 = v_x^2 + v_y^2` says nothing new, but its derivatives
//! show that only where the first two hold.

use std::collections::BTreeSet;

use nalgebra::{DMatrix, DVector};

use crate::expr::{Expr, Symbol};

use super::basis::Basis;
use super::structure::Structure;
use super::{Statement, System};

/// Places from which the search for one begins.
const STARTS: u32 = 8;

/// How many of the places found are compared.
const COMPARED: usize = 2;

/// How many steps are taken from a start.
const STEPS: usize = 30;

/// Sides that differ by less are equal; the values are near one.
const EQUAL: f64 = 1e-10;

/// A value nearer to zero than this is no example: `(F_A + F_B) dt = 0` holds for `dt = 0`, whatever the forces.
const NOTHING: f64 = 0.02;

/// What keeps a step short: at first, and at least, since of equations that say the same twice no step is the shortest.
const DAMPING: (f64, f64) = (1e-2, 1e-10);

/// A value for each symbol of a system.
#[derive(Clone, Debug)]
pub(super) struct Sample(Vec<f64>);

impl Sample {
    /// Values at which every equation among the rows holds, with as few zeros as can be; where none are found, as with
    /// equations that contradict each other, values in no relation to each other.
    pub(super) fn of(system: &System, structure: &Structure) -> Self {
        let stated = structure.rows.iter().filter_map(|row| system.equations.get(row.equation));
        let stated: Vec<&Statement> = stated.map(|equation| &equation.statement).collect();
        let residuals: Vec<Expr> = stated.iter().filter_map(|own| residual(own)).collect();
        let symbols = || residuals.iter().flat_map(Expr::symbols);
        let blank = Self(vec![1.0; symbols().map(|symbol| symbol.index() + 1).max().unwrap_or(0)]);
        let told = stated.iter().filter(|own| is_zero(own)).count();
        let is_allowed = |found: &Self| system.positive.iter().all(|symbol| found.value(*symbol) > NOTHING);
        let (mut found, mut allowed) = (Vec::new(), 0);
        for settled in (0..STARTS).filter_map(|salt| blank.start(system, &stated, salt).settled(&residuals)) {
            let judged = (!is_allowed(&settled), settled.zeros(), settled);
            allowed += usize::from(!judged.0);
            let is_best = !judged.0 && judged.1 <= told;
            found.push(judged);
            if is_best || allowed == COMPARED {
                break;
            }
        }
        // Equations that depend on each other do so at places where a mass is negative, too; but there also others may, so
        // that of such places the one counts at which most are independent.
        let serves = |(forbidden, zeros, _): &(bool, usize, Self)| !forbidden || *zeros <= told;
        let best = found.into_iter().filter(serves).min_by_key(|(forbidden, zeros, sample)| {
            let dependent = if *forbidden { residuals.len() - sample.rank(&residuals) } else { 0 };
            (*forbidden, dependent, *zeros)
        });
        let unrelated = || Self((0..blank.0.len()).map(|index| generic(index, 0)).collect());
        best.map_or_else(unrelated, |(_, _, sample)| sample)
    }

    /// Values in no relation to each other, but for symbols that stand alone in an equation: these have the value of its
    /// other side.
    fn start(&self, system: &System, stated: &[&Statement], salt: u32) -> Self {
        let signed = |index| {
            let sign = if generic(index, salt + STARTS) < 1.0 { -1.0 } else { 1.0 };
            sign * generic(index, salt)
        };
        let mut sample = Self((0..self.0.len()).map(signed).collect());
        for symbol in &system.positive {
            sample.set(*symbol, generic(symbol.index(), salt));
        }
        let mut given = BTreeSet::new();
        for statement in stated {
            let Statement::Equal { left, right } = statement else { continue };
            for (side, other) in [(left, right), (right, left)] {
                let Expr::Symbol(symbol) = side else { continue };
                let value = other.evaluate(&|symbol| sample.value(symbol));
                if !other.contains(*symbol) && value.is_finite() && given.insert(*symbol) {
                    sample.set(*symbol, value);
                    break;
                }
            }
        }
        sample
    }

    /// The value of a symbol.
    pub(super) fn value(&self, symbol: Symbol) -> f64 {
        self.0.get(symbol.index()).copied().unwrap_or(1.0)
    }

    fn set(&mut self, symbol: Symbol, value: f64) {
        if let Some(own) = self.0.get_mut(symbol.index()) {
            *own = value;
        }
    }

    fn zeros(&self) -> usize {
        self.0.iter().filter(|value| value.abs() < NOTHING).count()
    }

    /// The derivatives of a term, in parts: one for each place at which a symbol stands.
    pub(super) fn slopes(&self, term: &Expr) -> Vec<(Symbol, f64)> {
        let mut slopes = Vec::new();
        term.slopes(&|symbol| self.value(symbol), 1.0, &mut |symbol, slope| slopes.push((symbol, slope)));
        slopes
    }

    /// How many of the terms are independent here.
    fn rank(&self, residuals: &[Expr]) -> usize {
        let mut basis = Basis::default();
        residuals.iter().filter(|residual| basis.add(&self.dense(self.slopes(residual).into_iter()))).count()
    }

    /// Moved to where all terms are zero, by damped steps (Levenberg and Marquardt's).
    fn settled(mut self, residuals: &[Expr]) -> Option<Self> {
        let mut damping = DAMPING.0;
        let mut off = self.off(residuals)?;
        for _ in 0..STEPS {
            if off.amax() < EQUAL {
                return Some(self);
            }
            let rows: Vec<Vec<(Symbol, f64)>> = residuals.iter().map(|residual| self.slopes(residual)).collect();
            let mut products = self.products(&rows);
            for place in 0..rows.len() {
                products[(place, place)] += damping;
            }
            let shares = products.cholesky()?.solve(&off);
            let step = self.dense(rows.iter().zip(&shares).flat_map(|(row, share)| scaled(row, *share)));
            let moved = Self(self.0.iter().zip(&step).map(|(value, change)| value - change).collect());
            match moved.off(residuals).filter(|after| after.norm_squared() < off.norm_squared()) {
                Some(after) => {
                    (self, off) = (moved, after);
                    damping = (damping / 100.0).max(DAMPING.1);
                }
                None => damping *= 30.0,
            }
        }
        None
    }

    /// How far off each term is from zero; none where one has no value.
    fn off(&self, residuals: &[Expr]) -> Option<DVector<f64>> {
        let values = residuals.iter().map(|residual| residual.evaluate(&|symbol| self.value(symbol)));
        let off = DVector::from_iterator(residuals.len(), values);
        off.iter().all(|own| own.is_finite()).then_some(off)
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

/// Whether an equation says no more than that a symbol is zero.
fn is_zero(statement: &Statement) -> bool {
    matches!(statement, Statement::Equal { left: Expr::Symbol(_), right } if right.is_zero())
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

    fn sample(system: &System) -> Sample {
        Sample::of(system, &Structure::new(system, &BTreeSet::new()))
    }

    #[test]
    fn equations_that_follow_from_others_are_seen_to() {
        let polar = system(&[["x", "v*cos(a)"], ["y", "v*sin(a)"], ["v^2", "x^2 + y^2"]]);
        let sample = sample(&polar);
        let mut basis = Basis::default();
        let terms = polar.equations.iter().filter_map(|own| residual(&own.statement));
        let new: Vec<bool> = terms.map(|term| basis.add(&sample.dense(sample.slopes(&term).into_iter()))).collect();
        assert_eq!(new, [true, true, false]);
    }

    #[test]
    fn what_holds_only_where_something_vanishes_is_no_example() {
        let forces = system(&[["J", "F*t"], ["K", "G*t"], ["J", "-K"]]);
        let sample = sample(&forces);
        assert_eq!(sample.zeros(), 0, "{sample:?}");
    }

    #[test]
    fn a_contradiction_leaves_values_in_no_relation() {
        let never = system(&[["x", "1 + x^2"]]);
        assert_eq!(sample(&never).0, [generic(0, 0)]);
    }
}
