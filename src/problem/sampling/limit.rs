//! A limiting case of a variant: one of its givens at the end of what it can be.

use momentous_expr::Symbol;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;
use momentous_solve::Bounded;

use super::super::compiling::input::Input;
use super::super::compiling::regimes::Scratch;
use super::variant::Variant;
use super::variant::Worked;

impl Worked<'_> {
    /// The variant in which one of its givens has another value, such as e = 0: conditions may hold there with nothing to spare, and
    /// floating point has to do. `None` where there is no admissible solution, and for a form whose givens follow from each other.
    #[must_use]
    pub fn at_limit(&self, symbol: Symbol, value: &Decimal, unit: &Unit) -> Option<Variant> {
        if !self.form.reveal.is_empty() {
            return None;
        }
        let limit = Input::of(value, unit).bounded();
        let input = |other: &Symbol| if *other == symbol { limit } else { self.variant.value(*other) };
        let (mut scratch, regimes) = (Scratch::default(), &self.form.solver);
        let solutions = scratch.run_limit(regimes, input);
        let mut variant = Variant {
            seed: None,
            values: scratch.values(regimes, self.problem.model().symbols.len()),
            others: Vec::new(),
            leaf: scratch.leaf(),
            roots: scratch.roots(regimes),
            dead: scratch.dead(regimes),
            ..self.variant.clone()
        };
        for given in variant.given.iter_mut().filter(|(listed, ..)| *listed == symbol) {
            *given = (symbol, value.clone(), unit.clone());
        }
        for symbol in &self.form.told {
            if let Some(place) = variant.values.get_mut(symbol.index()) {
                *place = input(symbol);
            }
        }
        let there = Worked { variant: &variant, ..*self };
        let is_zero = |unit: Symbol| variant.value(unit).is_some_and(Bounded::is_zero);
        let stands = self.form.accepts(solutions) && !self.form.units().any(is_zero) && there.has_intervals();
        stands.then_some(variant)
    }
}
