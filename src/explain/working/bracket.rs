//! A root that no formula gives: two trials between which it lies.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_quantity::first_place;
use momentous_quantity::unit_of_place;

use super::super::Block;
use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::derivation::Derivation;

/// To how many figures the unknown is tried.
const TRIED: i32 = 3;

/// To how many figures the difference of the sides of its equation is told, in per cent.
const SHARE: usize = 2;

/// The words where no formula gives an unknown: two trials between which the sides of its equation change places, if they do, and
/// by how much they differ there.
pub(super) fn found(display: Display<'_>, derivation: &Derivation, unknown: Symbol) -> Block {
    let opening = [
        Inline::Text("No formula gives ".into()),
        Inline::Math(display.name(unknown)),
        Inline::Text(", so it is found numerically.".into()),
    ];
    let trials = trials(display, derivation, unknown).into_iter().flatten();
    Block::Paragraph(opening.into_iter().chain(trials).collect())
}

fn trials(display: Display<'_>, derivation: &Derivation, unknown: Symbol) -> Option<Vec<Inline>> {
    let line = derivation.sources_of(unknown).into_iter().next()?;
    let measured = &display.manner(unknown).measured;
    let value = display.worked.variant.value(unknown)?.value / display.size(measured);
    let place = first_place(value) + 1 - TRIED;
    let step = unit_of_place(place);
    let tried = [(value / step).floor() * step, (value / step).ceil() * step];
    let sides = tried.map(|value| {
        let at = |symbol: Symbol| {
            if symbol == unknown { value * display.size(measured) } else { display.value_of(&Expr::from(symbol)) }
        };
        [&line.left, &line.right].map(|side| side.evaluate(&at))
    });
    if !sides.iter().map(|[left, right]| left - right).product::<f64>().is_sign_negative() {
        return None;
    }
    let figures = usize::try_from(TRIED).ok()?;
    let [low, high] = tried.map(|value| measured.put(number_math(printed(value, figures))));
    let [at_low, at_high] = sides.map(exceeds);
    let number = line.number.map_or_else(String::new, |number| format!(" of ({number})"));
    Some(vec![
        Inline::Text(" With ".into()),
        Inline::Math(Math::relation(display.name(unknown), Operator::Equals, low)),
        Inline::Text(format!(" the left side{number} is {at_low} than the right one, with ")),
        Inline::Math(high),
        Inline::Text(format!(" {at_high}: the root lies between.")),
    ])
}

/// `0.91 % greater`.
fn exceeds([left, right]: [f64; 2]) -> String {
    let share = 100.0 * (left - right) / right.abs().max(left.abs());
    let share = printed(share.abs(), SHARE);
    format!("{share} % {}", if left > right { "greater" } else { "less" })
}
