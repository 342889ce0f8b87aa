//! # Tangent
//!
//! *Closes:* one equation `a sin(theta) + b cos(theta) = 0` for theta.
//!
//! *On paper:* divide by the cosine: `tan(theta) = -b/a`, and both angles that have this tangent.
//!
//! *Refuses:* parts without the sine or the cosine, and theta standing anywhere else.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_expr::equal;

use super::block::Block;
use super::closing::{Closing, Refusal, ValuesOfUnknown};
use super::isolate::isolated;
use super::tidy::{cancelled, difference, forward, is_negative, negative, over, replaced};
use crate::Move;

pub(super) fn close(block: &Block) -> Result<Closing, Refusal> {
    let (equation, left, right, unknown) = block.single().ok_or(Refusal::NotApplicable)?;
    let positive = |symbol| block.positive(symbol);
    let roots = divided(&difference(left, right), equation, unknown, &positive).ok_or(Refusal::NotApplicable)?;
    Ok(roots.closing(unknown))
}

/// Divides an equation, all of it on one side, by the cosine of the angle in which the unknown stands.
pub(super) fn divided(
    residual: &Expr,
    equation: usize,
    unknown: Symbol,
    positive: &dyn Fn(Symbol) -> bool,
) -> Option<ValuesOfUnknown> {
    let angle = angle_of(residual, unknown)?;
    let [sine, cosine] = [Function::Sin, Function::Cos].map(|function| Expr::apply(function, angle.clone()));
    let with = |of_sine: i64, of_cosine: i64| {
        let put = replaced(residual, &sine, &Expr::integer(of_sine));
        replaced(&put, &cosine, &Expr::integer(of_cosine)).simplify()
    };
    let (of_sine, of_cosine, rest) = (with(1, 0), with(0, 1), with(0, 0));
    let sum = of_sine.clone() * sine + of_cosine.clone() * cosine;
    let depends = [&of_sine, &of_cosine].into_iter().any(|part| part.contains(unknown));
    if depends || of_sine.is_zero() || !equal(&rest, &Expr::zero()) || !equal(residual, &sum) {
        return None;
    }
    let minus = is_negative(&of_sine);
    let ratio = if minus { over(&of_cosine, &negative(&of_sine)) } else { over(&negative(&of_cosine), &of_sine) };
    let (left, right) = (Expr::apply(Function::Tan, angle), forward(cancelled(ratio)));
    let values = isolated(&left, &right, unknown, positive).ok()?;
    let value = values.first()?.clone();
    let moves = vec![Move::Tangent { equation, left, right }, Move::Isolate { equation, unknown, value }];
    Some(ValuesOfUnknown { moves, values })
}

/// The angle of the first sine or cosine in which the unknown stands.
fn angle_of(term: &Expr, unknown: Symbol) -> Option<Expr> {
    match term {
        Expr::Apply(Function::Sin | Function::Cos, parts) => {
            parts.first().filter(|angle| angle.contains(unknown)).cloned()
        }
        other => other.children().find_map(|part| angle_of(part, unknown)),
    }
}
