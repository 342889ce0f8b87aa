//! The freedom that equations leave, judged by their derivatives at sampled values: equations that say the same twice
//! do not determine twice as much, whatever counting says.

use super::super::System;
use super::incidence::{Row, Structure};
use super::sample::{Sample, Samples, generic};

/// Entries below this count as zero; the entries of a sampled Jacobian are near one.
const NEGLIGIBLE: f64 = 1e-7;

/// The directions in which the unknowns may move while every equation holds: for each column, its entry in each direction.
#[derive(Clone, Debug)]
pub(crate) struct Freedom(Vec<Vec<f64>>);

impl Freedom {
    /// The null space of the system's Jacobian.
    pub(crate) fn new(system: &System, structure: &Structure, samples: &mut Samples) -> Self {
        let width = structure.unknowns.len();
        let mut rows = gradients(system, structure, samples);
        let mut pivots: Vec<usize> = Vec::new();
        for place in 0..rows.len() {
            let entries = (place..rows.len()).flat_map(|row| (0..width).map(move |column| (row, column)));
            let largest = entries.max_by(|a, b| rows[a.0][a.1].abs().total_cmp(&rows[b.0][b.1].abs()));
            let Some((row, column)) = largest.filter(|(row, column)| rows[*row][*column].abs() > NEGLIGIBLE) else {
                break;
            };
            rows.swap(place, row);
            let scale = rows[place][column];
            rows[place].iter_mut().for_each(|entry| *entry /= scale);
            let pivot = rows[place].clone();
            for (other, row) in rows.iter_mut().enumerate() {
                let factor = row[column];
                if other != place && factor != 0.0 {
                    row.iter_mut().zip(&pivot).for_each(|(entry, pivot)| *entry -= factor * pivot);
                }
            }
            pivots.push(column);
        }
        let free: Vec<usize> = (0..width).filter(|column| !pivots.contains(column)).collect();
        let entry = |column: usize, direction: usize| match pivots.iter().position(|pivot| *pivot == column) {
            Some(row) => -rows[row][direction],
            None => f64::from(u8::from(column == direction)),
        };
        Self((0..width).map(|column| free.iter().map(|direction| entry(column, *direction)).collect()).collect())
    }

    /// Whether a column is fixed, once the columns `given` are given: whether its directions are a combination of
    /// those of the given ones.
    pub(crate) fn fixes(&self, column: usize, given: &[usize]) -> bool {
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for column in given {
            let rest = reduced(self.0[*column].clone(), &basis);
            let Some(largest) = rest.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())) else { continue };
            if largest.abs() > NEGLIGIBLE {
                basis.push(rest.into_iter().map(|entry| entry / largest).collect());
            }
        }
        reduced(self.0[column].clone(), &basis).into_iter().all(|entry| entry.abs() <= NEGLIGIBLE)
    }
}

/// The remainder of a vector after its share in each vector of the basis is taken away; each of those has an entry of
/// 1.
fn reduced(mut vector: Vec<f64>, basis: &[Vec<f64>]) -> Vec<f64> {
    for other in basis {
        let Some(place) = other.iter().position(|entry| (entry - 1.0).abs() < f64::EPSILON) else { continue };
        let share = vector[place];
        vector.iter_mut().zip(other).for_each(|(entry, other)| *entry -= share * other);
    }
    vector
}

/// The derivatives of every equation, each in every unknown, where all of them hold.
pub(crate) fn gradients(system: &System, structure: &Structure, samples: &mut Samples) -> Vec<Vec<f64>> {
    let sample = &samples.of(system, structure);
    structure.rows.iter().map(|row| gradient(system, structure, row, sample)).collect()
}

/// The derivatives of one equation. A count, and an equation without a value there, are taken to depend on all that they contain.
fn gradient(system: &System, structure: &Structure, row: &Row, sample: &Sample) -> Vec<f64> {
    let mut slopes = vec![0.0; structure.unknowns.len()];
    let mut add = |symbol, slope| {
        if let Some(column) = structure.column(symbol) {
            slopes[column] += slope;
        }
    };
    let stated = system.equations.get(row.equation).and_then(|equation| sample.slopes(&equation.statement, &mut add));
    if stated.is_none() || !slopes.iter().all(|entry| entry.is_finite()) {
        row.unknowns.iter().for_each(|column| slopes[column] = generic(structure.unknowns[column].index(), 7));
    }
    slopes
}
