//! A place at which all equations hold, to look at their derivatives there. Elsewhere equations may look independent that
//! are not: with `v_x = v cos(theta)` and `v_y = v sin(theta)`, `v^2 = v_x^2 + v_y^2` says nothing new, but its derivatives
//! show that only where the first two hold.

use std::borrow::Cow;
use std::cmp::Ordering;

use nalgebra::{DMatrix, DVector};

use momentous_expr::{Expr, Symbol};

use super::super::{Statement, System};
use super::incidence::{Structure, ascending};
use super::residuals::{Residuals, Values};

/// Places from which the search for one begins.
const STARTS: u32 = 8;

/// The number of the places found that are compared.
const COMPARED: usize = 2;

/// The power of a size that sets later starts apart.
const APART: f64 = 3.0;

/// The number of steps that are taken from a start.
const STEPS: usize = 20;

/// A positive value is not made larger or smaller than by this factor in one step, as a logarithm.
const FARTHEST: f64 = 2.0;

/// Sides that differ by less are equal; the values are near one.
const EQUAL: f64 = 1e-10;

/// A value nearer to zero than this is no example: `(F_A + F_B) dt = 0` holds for `dt = 0`, whatever the forces.
const NOTHING: f64 = 0.02;

/// The damping that keeps a step short: at first, and at least, since of equations that say the same twice no step is
/// the shortest.
const DAMPING: (f64, f64) = (1e-2, 1e-10);

/// Places at which systems hold in which the same symbols are positive, each found once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Samples {
    /// Which of several sets of starts the search for them begins from.
    starts: u32,
    found: Vec<(Vec<Statement>, Sample)>,
}

impl Samples {
    /// Other places than those of other `starts`.
    pub(crate) fn from(starts: u32) -> Self {
        Self { starts, found: Vec::new() }
    }

    /// The place for the rows of a system.
    pub(super) fn of(&mut self, system: &System, structure: &Structure) -> Sample {
        let stated = stated(system, structure);
        let known = self.found.iter().find(|(sampled, _)| sampled.iter().eq(stated.iter().map(AsRef::as_ref)));
        if let Some((_, sample)) = known {
            return sample.clone();
        }
        let sample = Sample::of(system, &stated, self.starts);
        self.found.push((stated.into_iter().map(Cow::into_owned).collect(), sample.clone()));
        sample
    }

    /// Whether there is a place at which all rows of a system hold.
    pub(crate) fn hold(&mut self, system: &System, structure: &Structure) -> bool {
        self.of(system, structure).holds
    }
}

/// A value for each symbol of a system, by the position of the symbol in its table; 1 for any other.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    values: Vec<f64>,
    /// Whether everything holds there: where no such place is found, the values are in no relation to each other.
    holds: bool,
}

impl Sample {
    /// Values at which all of this holds, with as few zeros as can be; where none are found, as with
    /// equations that contradict each other, values in no relation to each other.
    fn of(system: &System, stated: &[Cow<Statement>], starts: u32) -> Self {
        let residuals = Residuals::of(&stated.iter().map(AsRef::as_ref).collect::<Vec<_>>());
        let told = stated.iter().filter(|statement| is_zero(statement)).count();
        let is_allowed = |sample: &Self| system.positive.iter().all(|symbol| sample.value(*symbol) > NOTHING);
        let start = |salt| residuals.free.iter().map(|symbol| begin(system, *symbol, salt)).collect();
        let positive: Vec<bool> = residuals.free.iter().map(|symbol| system.positive.contains(symbol)).collect();
        let salts = (0..STARTS).map(|salt| 2 * STARTS * starts + salt);
        let settled = salts.filter_map(|salt| settled(&residuals, &positive, start(salt)));
        let mut fewest: Option<Self> = None;
        for sample in settled.map(|values| Self::read(residuals.symbols(&values))).filter(is_allowed).take(COMPARED) {
            if fewest.as_ref().is_none_or(|least| sample.zeros() < least.zeros()) {
                fewest = Some(sample);
            }
            if fewest.as_ref().is_some_and(|least| least.zeros() <= told) {
                break;
            }
        }
        let generic = || {
            Self::read(
                stated
                    .iter()
                    .flat_map(|statement| symbols(statement))
                    .map(|symbol| (symbol, generic(symbol.index(), 0))),
            )
        };
        fewest.unwrap_or_else(|| Self { holds: false, ..generic() })
    }

    fn read(values: impl Iterator<Item = (Symbol, f64)>) -> Self {
        let mut all = Vec::new();
        for (symbol, value) in values {
            let place = symbol.index();
            all.resize(all.len().max(place + 1), 1.0);
            all[place] = value;
        }
        Self { values: all, holds: true }
    }

    /// The value of a symbol.
    pub(crate) fn value(&self, symbol: Symbol) -> f64 {
        self.values.get(symbol.index()).copied().unwrap_or(1.0)
    }

    fn zeros(&self) -> usize {
        self.values.iter().filter(|value| value.abs() < NOTHING).count()
    }

    /// Gives `add` the derivatives of left side minus right side, in parts: one for each place at which a symbol stands. `None` for a
    /// count, which has none.
    pub(crate) fn slopes(&self, statement: &Statement, add: &mut dyn FnMut(Symbol, f64)) -> Option<()> {
        let Statement::Equal { left, right } = statement else { return None };
        for (side, sign) in [(left, 1.0), (right, -1.0)] {
            side.slopes(&|symbol| self.value(symbol), sign, add);
        }
        Some(())
    }
}

/// A value in no relation to that of any other symbol. At every other start all are positive, as most quantities of a scene are.
fn begin(system: &System, symbol: Symbol, salt: u32) -> f64 {
    let size = generic(symbol.index(), salt);
    // Where the first starts did not do, the next ones lie farther apart: near one another, values tend to become equal.
    let size = if salt < 2 * STARTS { size } else { libm::pow(size, APART) };
    let any = salt % 2 == 1 && !system.positive.contains(&symbol);
    if any && generic(symbol.index(), salt + STARTS) < 1.0 { -size } else { size }
}

/// Moved to where all residuals are zero, by damped steps (Levenberg and Marquardt's). Values that are `positive` take theirs in
/// their logarithms, and so stay positive.
fn settled(residuals: &Residuals, positive: &[bool], start: Vec<f64>) -> Option<Values> {
    let mut damping = DAMPING.0;
    let mut place = DVector::from_vec(start);
    let mut values = residuals.at(place.as_slice());
    let mut off = residuals.off(&values)?;
    for _ in 0..STEPS {
        if off.amax() < EQUAL {
            return Some(values);
        }
        let mut slopes = residuals.slopes(&values);
        for (row, value) in place.iter().enumerate().filter(|(row, _)| positive[*row]) {
            slopes.row_mut(row).scale_mut(*value);
        }
        // Only what stands on the diagonal and below it is looked at.
        let products = DMatrix::from_fn(off.len(), off.len(), |row, column| match row.cmp(&column) {
            Ordering::Less => 0.0,
            Ordering::Equal => slopes.column(row).norm_squared() + damping,
            Ordering::Greater => slopes.column(row).dot(&slopes.column(column)),
        });
        let step = &slopes * products.cholesky()?.solve(&off);
        let moved = DVector::from_fn(place.len(), |row, _| {
            let (value, step) = (place[row], step[row]);
            if positive[row] { value * libm::exp(-step.clamp(-FARTHEST, FARTHEST)) } else { value - step }
        });
        let there = residuals.at(moved.as_slice());
        match residuals.off(&there).filter(|after| after.norm_squared() < off.norm_squared()) {
            Some(after) => {
                (place, values, off) = (moved, there, after);
                damping = (damping / 100.0).max(DAMPING.1);
            }
            None => damping *= 30.0,
        }
    }
    None
}

/// The statements of the rows, after what is fixed.
fn stated<'s>(system: &'s System, structure: &Structure) -> Vec<Cow<'s, Statement>> {
    let fixed = system
        .fixed
        .iter()
        .map(|(symbol, value)| Cow::Owned(Statement::Equal { left: (*symbol).into(), right: value.clone() }));
    let rows = structure.rows.iter().filter_map(|row| system.equations.get(row.equation));
    fixed.chain(rows.map(|equation| Cow::Borrowed(&equation.statement))).collect()
}

/// Whether an equation says no more than that a symbol is zero.
fn is_zero(statement: &Statement) -> bool {
    matches!(statement, Statement::Equal { left: Expr::Symbol(_), right } if right.is_zero())
}

fn symbols(statement: &Statement) -> Vec<Symbol> {
    match statement {
        Statement::Equal { left, right } => ascending([left, right]),
        Statement::FirstInteger { .. } => Vec::new(),
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
    use std::collections::BTreeSet;

    use super::super::super::Equation;
    use super::super::basis::Basis;
    use super::*;
    use momentous_expr::{Names, SymbolEntry, SymbolTable, parse};
    use momentous_quantity::Dimension;

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
        Samples::default().of(system, &Structure::new(system, &BTreeSet::new()))
    }

    #[test]
    fn equations_that_follow_from_others_are_seen_to() {
        let polar = system(&[["x", "v*cos(a)"], ["y", "v*sin(a)"], ["v^2", "x^2 + y^2"]]);
        let sample = sample(&polar);
        let mut basis = Basis::default();
        let gradient = |equation: &Equation| {
            let mut gradient = vec![0.0; 4];
            let stated = sample.slopes(&equation.statement, &mut |symbol, slope| gradient[symbol.index()] += slope);
            assert_eq!(stated, Some(()));
            gradient
        };
        let new: Vec<bool> = polar.equations.iter().map(|equation| basis.add(&gradient(equation))).collect();
        assert_eq!(new, [true, true, false]);
    }

    #[test]
    fn what_holds_only_where_something_vanishes_is_no_example() {
        let forces = system(&[["J", "F*t"], ["K", "G*t"], ["J", "-K"]]);
        let sample = sample(&forces);
        assert_eq!(sample.zeros(), 0, "{sample:?}");
    }

    #[test]
    fn what_is_positive_stays_so() {
        let mut fall = system(&[["v", "g*t"], ["h", "g*t^2/2"], ["w", "-2*v"]]);
        fall.positive = fall.equations.iter().take(2).flat_map(|equation| symbols(&equation.statement)).collect();
        let sample = sample(&fall);
        assert!(fall.positive.iter().all(|symbol| sample.value(*symbol) > NOTHING), "{sample:?}");
        assert!(sample.values.iter().any(|value| *value < 0.0), "{sample:?}");
    }

    #[test]
    fn a_contradiction_leaves_values_in_no_relation() {
        let never = system(&[["x", "1 + x^2"]]);
        assert_eq!(sample(&never).values, [generic(0, 0)]);
        assert!(!sample(&never).holds);
    }
}
