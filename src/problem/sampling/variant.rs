//! One variant of one form: the numbers of a seed, and everything that follows from them.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;
use momentous_solve::Bounded;
use momentous_solve::Real;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::compiling::regimes::Dead;
use super::super::compiling::regimes::Leaf;
use super::super::questions::number::unit_for;
use super::super::questions::part::AskedUnit;
use super::super::questions::part::NumberPart;
use super::stream::Scheme;

/// The numbers of one variant. Made only by [`super::super::Sampler`]: its givens satisfy what the problem requires, and exactly
/// one admissible solution belongs to them.
#[derive(Clone, Debug)]
pub struct Variant {
    pub(crate) form: usize,
    pub(crate) seed: Option<u64>,
    pub(crate) scheme: Scheme,
    pub(crate) given: Vec<(Symbol, Decimal, Unit)>,
    pub(crate) values: Vec<Option<Bounded>>,
    pub(crate) forward: Vec<Option<Bounded>>,
    pub(crate) weighed: Vec<Option<Bounded>>,
    pub(crate) others: Vec<(Symbol, Vec<Bounded>)>,
    pub(crate) leaf: usize,
    pub(crate) roots: Vec<usize>,
    pub(crate) dead: Vec<Dead>,
}

impl Variant {
    /// The position of its form.
    #[must_use]
    pub fn form(&self) -> usize {
        self.form
    }

    /// Its seed; none where the values were given by hand.
    #[must_use]
    pub fn seed(&self) -> Option<u64> {
        self.seed
    }

    /// How its numbers were drawn.
    #[must_use]
    pub fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// The same numbers without a seed: they were not drawn.
    #[must_use]
    pub fn without_seed(mut self) -> Self {
        self.seed = None;
        self
    }

    /// The value of a quantity in SI units, with a bound on its error; `None` where the form neither tells nor solves it.
    #[must_use]
    pub fn value(&self, symbol: Symbol) -> Option<Bounded> {
        self.values.get(symbol.index()).copied().flatten()
    }

    /// The same numbers with another value of each quantity that was solved and is not among those: what depends on them alone is the
    /// same for both.
    #[must_use]
    pub fn with_others_than(&self, told: &BTreeSet<Symbol>, change: impl Fn(f64) -> f64) -> Self {
        let mut changed = self.clone();
        for values in [&mut changed.values, &mut changed.forward, &mut changed.weighed] {
            let solved =
                values.iter_mut().enumerate().filter(|(index, _)| told.iter().all(|symbol| symbol.index() != *index));
            solved.filter_map(|(_, value)| value.as_mut()).for_each(|number| number.value = change(number.value));
        }
        changed
    }

    /// The value of a given, exactly as it is printed, with its unit.
    #[must_use]
    pub fn given(&self, symbol: Symbol) -> Option<(Decimal, Unit)> {
        self.given.iter().find(|(listed, ..)| *listed == symbol).map(|(_, value, unit)| (value.clone(), unit.clone()))
    }

    /// Everything that is given, in the order of the file, revealed values last.
    #[must_use]
    pub fn all_given(&self) -> &[(Symbol, Decimal, Unit)] {
        &self.given
    }

    /// Whether it has further solutions.
    #[must_use]
    pub fn has_others(&self) -> bool {
        !self.others.is_empty()
    }

    /// A quantity that is asked in each further solution.
    pub(crate) fn others_of(&self, symbol: Symbol) -> impl Iterator<Item = Bounded> {
        self.others.iter().filter(move |(other, _)| *other == symbol).flat_map(|(_, values)| values).copied()
    }

    /// Which regime it belongs to.
    #[must_use]
    pub fn leaf(&self) -> usize {
        self.leaf
    }

    /// Which root was taken in each step of the plan.
    #[must_use]
    pub fn roots(&self) -> &[usize] {
        &self.roots
    }

    /// The roots that are not solutions.
    #[must_use]
    pub fn dead(&self) -> &[Dead] {
        &self.dead
    }

    /// The unit in which a text prints a quantity.
    #[must_use]
    pub fn unit(&self, problem: &Problem, symbol: Symbol) -> Unit {
        let entry = problem.model().symbols.entry(symbol);
        let coherent = || unit_for(problem.loaded(), &entry.name, entry.dimension);
        self.given(symbol).map_or_else(coherent, |(_, unit)| unit)
    }

    /// The value that a text prints of a quantity in its unit: as given, else rounded to the problem's figures. `None` where it
    /// has none; numbers of which a text prints such a quantity are refused.
    #[must_use]
    pub fn printed_value(&self, problem: &Problem, symbol: Symbol) -> Option<Decimal> {
        if let Some((value, _)) = self.given(symbol) {
            return Some(value);
        }
        let figures = problem.loaded().draft.significant_figures();
        let solved = self.value(symbol).or_else(|| self.forward.get(symbol.index()).copied().flatten())?;
        let size = factor(self.unit(problem, symbol).factor().to_f64());
        momentous_quantity::round_to_figures(solved.div(&size).for_print(), figures)
    }
}

/// The size of a unit in SI units: the nearest double, with a bound on its error.
pub(crate) fn factor(value: f64) -> Bounded {
    let exact = value.fract() == 0.0 && value < 9e15;
    Bounded { value, error: if exact { 0.0 } else { value * f64::EPSILON / 2.0 } }
}

/// A variant with the problem that it belongs to: what explanations, figures and marking read.
#[derive(Clone, Copy, Debug)]
pub struct Worked<'a> {
    /// The problem.
    pub problem: &'a Problem,
    /// The form.
    pub form: &'a Form,
    /// The numbers.
    pub variant: &'a Variant,
}

impl<'a> Worked<'a> {
    /// The variant of that problem; `None` where it is not one of its own.
    #[must_use]
    pub fn new(problem: &'a Problem, variant: &'a Variant) -> Option<Self> {
        Some(Self { problem, form: problem.forms().get(variant.form)?, variant })
    }

    /// The answer to a part in the unit in which it is asked, with a bound on its error.
    #[must_use]
    pub fn answer(&self, number: &NumberPart) -> Bounded {
        let Some(value) = self.variant.value(number.symbol) else {
            return Bounded { value: f64::NAN, error: f64::INFINITY };
        };
        self.in_unit(value, number)
    }

    /// Every answer to a part: the first, and those of further solutions where all roots are asked for.
    #[must_use]
    pub fn answers(&self, number: &NumberPart) -> Vec<Bounded> {
        if number.every_root {
            let roots = self.every_root(number.symbol).into_iter();
            return roots.map(|value| self.in_unit(value, number)).collect();
        }
        let first = self.answer(number);
        let others = self.variant.others_of(number.symbol);
        std::iter::once(first).chain(others.map(|value| self.in_unit(value, number))).collect()
    }

    fn in_unit(&self, value: Bounded, number: &NumberPart) -> Bounded {
        let turns = self.whole_turns(number.symbol, value.value);
        let value = if turns == 0.0 {
            value
        } else {
            value.sub(&Bounded { value: turns * TAU, error: turns.abs() * TAU * f64::EPSILON })
        };
        value.div(&self.size_of(number))
    }

    /// The number of whole turns that a direction is beyond half a turn from its axis: none of what is no direction.
    #[must_use]
    pub fn whole_turns(&self, symbol: Symbol, value: f64) -> f64 {
        let kind = &self.problem.model().name(symbol).kind;
        let is_direction = matches!(kind, QuantityKind::Direction(_) | QuantityKind::CountedDirection(_));
        if is_direction && value.abs() > PI { libm::round(value / TAU) } else { 0.0 }
    }

    /// The size of the unit in which a number is asked, with a bound on its error.
    fn size_of(&self, number: &NumberPart) -> Bounded {
        let size = factor(number.size);
        match &number.unit {
            AskedUnit::Unit(_) => size,
            AskedUnit::InTermsOf(symbol, _) => {
                self.variant.value(*symbol).map_or_else(Bounded::not_real, |value| value.mul(&size))
            }
        }
    }

    /// The size of the unit in which a number is asked, in SI units.
    #[must_use]
    pub fn unit_of(&self, number: &NumberPart) -> f64 {
        self.size_of(number).value
    }

    /// The regime that the variant belongs to.
    #[must_use]
    pub fn leaf(&self) -> &'a Leaf {
        self.form.solver.leaf(self.variant.leaf)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    #[test]
    fn a_unit_larger_than_whole_doubles_reach_is_not_exact() {
        let error = |unit: &str| factor(Unit::parse(unit).unwrap().factor().to_f64()).error;
        assert_eq!((error("km"), error("h")), (0.0, 0.0));
        assert!(error("t Tm^2/s^2") > 0.0 && error("km/h") > 0.0);
    }
}
