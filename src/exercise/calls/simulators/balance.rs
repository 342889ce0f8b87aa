//! A quantity of two bodies before and after an impact.

use serde::Serialize;

use super::Amount;

/// A quantity before and after, with the lengths of its bars as shares of the greatest.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Balance {
    /// Whose it is.
    pub name: &'static str,
    /// Before.
    pub before: Amount,
    /// After.
    pub after: Amount,
    /// Both as shares of the greatest in the table, -1 to 1.
    pub bars: [f64; 2],
}

/// The quantity of A, of B and of both together.
pub(super) fn balance(before: &[f64], after: &[f64], unit: &str) -> Vec<Balance> {
    let with_total = |each: &[f64]| [each, &[each.iter().sum()]].concat();
    let (before, after) = (with_total(before), with_total(after));
    let scale = before.iter().chain(&after).map(|value| value.abs()).fold(0.0, f64::max);
    let amount = |value: &f64| Amount::new(*value, scale, unit);
    let share = |amount: &Amount| if scale > 0.0 { amount.value / scale } else { 0.0 };
    let rows = ["A", "B", "together"].into_iter().zip(before.iter().map(amount)).zip(after.iter().map(amount));
    rows.map(|((name, before), after)| Balance { name, bars: [share(&before), share(&after)], before, after }).collect()
}
