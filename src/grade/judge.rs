//! Judging: an answer that was read against the exact value. It knows no text and no points.

mod closeness;
mod slip;

use crate::quantity::Factor;
use crate::quantity::Unit;
use crate::quantity::dimension_name;

use super::expected::{Expected, ExpectedKind, ExpectedNumber};
use super::messages::Message;
use super::number::Number;
use super::read::{Answer, ChoiceAnswer, NumberAnswer, Written};
use super::verdict::Verdict;
use closeness::Target;

/// What was found about an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Judgement {
    /// The verdict that is reported.
    pub verdict: Verdict,
    /// A second finding that costs points too: a missing unit beside a missing sign.
    pub also: Option<Verdict>,
    /// What the student is told, the most important first.
    pub messages: Vec<Message>,
}

/// Judges an answer to a part.
#[must_use]
pub fn judge(expected: &Expected, answer: &Answer) -> Judgement {
    match (&expected.kind, answer) {
        (ExpectedKind::Number(number), Answer::Number(answer)) => judge_number(number, answer),
        (ExpectedKind::Choice { right, because, .. }, Answer::Choice(answer)) => judge_choice(*right, because, answer),
        // Reading answers a part in its own kind; an answer of another kind is none to this part.
        _ => Judgement::of(Verdict::Wrong, Message::Wrong),
    }
}

fn judge_choice(right: usize, because: &str, answer: &ChoiceAnswer) -> Judgement {
    if answer.option == right {
        Judgement::of(Verdict::Right, Message::RightBecause(because.to_owned()))
    } else {
        Judgement::of(Verdict::ChoiceWrong, Message::ChoiceWrong)
    }
}

/// What was found about the number alone, in a unit that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Found {
    Right,
    Rounded,
    NegativeMagnitude,
    Sense,
    SenseReversed,
    Elsewhere,
}

fn judge_number(expected: &ExpectedNumber, answer: &NumberAnswer) -> Judgement {
    let target = Target::new(expected);
    let found = |number: Option<Number>| number.map_or(Found::Elsewhere, |number| compare(&target, answer, &number));
    let as_written = found(Some(answer.directed()));
    let pure = expected.unit.is_none().then(Unit::none);
    let Some(unit) = answer.unit.as_ref().filter(|unit| !unit.is_none()).or(pure.as_ref()) else {
        return without_unit(expected, answer, as_written, found(in_asked_unit(expected, answer, &Unit::none())));
    };
    if unit.dimension() != expected.unit.dimension() {
        return other_dimension(expected, answer, unit, as_written, &target);
    }
    let converted = in_asked_unit(expected, answer, unit);
    let judged = found(converted.clone());
    if judged != Found::Elsewhere {
        return fitting(expected, answer, judged);
    }
    let slip = converted.and_then(|number| slip::power_of_ten(&target, &number));
    match slip {
        Some(power) if slip::is_prefix(power, expected.unit.dimension()) => {
            Judgement::of(Verdict::UnitPrefix, Message::UnitPrefix)
        }
        Some(_) => Judgement::of(Verdict::OrderOfMagnitude, Message::OrderOfMagnitude),
        None if as_written == Found::Elsewhere => wrong(expected, answer),
        None => {
            fitting(expected, answer, as_written).with_unit(Verdict::UnitWrong, Message::UnitWrong(unit.to_string()))
        }
    }
}

/// Where the number stands: at the right value, or at its opposite.
fn compare(target: &Target, answer: &NumberAnswer, number: &Number) -> Found {
    let expected = target.expected;
    if target.within_tolerance(number) {
        return Found::Right;
    }
    if target.within_allowance(number) {
        return Found::Rounded;
    }
    let opposite = number.clone().negated();
    if expected.cyclic || expected.whole || !(target.within_tolerance(&opposite) || target.within_allowance(&opposite))
    {
        return Found::Elsewhere;
    }
    if expected.magnitude {
        return Found::NegativeMagnitude;
    }
    // A bare magnitude says nothing of direction; a sign or a word says the wrong one.
    if answer.signed || answer.sense.is_some() || number.is_negative() { Found::SenseReversed } else { Found::Sense }
}

/// The answer's number in the unit that is asked.
fn in_asked_unit(expected: &ExpectedNumber, answer: &NumberAnswer, unit: &Unit) -> Option<Number> {
    answer.directed().scaled(&ratio(unit, &expected.unit))
}

fn ratio(unit: &Unit, other: &Unit) -> Factor {
    unit.factor() * other.factor().power(-1)
}

/// The judgement on a number whose unit fits.
fn fitting(expected: &ExpectedNumber, answer: &NumberAnswer, found: Found) -> Judgement {
    let judgement = match found {
        Found::Right => Judgement::of(Verdict::Right, Message::Right),
        Found::Rounded => Judgement::of(Verdict::RightRounded, Message::RightRounded),
        Found::NegativeMagnitude => Judgement::of(Verdict::RightWithNote, Message::NegativeMagnitude),
        Found::Sense => Judgement::of(Verdict::Sense, Message::Sense(expected.senses.clone())),
        Found::SenseReversed => Judgement::of(Verdict::SenseReversed, Message::SenseReversed),
        Found::Elsewhere => return wrong(expected, answer),
    };
    let judgement = if answer.pounds_as_mass { judgement.noted(Message::PoundsAsMass) } else { judgement };
    if judgement.verdict.is_right() { judgement.told(figures(expected, answer)) } else { judgement }
}

/// Advice on the writing of a right number: it never costs marks.
fn figures(expected: &ExpectedNumber, answer: &NumberAnswer) -> Option<Message> {
    let Written::Figures { least, most } = answer.written else { return None };
    if expected.whole || answer.number.is_zero() {
        return None;
    }
    // One figure more than asked is no false precision yet.
    match expected.figures {
        asked if most < asked => Some(Message::TooFewFigures(asked)),
        asked if least > asked + 1 => Some(Message::TooManyFigures(asked)),
        _ => None,
    }
}

/// The judgement on a number that stands alone.
fn without_unit(expected: &ExpectedNumber, answer: &NumberAnswer, as_written: Found, as_pure: Found) -> Judgement {
    let unit = &expected.unit;
    let is_pure = unit.dimension() == Unit::none().dimension();
    // A fraction is as good as per cent, and an angle without a unit is in radians; nobody writes degrees that way.
    let is_understood = is_pure && (!expected.cyclic || *unit == radians());
    if is_understood && as_pure != Found::Elsewhere {
        return fitting(expected, answer, as_pure);
    }
    if answer.number.is_zero() && as_written == Found::Right {
        return fitting(expected, answer, as_written).noted(Message::ZeroWithoutUnit);
    }
    fitting(expected, answer, as_written).with_unit(Verdict::UnitMissing, Message::UnitMissing)
}

fn radians() -> Unit {
    Unit::parse("rad").unwrap_or_default()
}

/// The judgement on a unit that measures something else.
fn other_dimension(
    expected: &ExpectedNumber,
    answer: &NumberAnswer,
    unit: &Unit,
    as_written: Found,
    target: &Target,
) -> Judgement {
    let in_base_units = in_asked_unit(expected, answer, unit).map(|number| compare(target, answer, &number));
    let found = if as_written == Found::Elsewhere { in_base_units.unwrap_or(as_written) } else { as_written };
    let message = Message::UnitWrongDimension {
        given: dimension_name(unit.dimension()).to_owned(),
        asked: dimension_name(expected.unit.dimension()).to_owned(),
    };
    fitting(expected, answer, found).with_unit(Verdict::UnitWrongDimension, message)
}

fn wrong(expected: &ExpectedNumber, answer: &NumberAnswer) -> Judgement {
    let is_fraction = expected.whole && !answer.number.value().is_int();
    Judgement::of(Verdict::Wrong, if is_fraction { Message::NotWhole } else { Message::Wrong })
}

impl Judgement {
    fn of(verdict: Verdict, message: Message) -> Self {
        Self { verdict, also: None, messages: vec![message] }
    }

    /// With a finding about the unit: it is the verdict of a right number, and comes beside any other.
    fn with_unit(mut self, verdict: Verdict, message: Message) -> Self {
        if self.verdict.is_right() {
            self.messages.retain(|message| !message.is_verdict());
            self.messages.splice(0..0, [Message::NumberRight, message]);
            return Self { verdict, ..self };
        }
        self.messages.push(message);
        self.also = (self.verdict != Verdict::Wrong).then_some(verdict);
        self
    }

    /// With a note; what was simply right is now right with a note.
    fn noted(mut self, message: Message) -> Self {
        if self.verdict == Verdict::Right {
            self.verdict = Verdict::RightWithNote;
        }
        self.messages.push(message);
        self
    }

    fn told(mut self, message: Option<Message>) -> Self {
        self.messages.extend(message);
        self
    }
}
