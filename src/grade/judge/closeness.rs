//! Whether a number is near enough to the right one, decided without rounding.

use dashu::base::Abs;

use crate::quantity::Rational;
use crate::quantity::Unit;

use super::super::expected::{ExpectedNumber, Tolerance};
use super::super::number::Number;

/// A value below this fraction of the problem's own scale is nothing when it is written to three figures of that scale.
const NOTHING: (u32, u32) = (1, 2000);

/// The right value, and how far from it an answer may lie. Both boundaries are inclusive.
#[derive(Debug)]
pub(super) struct Target<'a> {
    pub(super) expected: &'a ExpectedNumber,
    /// The exact value, or the double nearest to it.
    value: Rational,
    /// How far the exact value may lie from `value`.
    error: Rational,
    tolerance: Rational,
    allowance: Rational,
    /// A full turn in the unit of an angle.
    turn: Option<Rational>,
}

impl<'a> Target<'a> {
    pub(super) fn new(expected: &'a ExpectedNumber) -> Self {
        let value = expected.exact.clone().unwrap_or_else(|| rational(expected.value));
        let error = if expected.exact.is_some() { Rational::ZERO } else { bound(expected.error) };
        let turn = expected.cyclic.then(|| full_turn(&expected.unit)).flatten();
        let value = match &turn {
            Some(turn) => nearest_turn(value, turn),
            None => value,
        };
        let tolerance = match &expected.tolerance {
            _ if expected.whole => Rational::ZERO,
            Tolerance::Absolute(distance) => distance.to_rational().abs(),
            Tolerance::Relative(fraction) => fraction.to_rational().abs() * reference(expected, &value),
        };
        let allowance = if expected.whole { Rational::ZERO } else { bound(expected.allowance) };
        Self { expected, value, error, tolerance, allowance, turn }
    }

    pub(super) fn value(&self) -> &Rational {
        &self.value
    }

    /// Whether the tolerance alone accepts the number.
    pub(super) fn within_tolerance(&self, number: &Number) -> bool {
        self.is_within(number, &self.tolerance)
    }

    /// Whether honest rounding can have led to the number.
    pub(super) fn within_allowance(&self, number: &Number) -> bool {
        self.is_within(number, &self.allowance)
    }

    /// Whatever is not known exactly, of the right value and of the number, is counted in the student's favour.
    fn is_within(&self, number: &Number, limit: &Rational) -> bool {
        self.distance(number.value()) <= limit + &self.error + number.slack()
    }

    fn distance(&self, number: &Rational) -> Rational {
        let difference = number - &self.value;
        match &self.turn {
            Some(turn) => nearest_turn(difference, turn).abs(),
            None => difference.abs(),
        }
    }
}

/// What a relative tolerance is a fraction of: the value, or the problem's own scale where the value is nothing beside it.
fn reference(expected: &ExpectedNumber, value: &Rational) -> Rational {
    let (size, scale) = (value.clone().abs(), bound(expected.scale));
    let nothing = &scale * Rational::from(NOTHING.0) / Rational::from(NOTHING.1);
    if size <= nothing { scale } else { size }
}

/// An angle less whole turns, between minus half a turn and half a turn.
fn nearest_turn(angle: Rational, turn: &Rational) -> Rational {
    let turns = (&angle / turn).round();
    angle - Rational::from(turns) * turn
}

fn full_turn(unit: &Unit) -> Option<Rational> {
    let revolution = Unit::parse("rev").ok()?;
    let turn = Number::exact(Rational::ONE).scaled(&(revolution.factor() * unit.factor().power(-1)))?;
    (!turn.is_zero()).then(|| turn.value().clone())
}

/// A double as a rational; zero where it is not finite.
fn rational(value: f64) -> Rational {
    Rational::try_from(value).unwrap_or_default()
}

/// The size of a bound that was computed in double precision, a trifle widened so that it includes its boundary; nothing
/// where it is not finite.
fn bound(value: f64) -> Rational {
    Number::rounded(value).map_or(Rational::ZERO, |number| number.value().clone().abs() + number.slack())
}
