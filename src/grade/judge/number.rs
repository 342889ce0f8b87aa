//! A number: judged in its unit, then by its figures.

use momentous_quantity::Factor;
use momentous_quantity::Unit;
use momentous_quantity::dimension_name;

use super::super::expected::{ExpectedNumber, Units};
use super::super::messages::Message;
use super::super::number::Number;
use super::super::read::{NumberAnswer, Written};
use super::super::verdict::Verdict;
use super::angle;
use super::closeness;
use super::closeness::Target;
use super::figures;
use super::judgement::Judgement;
use super::slip;

/// The position of the number alone, in a unit that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Position {
    Right,
    Rounded,
    NegativeMagnitude,
    Sense,
    SenseReversed,
    Elsewhere,
}

/// Judges a number.
pub(super) fn judge(expected: &ExpectedNumber, answer: &NumberAnswer) -> Judgement {
    let target = Target::new(expected);
    let pure = expected.unit.is_none().then(Unit::none);
    let Some(unit) = answer.unit.as_ref().filter(|unit| !unit.is_none()).or(pure.as_ref()) else {
        return without_unit(&target, answer);
    };
    let directed = answer.directed();
    let same = *unit == expected.unit;
    if !same && unit.dimension() != expected.unit.dimension() {
        return other_dimension(answer, unit, &target);
    }
    let ratio = if same { Factor::ONE } else { unit.turning_as(&expected.unit) };
    let converted = if ratio.is_one() { Some(directed.clone()) } else { directed.scaled(&ratio) };
    let Some(number) = converted else { return wrong(expected, answer) };
    let judged = compare(&target, answer, &number);
    if judged != Position::Elsewhere {
        return fitting(&target, answer, &number, judged, !ratio.is_one());
    }
    let power = slip::power_of_ten(&target, &number);
    if power.is_some_and(|power| slip::is_prefix(power, expected.unit.dimension())) {
        return Judgement::of(Verdict::UnitPrefix, Message::UnitPrefix);
    }
    let as_written = compare(&target, answer, &directed);
    if as_written != Position::Elsewhere {
        let judgement = fitting(&target, answer, &directed, as_written, false);
        return judgement.with_unit(Verdict::UnitWrong, Message::UnitWrong(unit.to_string()));
    }
    if power.is_some() {
        return Judgement::of(Verdict::OrderOfMagnitude, Message::OrderOfMagnitude);
    }
    if let Some(verdict) = angle::slip(&target, &number) {
        return Judgement::of(verdict, Message::Slip(verdict));
    }
    if is_rounding_slip(&target, answer, &number) {
        return Judgement::of(Verdict::RoundingSlip, Message::RoundingSlip);
    }
    wrong(expected, answer)
}

/// Whether a number is right to one figure fewer than asked: something was rounded too early.
fn is_rounding_slip(target: &Target, answer: &NumberAnswer, number: &Number) -> bool {
    let expected = target.expected;
    let Written::Figures { least, .. } = answer.written else { return false };
    let plain = target.value() != 0.0
        && !expected.whole
        && !expected.cyclic
        && expected.figures > 1
        && least <= expected.figures;
    let reach = closeness::half_unit_before(target.value(), expected) + expected.error;
    plain && !number.is_zero() && (number.to_f64() - target.value()).abs() <= reach * (1.0 + f64::EPSILON)
}

/// Finds where the number stands: at the right value, or at its opposite.
fn compare(target: &Target, answer: &NumberAnswer, number: &Number) -> Position {
    let expected = target.expected;
    if target.within_tolerance(number) {
        return Position::Right;
    }
    if target.within_allowance(number) {
        return Position::Rounded;
    }
    let opposite = number.clone().negated();
    let turned = expected.cyclic && !expected.is_magnitude();
    if turned || expected.whole || !(target.within_tolerance(&opposite) || target.within_allowance(&opposite)) {
        return Position::Elsewhere;
    }
    if expected.is_magnitude() {
        return Position::NegativeMagnitude;
    }
    // A bare magnitude says nothing of direction; a sign or a word says the wrong one.
    if answer.signed || answer.sense.is_some() || number.is_negative() {
        Position::SenseReversed
    } else {
        Position::Sense
    }
}

/// The judgement on a number, in the unit that is asked; whether it was converted from another.
fn fitting(target: &Target, answer: &NumberAnswer, number: &Number, position: Position, converted: bool) -> Judgement {
    let expected = target.expected;
    let judgement = match position {
        Position::Right => Judgement::of(Verdict::Right, Message::Right),
        Position::Rounded => Judgement::of(Verdict::RightRounded, Message::RightRounded),
        Position::NegativeMagnitude => Judgement::of(Verdict::RightWithNote, Message::NegativeMagnitude),
        Position::Sense => Judgement::of(Verdict::Sense, Message::Sense(expected.senses.clone())),
        Position::SenseReversed => Judgement::of(Verdict::SenseReversed, Message::reversed(expected.senses.as_ref())),
        Position::Elsewhere => return wrong(expected, answer),
    };
    if !judgement.verdict.is_right() {
        return if answer.pounds_as_mass { judgement.noted(Message::PoundsAsMass) } else { judgement };
    }
    if converted && expected.units == Units::AsAsked {
        return Judgement::of(Verdict::UnitNotAsked, Message::UnitNotAsked(expected.unit.to_string()));
    }
    let judgement = if answer.pounds_as_mass { judgement.noted(Message::PoundsAsMass) } else { judgement };
    // Of a magnitude the minus sign has been noted: its figures are judged without it.
    let number = match position {
        Position::NegativeMagnitude => &number.clone().negated(),
        _ => number,
    };
    figures::judged(judgement, target, answer.written, number, converted)
}

/// The judgement on a number that stands alone.
fn without_unit(target: &Target, answer: &NumberAnswer) -> Judgement {
    let unit = &target.expected.unit;
    let directed = answer.directed();
    let as_written = compare(target, answer, &directed);
    // A fraction is as good as per cent, and an angle without a unit is in radians; nobody writes degrees that way.
    let is_pure = unit.dimension() == Unit::none().dimension();
    if is_pure
        && (!target.expected.cyclic || *unit == Unit::radian())
        && let Some(number) = directed.scaled(&Unit::none().in_terms_of(unit))
    {
        let as_pure = compare(target, answer, &number);
        if as_pure != Position::Elsewhere {
            return fitting(target, answer, &number, as_pure, true);
        }
    }
    let judgement = fitting(target, answer, &directed, as_written, false);
    // Nothing is nothing in every unit.
    if answer.number.is_zero() {
        return judgement;
    }
    judgement.with_unit(Verdict::UnitMissing, Message::UnitMissing)
}

/// The judgement on a unit that measures something else.
fn other_dimension(answer: &NumberAnswer, unit: &Unit, target: &Target) -> Judgement {
    let directed = answer.directed();
    let asked = &target.expected.unit;
    let as_written = compare(target, answer, &directed);
    let in_base_units = directed
        .scaled(&unit.in_terms_of(asked))
        .map_or(Position::Elsewhere, |number| compare(target, answer, &number));
    let position = if as_written == Position::Elsewhere { in_base_units } else { as_written };
    let multiple = target.expected.called.as_ref().and_then(|called| called.multiple_of.as_ref());
    let message = match multiple {
        Some(multiple) => Message::NoMultiple {
            of: multiple.name.clone(),
            unit: multiple.units.as_ref().map(|[_, product]| product.unicode()),
        },
        None => Message::UnitWrongDimension {
            given: dimension_name(unit.dimension()).to_owned(),
            asked: dimension_name(asked.dimension()).to_owned(),
        },
    };
    fitting(target, answer, &directed, position, true).with_unit(Verdict::UnitWrongDimension, message)
}

fn wrong(expected: &ExpectedNumber, answer: &NumberAnswer) -> Judgement {
    let is_fraction = expected.whole && !answer.number.value().is_int();
    Judgement::of(Verdict::Wrong, if is_fraction { Message::NotWhole } else { Message::Wrong })
}
