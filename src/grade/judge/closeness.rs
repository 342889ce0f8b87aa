//! Whether a number is near enough to the right one. Doubles decide where they are far from the boundary, exact numbers where
//! they are not, so that a boundary is a boundary and the common case costs nothing.

use std::cell::OnceCell;

use dashu::base::Abs;

use momentous_quantity::MOST_TOLERANCES;
use momentous_quantity::Rational;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;
use momentous_quantity::first_place;
use momentous_quantity::unit_of_place;

use super::super::expected::ExpectedNumber;
use super::super::number::Number;

/// How near to a boundary, relative to the numbers involved, doubles are not trusted.
const UNSURE: f64 = 1e-11;

/// The right value, and how far from it an answer may lie. Both boundaries are inclusive.
#[derive(Debug)]
pub(super) struct Target<'a> {
    pub(super) expected: &'a ExpectedNumber,
    value: f64,
    tolerance: f64,
    allowance: f64,
    turn: Option<f64>,
    exact: OnceCell<Option<Exact>>,
}

/// The same in exact numbers.
#[derive(Debug)]
struct Exact {
    /// The exact value, or the double nearest to it.
    value: Rational,
    /// How far the exact value may lie from `value`.
    error: Rational,
    tolerance: Rational,
    allowance: Rational,
    /// A full turn in the unit of an angle.
    turn: Option<Rational>,
}

/// Which of the limits is meant.
#[derive(Clone, Copy)]
enum Limit {
    Tolerance,
    Allowance,
}

impl<'a> Target<'a> {
    pub(super) fn new(expected: &'a ExpectedNumber) -> Self {
        let turn = expected.cyclic.then(|| std::f64::consts::TAU / expected.size);
        let value = turn.map_or(expected.value, |turn| nearest(expected.value, turn));
        let tolerance = match &expected.tolerance {
            _ if expected.whole => 0.0,
            tolerance => {
                let reach = tolerance.reach(reference(value, expected.scale));
                reach.unwrap_or_else(|| half_unit(value, expected))
            }
        };
        // A direction has no size that rounding could be compared with.
        let size = if turn.is_some() { 0.0 } else { value };
        let allowance = if gives_nothing_away(expected) { 0.0 } else { capped(expected.allowance, tolerance, size) };
        Self { expected, value, tolerance, allowance, turn, exact: OnceCell::new() }
    }

    /// The right value, between minus half a turn and half a turn where it is an angle.
    pub(super) fn value(&self) -> f64 {
        self.value
    }

    /// A full turn, of an angle.
    pub(super) fn turn(&self) -> Option<f64> {
        self.turn
    }

    /// How far an answer may lie from the right value.
    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// How far an answer may lie from the value that is known of the right one.
    pub(super) fn reach(&self) -> f64 {
        self.tolerance + self.expected.error
    }

    /// How far honest rounding may lead from the value that is known of the right one.
    pub(super) fn allowance_reach(&self) -> f64 {
        self.allowance + self.expected.error
    }

    /// How far an answer may lie from the right one and still have its digits: no further than rounding leads, at the end or on the
    /// way. What is merely near has other digits.
    pub(super) fn reach_of_digits(&self) -> f64 {
        self.tolerance.min(self.allowance.max(half_unit(self.value, self.expected))) + self.expected.error
    }

    /// Whether a number has the digits of the right one.
    pub(super) fn has_digits(&self, number: f64) -> bool {
        let reach = self.reach_of_digits();
        (number - self.value).abs() <= reach + UNSURE * (self.value.abs() + reach)
    }

    /// Whether the tolerance alone accepts the number.
    pub(super) fn within_tolerance(&self, number: &Number) -> bool {
        self.is_within(number, Limit::Tolerance)
    }

    /// Whether honest rounding can have led to the number.
    pub(super) fn within_allowance(&self, number: &Number) -> bool {
        self.is_within(number, Limit::Allowance)
    }

    /// Whatever is not known exactly, of the right value and of the number, is counted in the student's favour.
    fn is_within(&self, number: &Number, limit: Limit) -> bool {
        let given = number.to_f64();
        let difference = given - self.value;
        let distance = self.turn.map_or(difference, |turn| nearest(difference, turn)).abs();
        let limit_near = match limit {
            Limit::Tolerance => self.tolerance,
            Limit::Allowance => self.allowance,
        } + self.expected.error;
        let unsure =
            UNSURE * (given.abs() + self.value.abs() + limit_near) + self.turn.map_or(0.0, |turn| UNSURE * turn);
        if distance < limit_near - unsure {
            return true;
        }
        if distance > limit_near + unsure {
            return false;
        }
        let exact = self.exact.get_or_init(|| Exact::of(self.expected, self.allowance));
        exact.as_ref().is_some_and(|exact| exact.is_within(number, limit))
    }
}

impl Exact {
    /// `None` where the right value is no number: nothing is near it.
    fn of(expected: &ExpectedNumber, allowance: f64) -> Option<Self> {
        let value = match &expected.exact {
            Some(exact) => exact.clone(),
            None => Rational::try_from(expected.value).ok()?,
        };
        let error = if expected.exact.is_some() { Rational::ZERO } else { bound(expected.error) };
        let turn = expected.cyclic.then(|| full_turn(&expected.unit)).flatten();
        let value = match &turn {
            Some(turn) => nearest_turn(value, turn),
            None => value,
        };
        let tolerance = match &expected.tolerance {
            _ if expected.whole => Rational::ZERO,
            Tolerance::ToFigures => half_unit_exactly(&value, expected),
            Tolerance::Absolute(distance) => distance.to_rational().abs(),
            Tolerance::Relative(fraction) => fraction.to_rational().abs() * exact_reference(expected, &value),
        };
        Some(Self { value, error, tolerance, allowance: bound(allowance), turn })
    }

    fn is_within(&self, number: &Number, limit: Limit) -> bool {
        let limit = match limit {
            Limit::Tolerance => &self.tolerance,
            Limit::Allowance => &self.allowance,
        };
        self.distance(&number.value()) <= limit + &self.error + number.slack()
    }

    fn distance(&self, number: &Rational) -> Rational {
        let difference = number - &self.value;
        match &self.turn {
            Some(turn) => nearest_turn(difference, turn).abs(),
            None => difference.abs(),
        }
    }
}

/// Whether rounding in between is not allowed for.
fn gives_nothing_away(expected: &ExpectedNumber) -> bool {
    expected.whole || expected.tolerance == Tolerance::ToFigures
}

/// The reference of a relative tolerance: the value, or what cancels in it where it is nothing.
pub(super) fn reference(value: f64, scale: f64) -> f64 {
    if value == 0.0 { scale } else { value.abs() }
}

/// How far honest rounding may lead: no further than a few tolerances, and never so far that nothing, or the opposite, would be
/// right.
pub(super) fn capped(allowance: f64, tolerance: f64, value: f64) -> f64 {
    let allowance = allowance.min(MOST_TOLERANCES * tolerance);
    if value == 0.0 { allowance } else { allowance.min(value.abs() / 2.0) }
}

fn exact_reference(expected: &ExpectedNumber, value: &Rational) -> Rational {
    if value.is_zero() { bound(expected.scale) } else { value.clone().abs() }
}

/// Half a unit of the last asked figure of a value.
pub(super) fn half_unit(value: f64, expected: &ExpectedNumber) -> f64 {
    0.5 * unit_of_place(last_place(value, expected, expected.figures))
}

/// Half a unit of the figure before the last asked one.
pub(super) fn half_unit_before(value: f64, expected: &ExpectedNumber) -> f64 {
    0.5 * unit_of_place(last_place(value, expected, expected.figures.saturating_sub(1)))
}

fn half_unit_exactly(value: &Rational, expected: &ExpectedNumber) -> Rational {
    let place = last_place(value.to_f64().value(), expected, expected.figures);
    Rational::from(10).pow(isize::try_from(place).unwrap_or(0)) / Rational::from(2)
}

/// The power of ten of a value's last figure; of a zero, that of what cancels in it.
fn last_place(value: f64, expected: &ExpectedNumber, figures: usize) -> i32 {
    let size = reference(value, expected.scale);
    if size <= 0.0 || !size.is_finite() {
        return 0;
    }
    // A decimal such as 1000 must not fall below its own power of ten by rounding.
    first_place(size * (1.0 + 4.0 * f64::EPSILON)) + 1 - i32::try_from(figures).unwrap_or(0)
}

fn nearest(angle: f64, turn: f64) -> f64 {
    angle - libm::round(angle / turn) * turn
}

/// An angle less whole turns, between minus half a turn and half a turn.
fn nearest_turn(angle: Rational, turn: &Rational) -> Rational {
    let turns = (&angle / turn).round();
    angle - Rational::from(turns) * turn
}

fn full_turn(unit: &Unit) -> Option<Rational> {
    let turn = Number::exact(Rational::ONE).scaled(&Unit::revolution().in_terms_of(unit))?;
    (!turn.is_zero()).then(|| turn.value().into_owned())
}

/// The size of a bound that was computed in double precision, a trifle widened so that it includes its boundary; nothing
/// where it is not finite.
fn bound(value: f64) -> Rational {
    Number::rounded(value).map_or(Rational::ZERO, |number| number.value().into_owned().abs() + number.slack())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_near_what_is_no_number() {
        for value in [f64::NAN, f64::INFINITY] {
            let expected = ExpectedNumber::new(value, Unit::none());
            let target = Target::new(&expected);
            let zero = Number::exact(Rational::ZERO);
            assert!(!target.within_tolerance(&zero) && !target.within_allowance(&zero), "{value}");
        }
    }
}
