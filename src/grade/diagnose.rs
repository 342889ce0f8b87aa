//! Which usual mistake leads to a wrong answer: the answer is compared with what each mistake makes of the question.

use serde::Serialize;

use crate::quantity::round_to_figures;

use super::expected::ExpectedNumber;
use super::read::{Answer, NumberAnswer};
use super::verdict::Verdict;

/// What a wrong answer comes from, most likely.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Diagnosis {
    /// The mistakes that lead to this answer, by their stable codes. They cannot be told apart with these numbers, and so
    /// are one diagnosis; the hints speak of the first.
    pub codes: Vec<&'static str>,
    /// The step to look at, as a noun phrase; none where the mistake is outside the laws.
    pub step: Option<String>,
    /// What to tell the student, a question first, each hint plainer than the one before. None holds the right value.
    pub hints: Vec<String>,
}

/// Beyond rounding at the end, an answer may come from values that were rounded on the way: this share of it.
const ROUNDED_ON_THE_WAY: f64 = 0.006;

/// Whether a verdict leaves open where the answer comes from.
#[must_use]
pub fn is_open(verdict: Verdict) -> bool {
    matches!(
        verdict,
        Verdict::Wrong
            | Verdict::RoundingSlip
            | Verdict::Sense
            | Verdict::SenseReversed
            | Verdict::UnitPrefix
            | Verdict::OrderOfMagnitude
            | Verdict::FormulaFactor
            | Verdict::FormulaDimension
    )
}

/// The number of an answer in the unit of the question; as it stands where it has no unit, `None` where its unit measures
/// something else.
#[must_use]
pub fn number(expected: &ExpectedNumber, answer: &Answer) -> Option<f64> {
    let Answer::Number(answer) = answer else { return None };
    let own = answer.directed().to_f64();
    let value = match unit(answer) {
        None => own,
        Some(unit) if unit.dimension() == expected.unit.dimension() => {
            own * (unit.factor() * expected.unit.factor().power(-1)).to_f64()
        }
        Some(_) => return None,
    };
    value.is_finite().then_some(value)
}

fn unit(answer: &NumberAnswer) -> Option<&crate::quantity::Unit> {
    answer.unit.as_ref().filter(|unit| !unit.is_none())
}

/// The suspects that lead to the answer: those within its rounding, or the nearest within that of the values on the way.
/// Suspects that give the right answer here are none.
#[must_use]
pub fn matching(expected: &ExpectedNumber, answer: f64, suspects: &[f64]) -> Vec<usize> {
    let turn = expected.cyclic.then(|| std::f64::consts::TAU / expected.unit.factor().to_f64());
    let distance = |one: f64, other: f64| match turn {
        Some(turn) => libm::fabs(libm::remainder(one - other, turn)),
        None => (one - other).abs(),
    };
    let rounding = |value: f64| {
        let last = half_unit(value, expected.figures);
        if expected.whole { 0.0 } else { last * 1.001 + 1e-9 * value.abs() }
    };
    let is_right = |value: f64| distance(value, expected.value) <= rounding(expected.value).min(expected.allowance);
    let candidates: Vec<(usize, f64)> = suspects
        .iter()
        .enumerate()
        .filter(|(_, value)| !is_right(**value))
        .map(|(place, value)| (place, distance(*value, answer)))
        .collect();
    let within = |limit: &dyn Fn(f64) -> f64| -> Vec<usize> {
        let near = candidates.iter().filter(|(place, away)| *away <= limit(suspects[*place]));
        near.map(|(place, _)| *place).collect()
    };
    let exact = within(&rounding);
    if !exact.is_empty() || expected.whole {
        return exact;
    }
    let loose = within(&|value: f64| rounding(value).max(ROUNDED_ON_THE_WAY * value.abs()));
    let nearest = candidates.iter().filter(|(place, _)| loose.contains(place)).map(|(_, away)| *away);
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    let beside =
        |place: &usize| candidates.iter().any(|(own, away)| own == place && *away <= nearest + rounding(answer));
    loose.into_iter().filter(|place| beside(place)).collect()
}

/// Half a unit of the last of so many figures.
fn half_unit(value: f64, figures: usize) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return 0.0;
    }
    let leading = libm::floor(libm::log10(value.abs()));
    #[allow(clippy::cast_precision_loss, reason = "figures are at most 12")]
    let last = leading - (figures as f64 - 1.0);
    0.5 * libm::pow(10.0, last)
}

/// Whether an answer is the right one cut to two figures: rounding, not a wrong method.
#[must_use]
pub fn is_coarse(expected: &ExpectedNumber, answer: f64) -> bool {
    let rounded = round_to_figures(expected.value, 2).map(|value| value.to_f64());
    expected.figures > 2 && !expected.whole && rounded.is_some_and(|value| (value - answer).abs() <= 1e-9 * value.abs())
}
