//! Whether equations are independent, judged by the rank of their derivatives at sampled values.

use nalgebra::DMatrix;

use momentous_expr::Expr;

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
