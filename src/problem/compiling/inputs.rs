//! The inputs of a form's programs before anything is drawn.

use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;

use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::input::Input;
use super::planned::Form;
use super::planned::Problem;

/// The inputs of a form by symbol: fixed values are in place, drawn ones follow with each seed.
pub(crate) fn inputs(problem: &Problem, form: &Form) -> Vec<Input> {
    let mut inputs = vec![Input::default(); problem.model().symbols.len()];
    let mut put = |index: usize, input: Input| {
        if let Some(place) = inputs.get_mut(index) {
            *place = input;
        }
    };
    for known in &form.known {
        let input = match &known.origin {
            Origin::Fixed(value) => Input::of(value, &known.unit),
            Origin::Any => Input::of(&stand_in(problem, known), &Unit::none()),
            Origin::Drawn(_) => Input::blank(&known.unit),
        };
        put(known.symbol.index(), input);
    }
    for (symbol, quantity) in &problem.model().literals {
        put(symbol.index(), Input::of(&quantity.value, &quantity.unit));
    }
    inputs
}

/// The value that stands for one that may be anything: one, and for a pure number by which others are multiplied a value
/// by which nothing cancels.
fn stand_in(problem: &Problem, known: &Known) -> Decimal {
    let symbols = &problem.model().symbols;
    let is_factor = symbols.entry(known.symbol).dimension == Dimension::NONE && !symbols.is_described(known.symbol);
    if is_factor { Decimal::from_scaled(17, 1) } else { Decimal::from(1) }
}
