//! Points at which formulas are evaluated: near the problem's own variants, off any grid, and known to nobody beforehand.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Rational;
use momentous_solve::Bounded;
use momentous_solve::Exact;
use momentous_solve::Precise;
use momentous_solve::Real;
use momentous_solve::evaluate;

use super::expected::ExpectedFormula;

/// A given that is the same in every variant is moved by this share of it, to tell functions apart.
const SPREAD: (i64, i64) = (1, 2);
/// A point lies within this share of a given's range around a variant's own value: less than a step, as a rule.
const NEAR: (i64, i64) = (1, 1024);
/// The points tried where a formula may have no value; at so many of them with many digits.
const TRIED: usize = 400;
const TRIED_AT_LENGTH: usize = 12;
/// The smallest denominator of a point's place within its range; the largest is twice as large.
const LEAST_DENOMINATOR: u64 = 1 << 30;

/// A value for every symbol of a formula.
pub(super) type Point = Vec<(Symbol, Rational)>;

/// An endless sequence of points, the same on every platform.
pub(super) struct Points<'a> {
    expected: &'a ExpectedFormula,
    state: u64,
}

impl<'a> Points<'a> {
    /// Points that hang on the formulas that are to be evaluated there: a formula cannot be made to vanish at all of them.
    pub(super) fn new(expected: &'a ExpectedFormula, formulas: &[&Expr]) -> Self {
        let texts = formulas.iter().map(|formula| formula.text(&expected.symbols));
        // The hash of Fowler, Noll and Vo.
        let hash = |state: u64, byte: u8| (state ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let state = texts.fold(0xcbf2_9ce4_8422_2325, |state, text| text.bytes().chain([0]).fold(state, hash));
        Self { expected, state }
    }

    /// The next random word, by `SplitMix64`.
    fn word(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }
}

impl Iterator for Points<'_> {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        let expected = self.expected;
        let denominator = LEAST_DENOMINATOR + self.word() % LEAST_DENOMINATOR;
        let count = u64::try_from(expected.samples.len()).unwrap_or(1).max(1);
        let sample = usize::try_from(self.word() % count).ok().and_then(|place| expected.samples.get(place));
        let exact = |value: f64| Rational::try_from(value).unwrap_or_default();
        let place = |(position, (symbol, low, high)): (usize, &(Symbol, f64, f64))| {
            let share = Rational::from(self.word() % (denominator - 1) + 1) / Rational::from(denominator);
            let [low, high] = [*low, *high].map(exact);
            let (low, high) = match sample.and_then(|sample| sample.get(position).copied().flatten()) {
                _ if low == high => {
                    let spread = &low * Rational::from(SPREAD.0) / Rational::from(SPREAD.1);
                    (&low - &spread, high + spread)
                }
                Some(point) => {
                    let (at, reach) = (exact(point), (&high - &low) * Rational::from(NEAR.0) / Rational::from(NEAR.1));
                    (low.max(&at - &reach), high.min(at + reach))
                }
                None => (low, high),
            };
            (*symbol, &low + (high - &low) * share)
        };
        Some(expected.domain.iter().enumerate().map(place).collect())
    }
}

/// The value of a formula at a point.
pub(super) fn value<R: Real>(formula: &Expr, point: &Point) -> R {
    let exact = |value: &Rational| R::from_exact(&Exact::from(value.clone()));
    let values: Vec<(Symbol, R)> = point.iter().map(|(symbol, value)| (*symbol, exact(value))).collect();
    let of = |symbol: Symbol| {
        let entry = values.iter().find(|(listed, _)| *listed == symbol);
        entry.map_or_else(R::not_real, |(_, value)| value.clone())
    };
    evaluate(formula, &of)
}

/// Whether a value is certified to be finite.
pub(super) fn is_certain<R: Real>(value: &R) -> bool {
    value.is_real() && !value.is_unbounded() && value.rough().is_finite()
}

/// Whether a formula has no real value for any values that the problem can have.
pub(super) fn has_no_value(expected: &ExpectedFormula, formula: &Expr) -> bool {
    let mut at_length = 0;
    for point in Points::new(expected, &[formula]).take(TRIED) {
        let quick: Bounded = value(formula, &point);
        if is_certain(&quick) {
            return false;
        }
        if quick.is_real() {
            let exact: Precise = value(formula, &point);
            at_length += 1;
            if exact.is_real() || at_length == TRIED_AT_LENGTH {
                return !exact.is_real();
            }
        }
    }
    true
}
