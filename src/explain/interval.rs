//! The answer to a question for a range: the interval, its boundary, and the trial that tells the side.

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Operator;
use crate::problem::End;
use crate::problem::Interval;
use crate::problem::Part;
use crate::problem::RangePart;
use crate::problem::Worked;
use crate::solve::Relation;

use super::Inline;
use super::answers::shown;
use super::display::Display;
use super::display::number_math;
use super::display::printed;
use super::display::with_unit;

/// An interval as it is printed: `0.25 < e <= 1`; nothing where a variant has none.
#[must_use]
pub fn printed_range(worked: Worked<'_>, range: &RangePart) -> Option<Math> {
    let name = worked.problem.math_of(range.number.symbol);
    Some(chain(range, name, &worked.interval(range)?))
}

fn chain(range: &RangePart, name: Math, interval: &Interval) -> Math {
    let value = |end: &End| {
        let value = end.value.for_print();
        let number = if end.own { Math::Number(value.to_string()) } else { shown(&range.number, value) };
        with_unit(number, &range.number.plain_unit())
    };
    let below = |end: &End| Math::Operator(if end.closed { Operator::AtMost } else { Operator::Less });
    match (&interval.low, &interval.high) {
        (Some(low), None) => {
            Math::relation(name, if low.closed { Operator::AtLeast } else { Operator::Greater }, value(low))
        }
        (low, high) => {
            let mut row = low.iter().flat_map(|low| [value(low), below(low)]).collect::<Vec<_>>();
            row.push(name);
            row.extend(high.iter().flat_map(|high| [below(high), value(high)]));
            Math::Row(row)
        }
    }
}

/// The answer in a sentence, with the reason for the side.
pub(super) fn sentence(display: Display<'_>, part: &Part, range: &RangePart) -> Vec<Inline> {
    let Some(interval) = display.worked.interval(range) else { return Vec::new() };
    let name = || display.name(range.number.symbol);
    let claim = &range.claim;
    let at = with_unit(Math::Number(interval.trial.at.to_f64().to_string()), &range.number.plain_unit());
    let unit = match &claim.left {
        Expr::Symbol(symbol) => display.unit(*symbol).clone(),
        term => display.unit_of(term),
    };
    let left = with_unit(number_math(printed(interval.trial.left / unit.factor().to_f64(), 3)), &unit);
    let sign = match claim.relation {
        Relation::Less => Operator::Less,
        Relation::AtMost => Operator::AtMost,
        Relation::Greater => Operator::Greater,
        Relation::AtLeast => Operator::AtLeast,
        Relation::Differs => Operator::Differs,
    };
    let side = if interval.low.is_some_and(|low| !low.own) { "above" } else { "below" };
    let right = display.symbolic(&claim.right);
    vec![
        Inline::Text(format!("{} ", part.label)),
        Inline::Math(chain(range, name(), &interval)),
        Inline::Text(". On the boundary ".into()),
        Inline::Math(display.equation(&claim.left, &claim.right)),
        Inline::Text("; with ".into()),
        Inline::Math(Math::relation(name(), Operator::Equals, at)),
        Inline::Text(format!(", {side} it, ")),
        Inline::Math(Math::relation(display.symbolic(&claim.left), Operator::Equals, left)),
        Inline::Text(", so that ".into()),
        Inline::Math(Math::relation(display.symbolic(&claim.left), sign, right)),
        Inline::Text(" holds on that side and not on the other.".into()),
    ]
}
