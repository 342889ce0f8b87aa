//! Whether equations are independent, judged by the rank of their derivatives at sampled values.

use nalgebra::DMatrix;

use crate::expr::{Expr, Symbol};

use super::bits::Bits;
use super::structure::Structure;
use super::{Statement, System};

/// Singular values below this share of the largest count as zero.
const NEGLIGIBLE: f64 = 1e-9;

/// The step of the central difference that stands for a derivative.
const STEP: f64 = 1e-5;

/// A fixed value for each symbol, between 1/2 and 3/2, in no relation to that of any other.
pub(super) fn sample(symbol: Symbol, salt: u32) -> f64 {
    let index = u32::try_from(symbol.index()).unwrap_or(u32::MAX);
    let mixed = index.wrapping_add(salt.wrapping_mul(977)).wrapping_add(1).wrapping_mul(2_654_435_761);
    0.5 + f64::from(mixed ^ (mixed >> 15)) / f64::from(u32::MAX)
}

/// Whether a square matrix of terms is singular wherever it is looked at.
pub(super) fn singular(matrix: &[Vec<Expr>]) -> bool {
    let size = matrix.len();
    (0..2).all(|salt| {
        let value = |row: usize, column: usize| {
            matrix[row].get(column).map_or(0.0, |term| term.evaluate(&|symbol| sample(symbol, salt)))
        };
        rank(&DMatrix::from_fn(size, size, value)).is_some_and(|rank| rank < size)
    })
}

/// The rows of the block, where they depend on each other whatever else is known: a set that no plan can use together.
/// The derivatives are those in every unknown, found by central differences; they are only ever compared with zero.
pub(super) fn dependent(system: &System, structure: &Structure, rows: &[usize]) -> Option<Bits> {
    let residuals: Option<Vec<Expr>> = rows
        .iter()
        .map(|row| match &system.equations.get(structure.rows[*row].equation)?.statement {
            Statement::Equal { left, right } => Some(left.clone() - right.clone()),
            Statement::FirstInteger { .. } => None,
        })
        .collect();
    let residuals = residuals?;
    let unknowns: Vec<Symbol> = structure.columns(rows).iter().map(|column| structure.unknowns[column]).collect();
    let derivative = |row: usize, column: usize| slope(&residuals[row], unknowns[column]);
    let rank = rank(&DMatrix::from_fn(rows.len(), unknowns.len(), derivative))?;
    (rank < rows.len()).then(|| Bits::of(structure.rows.len(), rows.iter().copied()))
}

/// The derivative at the sampled values, by a central difference.
pub(super) fn slope(expr: &Expr, by: Symbol) -> f64 {
    let at = |shift: f64| expr.evaluate(&|symbol| sample(symbol, 0) + if symbol == by { shift } else { 0.0 });
    (at(STEP) - at(-STEP)) / (2.0 * STEP)
}

/// The rank, where all entries are finite.
fn rank(matrix: &DMatrix<f64>) -> Option<usize> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let values = matrix.singular_values();
    Some(values.iter().filter(|value| **value > NEGLIGIBLE * values.max()).count())
}
