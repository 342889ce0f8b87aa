//! # Tear
//!
//! *Closes:* k equations of which k - 1 are linear in k - 1 of the unknowns, when what is left after substitution can be
//! isolated, is of second degree, or gives the tangent of an angle.
//!
//! *On paper:* write all other unknowns in one, substitute, solve for the one; then the others follow.
//! Momentum and energy together: `v_A2` from momentum, put into the energy.
//!
//! *Refuses:* more than [`LARGEST`] equations, and blocks that are nonlinear in more than one equation.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::is_curved;

use super::block::Block;
use super::closing::{Closing, Refusal};
use super::elimination::{Eliminated, eliminate};
use super::isolate::isolated;
use super::quadratic::rooted;
use super::tangent::divided;
use super::tidy::{difference, shorter};
use crate::{Closed, Move, Root};

/// The largest block that is torn.
const LARGEST: usize = 6;

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let size = block.unknowns.len();
    if !(2..=LARGEST).contains(&size) {
        return Err(Refusal::NotApplicable);
    }
    let residuals = block.residuals().ok_or(Refusal::NotApplicable)?;
    let equations: Vec<(usize, Expr)> = block.equations.iter().copied().zip(residuals).collect();
    let mut last: Vec<usize> = (0..size).collect();
    last.sort_by_cached_key(|place| !is_curved(&equations[*place].1, &block.unknowns));
    let mut refusal = Refusal::NotApplicable;
    for unknown in &block.unknowns {
        let others: Vec<Symbol> = block.unknowns.iter().copied().filter(|other| other != unknown).collect();
        let bent: Vec<usize> = (0..size).filter(|place| is_curved(&equations[*place].1, &others)).collect();
        // Where two equations are not linear in the others, neither can be the one that is left.
        for place in last.iter().filter(|place| bent.iter().all(|bent| bent == *place)) {
            match torn(block, &equations, *place, *unknown) {
                Ok(closing) => return Ok(closing),
                Err(Refusal::NotApplicable) => {}
                Err(other) => refusal = other,
            }
        }
    }
    Err(refusal)
}

/// Writes all other unknowns in `unknown` and puts them into the equation at `place`.
fn torn(block: &Block, equations: &[(usize, Expr)], place: usize, unknown: Symbol) -> Result<Closing, Refusal> {
    let others: Vec<Symbol> = block.unknowns.iter().copied().filter(|other| *other != unknown).collect();
    let mut linear = equations.to_vec();
    let (equation, residual) = linear.remove(place);
    let Eliminated { mut moves, values } = eliminate(block, &linear, &others)?;
    let (left, right) = block.sides(equation).ok_or(Refusal::NotApplicable)?;
    let (mut left, mut right) = (left.clone(), right.clone());
    // On paper the last value goes in first: it may hold those before it.
    for (other, value) in values.iter().rev() {
        if [&left, &right].into_iter().any(|side| side.contains(*other)) {
            let step = [(*other, value.clone())];
            (left, right) = (put(&left, &step), put(&right, &step));
            let (left, right) = (left.clone(), right.clone());
            moves.push(Move::Substitute { equation, unknown: *other, value: value.clone(), left, right });
        }
    }
    let mut rest = residual;
    let mut written: Vec<(Symbol, Expr)> = Vec::new();
    for (other, value) in &values {
        let step = [(*other, shorter(put(value, &written)))];
        rest = put(&rest, &step);
        written.extend(step);
    }
    if let Some((square, root)) = squared(&left, &right, &|symbol| block.positive(symbol)) {
        rest = difference(&square, &root);
        moves.push(Move::Square { equation, left: square, right: root });
    }
    let roots = match isolated(&shorter(rest.clone()), &Expr::zero(), unknown, &|symbol| block.positive(symbol)) {
        Ok(roots) => {
            let value = roots.first().cloned().ok_or(Refusal::NotApplicable)?;
            moves.push(Move::Isolate { equation, unknown, value });
            roots
        }
        Err(Refusal::NotApplicable) => {
            let positive = |symbol| block.positive(symbol);
            if let Some(rooted) = rooted(&rest, equation, unknown, &positive) {
                moves.extend(rooted.moves);
                rooted.values
            } else {
                let divided = divided(&rest, equation, unknown, &positive).ok_or(Refusal::NotApplicable)?;
                moves.extend(divided.moves);
                divided.values
            }
        }
        Err(other) => return Err(other),
    };
    let root = |root: Expr| Root {
        values: [(unknown, root)]
            .into_iter()
            .chain(values.iter().cloned())
            .map(|(symbol, value)| (symbol, Closed::Formula(value)))
            .collect(),
    };
    Ok(Closing {
        unknowns: [unknown].into_iter().chain(others).collect(),
        roots: roots.into_iter().map(root).collect(),
        moves,
    })
}

/// `s^2 = x` from `s = sqrt(x)`, where s is positive, so that squaring adds no root.
fn squared(left: &Expr, right: &Expr, positive: &dyn Fn(Symbol) -> bool) -> Option<(Expr, Expr)> {
    let half = |side: &Expr| match side {
        Expr::Power(pair) if pair.1 == Expr::ratio(1, 2) => Some(pair.0.clone()),
        _ => None,
    };
    match left {
        Expr::Symbol(size) if positive(*size) => Some((left.clone().powi(2), half(right)?)),
        _ => None,
    }
}

fn put(expr: &Expr, values: &[(Symbol, Expr)]) -> Expr {
    expr.substitute(&|symbol| values.iter().find(|(known, _)| *known == symbol).map(|(_, value)| value.clone()))
}
