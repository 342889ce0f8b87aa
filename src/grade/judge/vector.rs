//! A vector: right where |v - t| <= tau |t|, and what is usual where it is not.

use momentous_quantity::Rational;
use momentous_quantity::Tolerance;
use momentous_quantity::Unit;
use momentous_quantity::dimension_name;

use super::super::expected::{ExpectedVector, Units};
use super::super::messages::Message;
use super::super::number::Number;
use super::super::read::VectorAnswer;
use super::super::verdict::Verdict;
use super::closeness::{capped, half_unit, reference};
use super::judgement::Judgement;

/// How far doubles may be off.
const SLACK: f64 = 1e-12;

/// Judges a vector.
pub(super) fn judge(expected: &ExpectedVector, answer: &VectorAnswer) -> Judgement {
    let Some(first) = expected.components.first() else { return Judgement::of(Verdict::Wrong, Message::Wrong) };
    let asked = &first.unit;
    let unit = answer.unit.clone().unwrap_or_default();
    let as_written = verdict(expected, &answer.components);
    let with_unit = |verdict: Verdict, message: Message| judged(as_written, expected).with_unit(verdict, message);
    if unit.is_none() && !asked.is_none() {
        let nothing = answer.components.iter().all(Number::is_zero) && as_written == Some(Verdict::Right);
        if nothing {
            return judged(as_written, expected);
        }
        return with_unit(Verdict::UnitMissing, Message::UnitMissing);
    }
    if unit.dimension() != asked.dimension() {
        let names = [&unit, asked].map(|unit| dimension_name(unit.dimension()).to_owned());
        let [given, asked] = names;
        return with_unit(Verdict::UnitWrongDimension, Message::UnitWrongDimension { given, asked });
    }
    let Some(converted) = converted(answer, &unit, asked) else {
        return Judgement::of(Verdict::Wrong, Message::Wrong);
    };
    match verdict(expected, &converted) {
        Some(verdict) if verdict.is_right() && first.units == Units::AsAsked && unit.factor() != asked.factor() => {
            Judgement::of(Verdict::UnitNotAsked, Message::UnitNotAsked(asked.to_string()))
        }
        None if as_written.is_some() => with_unit(Verdict::UnitWrong, Message::UnitWrong(unit.to_string())),
        verdict => judged(verdict, expected),
    }
}

fn converted(answer: &VectorAnswer, unit: &Unit, asked: &Unit) -> Option<Vec<Number>> {
    let ratio = unit.turning_as(asked);
    answer.components.iter().map(|component| component.scaled(&ratio)).collect()
}

fn judged(result: Option<Verdict>, expected: &ExpectedVector) -> Judgement {
    let of_contact = expected.frame.axes.iter().any(|axis| axis.letter == 'n');
    match result {
        Some(Verdict::Right) => Judgement::of(Verdict::Right, Message::Right),
        Some(Verdict::RightRounded) => Judgement::of(Verdict::RightRounded, Message::RightRounded),
        Some(Verdict::SenseReversed) => Judgement::of(Verdict::SenseReversed, Message::SenseReversed),
        Some(verdict @ Verdict::ComponentsExchanged) => {
            Judgement::of(verdict, Message::ComponentsExchanged { of_contact })
        }
        Some(verdict) => Judgement::of(verdict, Message::Slip(verdict)),
        None => Judgement::of(Verdict::Wrong, Message::Wrong),
    }
}

/// The verdict on the components, in the unit that is asked.
fn verdict(expected: &ExpectedVector, given: &[Number]) -> Option<Verdict> {
    let right: Vec<f64> = expected.components.iter().map(|component| component.value).collect();
    if right.len() != given.len() {
        return None;
    }
    let limit = tolerance(expected, &right);
    let near = |wanted: &[f64], limit: f64| {
        let difference: Vec<f64> = wanted.iter().zip(given).map(|(wanted, given)| given.to_f64() - wanted).collect();
        size(&difference) <= limit
    };
    if near(&right, limit * (1.0 - SLACK)) || within_exactly(expected, given) {
        return Some(Verdict::Right);
    }
    let slack = size(&expected.components.iter().map(|component| component.error).collect::<Vec<_>>());
    let allowance = size(&expected.components.iter().map(|component| component.allowance).collect::<Vec<_>>());
    let allowance = capped(allowance, limit, size(&right));
    let inexact = SLACK * size(&given.iter().map(Number::to_f64).collect::<Vec<_>>());
    if near(&right, limit + slack + inexact) {
        return Some(Verdict::Right);
    }
    if near(&right, allowance + slack + inexact) {
        return Some(Verdict::RightRounded);
    }
    let limit = limit.max(allowance);
    let opposite: Vec<f64> = right.iter().map(|component| -component).collect();
    if near(&opposite, limit) {
        return Some(Verdict::SenseReversed);
    }
    if let [x, y] = right.as_slice()
        && near(&[*y, *x], limit)
    {
        return Some(Verdict::ComponentsExchanged);
    }
    let mut signs = (1..1_u32 << right.len().min(3)).map(|mask| {
        let turned = |(index, component): (usize, &f64)| if mask >> index & 1 == 1 { -component } else { *component };
        right.iter().enumerate().map(turned).collect::<Vec<f64>>()
    });
    if signs.any(|turned| near(&turned, limit)) {
        return Some(Verdict::ComponentSign);
    }
    // What is only a little off is not a matter of direction.
    if near(&right, 4.0 * limit) {
        return None;
    }
    // Whatever turns an arrow and leaves its length changes at least two components.
    let turned = right.iter().zip(given).filter(|(right, given)| (given.to_f64() - *right).abs() > limit).count() > 1;
    let given = size(&given.iter().map(Number::to_f64).collect::<Vec<_>>());
    (turned && (given - size(&right)).abs() <= limit && given > 0.0).then_some(Verdict::DirectionWrong)
}

fn tolerance(expected: &ExpectedVector, right: &[f64]) -> f64 {
    let Some(first) = expected.components.first() else { return 0.0 };
    let scale = size(&expected.components.iter().map(|component| component.scale).collect::<Vec<_>>());
    first.tolerance.reach(reference(size(right), scale)).unwrap_or_else(|| half_unit(size(right), first))
}

/// The comparison of squares, which needs no root and so has an exact boundary.
fn within_exactly(expected: &ExpectedVector, given: &[Number]) -> bool {
    let Some(first) = expected.components.first() else { return false };
    let exact: Option<Vec<&Rational>> = expected.components.iter().map(|component| component.exact.as_ref()).collect();
    let Some(exact) = exact else { return false };
    let square = |sum: Rational, part: Rational| sum + &part * &part;
    let off =
        exact.iter().zip(given).map(|(right, given)| given.value().as_ref() - *right).fold(Rational::ZERO, square);
    let length = exact.iter().map(|right| (*right).clone()).fold(Rational::ZERO, square);
    match &first.tolerance {
        Tolerance::ToFigures => false,
        Tolerance::Absolute(distance) => off <= distance.to_rational() * distance.to_rational(),
        Tolerance::Relative(fraction) => off <= fraction.to_rational() * fraction.to_rational() * length,
    }
}

fn size(components: &[f64]) -> f64 {
    components.iter().map(|component| component * component).sum::<f64>().sqrt()
}
