//! The inputs of a form's programs before anything is drawn.

use momentous_quantity::Decimal;
use momentous_quantity::Unit;

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
            Origin::Any => Input::of(&Decimal::from(1), &Unit::none()),
            Origin::Drawn(_) => Input::blank(&known.unit),
        };
        put(known.symbol.index(), input);
    }
    for (symbol, quantity) in &problem.model().literals {
        put(symbol.index(), Input::of(&quantity.value, &quantity.unit));
    }
    inputs
}
