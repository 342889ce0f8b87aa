//! Moves of algebra, as a student writes them.

use std::collections::BTreeMap;

use crate::expr::Expr;
use crate::expr::Function;
use crate::expr::Math;
use crate::expr::Symbol;
use crate::quantity::Rational;
use crate::solve::Move;

use super::Block;
use super::Inline;
use super::display::Display;
use super::steps::text;

/// One move in words, with the equation that it leaves; `numbers` are those of the equations that have one. Nothing for a
/// move that the result itself shows.
pub(super) fn blocks(display: Display<'_>, numbers: &BTreeMap<usize, u32>, step_move: &Move) -> Vec<Block> {
    let number = |equation: &usize| format!("({})", numbers.get(equation).copied().unwrap_or(0));
    let (words, equation) = match step_move {
        Move::Combine { equation, times, factor, drops, left, right } => {
            let (times, equation) = (number(times), number(equation));
            let mut words = if factor.is_one() {
                vec![Inline::Text(format!("Add {times} to {equation}"))]
            } else if *factor == Expr::integer(-1) {
                vec![Inline::Text(format!("Subtract {times} from {equation}"))]
            } else {
                vec![
                    Inline::Text(format!("Multiply {times} by ")),
                    Inline::Math(display.symbolic(factor)),
                    Inline::Text(format!(" and add it to {equation}")),
                ]
            };
            words.extend([
                Inline::Text(", so that ".into()),
                Inline::Math(display.name(*drops)),
                Inline::Text(" drops out:".into()),
            ]);
            (words, positive(display, left, right))
        }
        Move::Substitute { equation, unknown, value, left, right } => {
            let words = vec![
                Inline::Text("Put ".into()),
                Inline::Math(display.equation(&Expr::from(*unknown), &positive_first(value))),
                Inline::Text(format!(" into {}:", number(equation))),
            ];
            (words, display.equation(&positive_first(left), &positive_first(right)))
        }
        Move::Polar { .. } => {
            return vec![text(
                "Square and add the two equations for the magnitude; divide the second by the first for the angle.",
            )];
        }
        Move::Numeric { unknown } => return vec![by_calculation(display, *unknown)],
        Move::Isolate { .. } | Move::Quadratic { .. } | Move::Count { .. } => return Vec::new(),
    };
    vec![Block::Paragraph(words), Block::Equation { lines: vec![equation], number: None }]
}

/// What is said where no formula gives an unknown.
pub(super) fn by_calculation(display: Display<'_>, unknown: Symbol) -> Block {
    Block::Paragraph(vec![
        Inline::Text("No formula gives ".into()),
        Inline::Math(display.name(unknown)),
        Inline::Text(", so it is found numerically.".into()),
    ])
}

/// An equation, with all signs changed where its left side begins with a minus.
pub(super) fn positive(display: Display<'_>, left: &Expr, right: &Expr) -> Math {
    if left.begins_with_minus() {
        return display.equation(&(-left.clone()).simplify(), &(-right.clone()).simplify());
    }
    display.equation(left, right)
}

/// An equation, with all signs changed where both sides begin with a minus.
pub(super) fn without_common_minus(display: Display<'_>, left: &Expr, right: &Expr) -> Math {
    let both = left.begins_with_minus() && right.begins_with_minus();
    if both && !matches!(right, Expr::Sum(_)) && !matches!(left, Expr::Sum(_)) {
        return positive(display, left, right);
    }
    display.equation(left, right)
}

/// The term with every sum led by a positive part, where it has one: `b - a` for `-a + b`.
pub(super) fn positive_first(expr: &Expr) -> Expr {
    match expr {
        Expr::Sum(_) => led_by_positive(expr),
        _ => without_outer_minus(led_by_positive(expr)),
    }
}

/// The same for a part of a sum, which keeps its sign: in `m v - e (a - b)` the difference is that of a law.
fn led_by_positive(expr: &Expr) -> Expr {
    let Expr::Sum(parts) = expr else { return expr.map_children(positive_first) };
    let mut parts: Vec<Expr> = parts.iter().map(led_by_positive).collect();
    let leads = parts.iter().position(|part| !part.begins_with_minus());
    if let Some(lead) = leads.filter(|lead| *lead > 0) {
        parts[..=lead].rotate_right(1);
    }
    Expr::sum(parts)
}

/// `(b - a)/c` for `-(a - b)/c`.
fn without_outer_minus(expr: Expr) -> Expr {
    let Expr::Product(factors) = &expr else { return expr };
    let mut factors = factors.to_vec();
    let negative = factors.first().and_then(Expr::as_number).is_some_and(|number| *number < Rational::ZERO);
    let turns = |factor: &Expr| matches!(factor, Expr::Sum(parts) if parts.iter().skip(1).any(Expr::begins_with_minus));
    let (true, Some(place)) = (negative, factors.iter().position(turns)) else { return expr };
    let Expr::Sum(parts) = &factors[place] else { return expr };
    let turned = Expr::sum(parts.iter().map(|part| (-part.clone()).simplify()));
    factors[place] = positive_first(&turned);
    factors[0] = (-factors[0].clone()).simplify();
    Expr::product(factors)
}

/// Whether a term holds the angle of a point.
pub(super) fn has_angle_of_point(expr: &Expr) -> bool {
    matches!(expr, Expr::Apply(Function::Atan2, _)) || expr.children().any(has_angle_of_point)
}
