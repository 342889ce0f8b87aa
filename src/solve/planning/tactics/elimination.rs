//! Gauss's elimination on terms, kept as the moves that a student would write.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::block::Block;
use super::closing::Refusal;
use super::isolate::{dropped_out, linear_root};
use super::tidy::{cancelled, factors, forward, gathered, is_negative, negative, over, times};
use crate::Move;
use momentous_quantity::Rational;

/// Coefficients longer than this are not worked with: nobody would on paper.
const LONGEST: usize = 250;
/// More equations than this are not eliminated.
const LARGEST: usize = 10;

/// One equation `sum of coefficients times unknowns + rest = 0`.
#[derive(Clone, Debug)]
struct Row {
    equation: usize,
    coefficients: Vec<Expr>,
    rest: Expr,
}

/// The result of an elimination: the moves, and a value for each unknown in terms of those before it.
pub(super) struct Eliminated {
    pub(super) moves: Vec<Move>,
    pub(super) values: Vec<(Symbol, Expr)>,
}

/// Solves linear equations for the unknowns, the first unknown first: the last one is made to drop out first. Where something
/// would be divided by zero at the values that are known beforehand, what is zero there is left out before.
pub(super) fn eliminate(
    block: &Block,
    equations: &[(usize, Expr)],
    unknowns: &[Symbol],
) -> Result<Eliminated, Refusal> {
    if unknowns.len() > LARGEST {
        return Err(Refusal::NotApplicable);
    }
    let mut rows = Vec::new();
    for (equation, residual) in equations {
        let (coefficients, rest) = residual.linear_coefficients(unknowns).ok_or(Refusal::NotApplicable)?;
        rows.push(Row { equation: *equation, coefficients, rest });
    }
    if unknowns.len() > 1
        && crate::structure::rank::singular(&rows.iter().map(|row| row.coefficients.clone()).collect::<Vec<_>>())
    {
        return Err(Refusal::Dependent);
    }
    let usual = reduced(rows.clone(), unknowns, Vec::new(), &|_| false)?;
    let reduced = if usual.divides_by_nothing(block) {
        let moves = rows.iter_mut().flat_map(|row| row.leave_out(block, unknowns)).collect();
        reduced(rows, unknowns, moves, &|term| block.vanishes(term))
            .ok()
            .filter(|other| !other.divides_by_nothing(block))
            .unwrap_or(usual)
    } else {
        usual
    };
    reduced.solved(unknowns)
}

/// Equations in echelon form: the first holds the first unknown alone, each further one the next unknown and those before it.
struct Reduced {
    rows: Vec<Row>,
    moves: Vec<Move>,
}

/// Eliminates one unknown after the other, by an equation in which its coefficient is not to be avoided if there is one.
fn reduced(
    mut rows: Vec<Row>,
    unknowns: &[Symbol],
    mut moves: Vec<Move>,
    avoided: &dyn Fn(&Expr) -> bool,
) -> Result<Reduced, Refusal> {
    let mut pivots = Vec::new();
    for column in (0..unknowns.len()).rev() {
        let pivot = rows.iter().enumerate().filter(|(_, row)| !row.coefficients[column].is_zero());
        let awkwardness = |(place, row): &(usize, &Row)| {
            let coefficient = &row.coefficients[column];
            (avoided(coefficient), plainness(coefficient), usize::MAX - place)
        };
        let Some((place, _)) = pivot.min_by_key(awkwardness) else {
            return Err(rows.first().map_or(Refusal::Dependent, |row| dropped_out(&row.rest)));
        };
        let pivot = rows.remove(place);
        for row in &mut rows {
            if row.coefficients[column].is_zero() {
                continue;
            }
            let factor = cancelled(over(&negative(&row.coefficients[column]), &pivot.coefficients[column]));
            row.add(&pivot, &factor, column);
            if row.coefficients.iter().chain([&row.rest]).any(|term| term.size() > LONGEST) {
                return Err(Refusal::NotApplicable);
            }
            let (left, right) = row.sides(unknowns);
            let (equation, times) = (row.equation, pivot.equation);
            moves.push(Move::Combine { equation, times, factor, drops: unknowns[column], left, right });
        }
        pivots.push(pivot);
    }
    pivots.reverse();
    Ok(Reduced { rows: pivots, moves })
}

impl Reduced {
    /// Whether something by which an equation is divided is zero at the values that are known beforehand.
    fn divides_by_nothing(&self, block: &Block) -> bool {
        self.rows.iter().enumerate().any(|(column, row)| block.vanishes(&row.coefficients[column]))
    }

    /// Each unknown in terms of those before it.
    fn solved(self, unknowns: &[Symbol]) -> Result<Eliminated, Refusal> {
        let Self { rows, mut moves } = self;
        let mut values = Vec::new();
        for (column, row) in rows.iter().enumerate() {
            let earlier =
                values.iter().zip(&row.coefficients).map(|((symbol, _), coefficient): (&(Symbol, Expr), _)| {
                    Expr::product([coefficient.clone(), Expr::Symbol(*symbol)])
                });
            let rest = Expr::sum([row.rest.clone()].into_iter().chain(earlier));
            let value = linear_root(&row.coefficients[column], &rest)?;
            moves.push(Move::Isolate { equation: row.equation, unknown: unknowns[column], value: value.clone() });
            values.push((unknowns[column], value));
        }
        Ok(Eliminated { moves, values })
    }
}

/// How awkward it is to divide by a coefficient: 1 and -1 not at all, numbers little, short terms less than long ones.
fn plainness(coefficient: &Expr) -> usize {
    match coefficient.as_number() {
        Some(value) if value.is_one() || *value == Rational::from(-1) => 0,
        Some(_) => 1,
        None => 1 + coefficient.size(),
    }
}

impl Row {
    /// Adds a multiple of another row, from which the unknown of `column` drops out.
    fn add(&mut self, other: &Self, factor: &Expr, column: usize) {
        for (place, (coefficient, more)) in self.coefficients.iter_mut().zip(&other.coefficients).enumerate() {
            if place == column {
                *coefficient = Expr::zero();
            } else if !more.is_zero() {
                *coefficient = collected(cancelled(Expr::sum([coefficient.clone(), product(factor, more)])));
            }
        }
        if !other.rest.is_zero() {
            self.rest = cancelled(Expr::sum([self.rest.clone(), product(factor, &other.rest)]));
        }
    }

    /// Leaves out each unknown whose coefficient is zero at the values that are known beforehand.
    fn leave_out(&mut self, block: &Block, unknowns: &[Symbol]) -> Vec<Move> {
        let mut moves = Vec::new();
        for (column, drops) in unknowns.iter().enumerate() {
            let coefficient = &self.coefficients[column];
            if coefficient.is_zero() || !block.vanishes(coefficient) {
                continue;
            }
            let zero = factors(coefficient).iter().find(|factor| block.vanishes(factor));
            let zero = zero.unwrap_or(coefficient).clone();
            self.coefficients[column] = Expr::zero();
            let (left, right) = self.sides(unknowns);
            moves.push(Move::Vanish { equation: self.equation, zero, drops: *drops, left, right });
        }
        moves
    }

    /// The two sides, the unknowns on that one where most of them are written with a plus. Their difference is always
    /// the row itself, so that a multiple of what is printed is a multiple of the row.
    fn sides(&self, unknowns: &[Symbol]) -> (Expr, Expr) {
        let written = || self.coefficients.iter().filter(|coefficient| !coefficient.is_zero());
        let minus = written().filter(|coefficient| is_negative(coefficient)).count() * 2 > written().count();
        let terms = self.coefficients.iter().zip(unknowns).map(|(coefficient, unknown)| {
            let coefficient = if minus { negative(coefficient) } else { coefficient.clone() };
            Expr::product([coefficient, Expr::Symbol(*unknown)])
        });
        let with_unknowns = Expr::sum(terms);
        if minus { (forward(self.rest.clone()), with_unknowns) } else { (with_unknowns, forward(negative(&self.rest))) }
    }
}

/// The product, kept as it is written unless one of the two is a number.
fn product(factor: &Expr, term: &Expr) -> Expr {
    let each = factor.as_number().is_some() || factors(factor).len() == 1;
    gathered(&if each { times(term, factor) } else { Expr::product([factor.clone(), term.clone()]) })
}

/// Zero where the coefficient is zero by algebra, so that it is seen to be.
fn collected(coefficient: Expr) -> Expr {
    if momentous_expr::equal(&coefficient, &Expr::zero()) { Expr::zero() } else { coefficient }
}
