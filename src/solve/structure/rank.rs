//! Whether equations are independent, judged by the rank of their derivatives at sampled values.

use nalgebra::DMatrix;

use momentous_expr::{Expr, Symbol};

use super::super::{Statement, Step, System};
use super::basis::Span;
use super::bits::Bits;
use super::incidence::Structure;
use super::sample::generic;

/// Singular values below this share of the largest count as zero.
const NEGLIGIBLE: f64 = 1e-9;

/// Whether a square matrix of terms is singular wherever it is looked at.
pub(crate) fn singular(matrix: &[Vec<Expr>]) -> bool {
    let size = matrix.len();
    (0..2).all(|salt| {
        let value = |row: usize, column: usize| {
            matrix[row].get(column).map_or(0.0, |term| term.evaluate(&|symbol| generic(symbol.index(), salt)))
        };
        rank(&DMatrix::from_fn(size, size, value)).is_some_and(|rank| rank < size)
    })
}

/// Whether the equations of a step do not tell its unknowns apart from their neighbours at these values: a product of which the other
/// factor is zero as well holds for any value.
#[must_use]
pub fn is_singular(system: &System, step: &Step, value: &dyn Fn(Symbol) -> f64) -> bool {
    let size = step.unknowns.len();
    let equations = step.equations.iter().filter_map(|place| system.equations.get(*place));
    let mut matrix = DMatrix::zeros(step.equations.len(), size);
    for (mut row, equation) in matrix.row_iter_mut().zip(equations) {
        let Statement::Equal { left, right } = &equation.statement else { return false };
        for (side, sign) in [(left, 1.0), (right, -1.0)] {
            side.slopes(value, sign, &mut |symbol, slope| {
                if let Some(column) = step.unknowns.iter().position(|unknown| *unknown == symbol) {
                    row[column] += slope;
                }
            });
        }
        let largest = row.amax();
        row /= if largest > 0.0 { largest } else { 1.0 };
    }
    for mut column in matrix.column_iter_mut() {
        let largest = column.amax();
        column /= if largest > 0.0 { largest } else { 1.0 };
    }
    rank(&matrix).is_some_and(|rank| rank < size)
}

/// The rows of the block, where they depend on each other whatever else is known: a set that no plan can use together.
/// `gradients` are the derivatives of each row of the structure in every unknown.
pub(crate) fn dependent(structure: &Structure, gradients: &[Vec<f64>], rows: &[usize]) -> Option<Bits> {
    let mut span = Span::default();
    let independent = rows.iter().all(|row| span.add(&gradients[*row]));
    (!independent).then(|| Bits::of(structure.rows.len(), rows.iter().copied()))
}

/// The rank, where all entries are finite.
fn rank(matrix: &DMatrix<f64>) -> Option<usize> {
    if matrix.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let values = matrix.singular_values();
    Some(values.iter().filter(|value| **value > NEGLIGIBLE * values.max()).count())
}
