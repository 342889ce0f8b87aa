//! Whether a claim holds of the numbers of a variant.

use std::cmp::Ordering;

use momentous_expr::Expr;
use momentous_quantity::coherent_unit;
use momentous_solve::Bounded;
use momentous_solve::Real;
use momentous_solve::evaluate;

use super::super::questions::choices::claim::Claim;
use super::super::questions::choices::decision::Decision;
use super::super::sampling::variant::Worked;
use super::closeness::in_unit;

/// The words for what has no value where two sides cannot be compared.
const SIDE: &str = "a side of a comparison";

impl Claim {
    /// Whether it holds of the numbers of a variant; `None` where a side has no value.
    pub(crate) fn holds(&self, worked: &Worked<'_>) -> Option<bool> {
        self.order(worked).map(|order| self.allows(order))
    }

    /// How its sides compare, directions up to whole turns.
    fn order(&self, worked: &Worked<'_>) -> Option<Ordering> {
        let Bounded { value, error } = difference(worked, &self.left, &self.right);
        let turns = self.whole_turns(value);
        compared_with_zero(Bounded { value: value - turns, error: error + f64::EPSILON * turns.abs() })
    }

    /// Why it cannot be judged with the numbers of a variant.
    pub(super) fn refused(&self, worked: &Worked<'_>) -> Option<String> {
        self.holds(worked).is_none().then(|| no_value(SIDE))
    }

    pub(crate) fn decided(&self, worked: &Worked<'_>) -> Decision {
        let Some(order) = self.order(worked) else {
            return Decision::yes_or_no(false, no_value(SIDE));
        };
        let holds = self.allows(order);
        let is = match order {
            Ordering::Less => "less than",
            Ordering::Equal => "equal to",
            Ordering::Greater => "greater than",
        };
        let said = |words: &String, side: &Expr| {
            // A single quantity has its value where it is found, and what hangs on open letters has none.
            let is_single = matches!(side, Expr::Symbol(_) | Expr::Number(_)) || !worked.form.free.is_empty();
            let value = (!is_single).then(|| printed(worked, side)).flatten();
            value.map_or_else(|| words.clone(), |value| format!("{words} ({value})"))
        };
        let [left, right] = &self.words;
        Decision::yes_or_no(holds, format!("{} is {is} {}", said(left, &self.left), said(right, &self.right)))
    }
}

/// How two terms compare with the numbers of a variant: equal where their difference is no more than its error bound, which is
/// so only where it is exactly zero. `None` where a side has no value, as where it is divided by zero.
pub(super) fn exactly_compared(worked: &Worked<'_>, left: &Expr, right: &Expr) -> Option<Ordering> {
    compared_with_zero(difference(worked, left, right))
}

fn difference(worked: &Worked<'_>, left: &Expr, right: &Expr) -> Bounded {
    let number = |symbol| worked.variant.value(symbol).unwrap_or_else(Bounded::not_real);
    evaluate::<Bounded>(left, &number).sub(&evaluate(right, &number))
}

fn compared_with_zero(Bounded { value, error }: Bounded) -> Option<Ordering> {
    if !error.is_finite() {
        return None;
    }
    if value.abs() <= error { Some(Ordering::Equal) } else { value.partial_cmp(&0.0) }
}

/// The value of a term in its usual unit.
fn printed(worked: &Worked<'_>, term: &Expr) -> Option<String> {
    let dimension = term.dimension(&worked.problem.model().symbols).ok()?;
    in_unit(worked, term, &coherent_unit(dimension, worked.problem.units()))
}

pub(super) fn no_value(side: &str) -> String {
    format!("{side} has no value with these numbers, as where something is divided by zero")
}
