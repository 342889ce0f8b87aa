//! The answer to a question for a range: the interval, its boundary, and the trial that tells the side.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_problem::Part;
use momentous_problem::RangePart;

use super::super::Inline;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::super::terms::display::with_unit;
use super::super::terms::printed::chain;
use super::super::terms::term::Measured;

/// The answer in a sentence, with the reason for the side.
pub(crate) fn sentence(display: Display<'_>, part: &Part, range: &RangePart) -> Vec<Inline> {
    let Some(interval) = display.worked.interval(range) else { return Vec::new() };
    let name = || display.name(range.number.symbol);
    let claim = &range.claim;
    let at = with_unit(Math::Number(interval.trial.at.to_f64().to_string()), &range.number.plain_unit());
    let measured = display.measured_along(display.worked.steps_tried(range, &interval.trial), &claim.left);
    let left = measured.map(|measured| match (&measured.letters, &claim.left) {
        (None, Expr::Symbol(symbol)) => Measured::new(display.unit(*symbol).clone()),
        _ => measured,
    });
    let left =
        left.map(|measured| measured.put(number_math(printed(interval.trial.left / display.size(&measured), 3))));
    let side = if interval.low.is_some_and(|low| !low.is_limit) { "above" } else { "below" };
    let right = display.symbolic(&claim.right);
    let mut words = Inline::line(&format!("{} ", part.label));
    words.extend([
        Inline::Math(chain(range, name(), &interval)),
        Inline::Text(". On the boundary ".into()),
        Inline::Math(display.equation(&claim.left, &claim.right)),
        Inline::Text("; with ".into()),
        Inline::Math(Math::relation(name(), Operator::Equals, at)),
        Inline::Text(format!(", {side} it, ")),
    ]);
    if let Some(left) = left {
        let is = Math::relation(display.symbolic(&claim.left), Operator::Equals, left);
        words.extend([Inline::Math(is), Inline::Text(", so that ".into())]);
    }
    words.extend([
        Inline::Math(Math::relation(display.symbolic(&claim.left), claim.relation.operator(), right)),
        Inline::Text(" holds on that side and not on the other.".into()),
    ]);
    words
}
