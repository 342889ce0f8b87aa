//! The answer to a part that asks for a number: a value, with what people write around it, or a direction in words.

use momentous_quantity::Unit;

use super::super::expected::ExpectedNumber;
use super::super::expected::Reference;
use super::answer::{NumberAnswer, echo_number};
use super::heading;
use super::multiple;
use super::numeral::DecimalMark;
use super::plain::Plain;
use super::remarks;
use super::unreadable::{Unreadable, UnreadableKind};
use super::value;
use super::value::Asked;

/// Words before a direction as navigators count it.
const BEARING: &str = "bearing";
const OF: &str = "of ";
/// How an angle ends that says which way it is turned, and not from where.
const TURNS: [&str; 2] = ["clockwise", "cw"];

/// Reads a number with its unit and direction.
pub(super) fn read(answer: &str, asked: &ExpectedNumber, mark: DecimalMark) -> Result<NumberAnswer, Unreadable> {
    let alone = |text: &str| {
        let plain = Plain::new(text).ok()?;
        let value = value::read(plain.text(), Asked::of(asked), mark);
        value.or_else(|fault| remarks::read(plain.text(), Asked::of(asked), mark, fault)).ok()
    };
    if let Some(number) = multiple::with_unit(answer, asked, alone) {
        return Ok(number);
    }
    let plain = Plain::new(&multiple::without(answer, asked)?)?;
    let plain = if asked.unit.is_plain_angle() { plain.with_degrees() } else { plain };
    let text = plain.text();
    let wanted = Asked::of(asked);
    let result = match value::read(text, wanted, mark) {
        // `8.02 j m/s`: the letter is a unit vector where the joule measures something else.
        Ok(value) if !measures(&value, asked) => match remarks::along_unit_vector(text, wanted, mark) {
            Some(Ok(along)) if along.unit.is_none() || measures(&along, asked) => Ok(along),
            _ => Ok(value),
        },
        result => result.or_else(|fault| remarks::read(text, wanted, mark, fault)),
    };
    let found = match &asked.reference {
        Some(reference) => result.or_else(|fault| match in_words(text, reference, mark) {
            // A direction that is not understood is no quantity without a direction.
            Err((_, UnreadableKind::Direction)) if !matches!(fault.1, UnreadableKind::NoDirection(_)) => Err(fault),
            words => words,
        }),
        None => result,
    };
    found.map_err(|(at, kind)| plain.fault(at, multiple::reason(kind, asked)))
}

/// Whether an answer has a unit of what is asked.
fn measures(answer: &NumberAnswer, asked: &ExpectedNumber) -> bool {
    answer.unit.as_ref().is_none_or(|unit| unit.dimension() == asked.unit.dimension())
}

/// `bearing 044°`, where the axes point to the sides of the compass: in other words.
fn clockwise_from_north(text: &str, reference: &Reference) -> Option<String> {
    let angle = text.trim_start().strip_prefix(BEARING)?.trim_start_matches([' ', ':', '=']);
    let angle = angle.strip_prefix(OF).unwrap_or(angle);
    let north = reference.frame.axes.get(1).filter(|_| heading::is_compass(&reference.frame))?.letter;
    Some(format!("{angle} clockwise from +{north}"))
}

/// A direction in words, as the question counts it.
fn in_words(text: &str, reference: &Reference, mark: DecimalMark) -> Result<NumberAnswer, (usize, UnreadableKind)> {
    let text = text.trim_end_matches([' ', '.']);
    let bearing = clockwise_from_north(text, reference);
    let text = bearing.as_deref().unwrap_or(text);
    let heading = heading::read(text, &reference.frame, reference.level(), mark).or_else(|fault| {
        // `30° clockwise`: from where the question counts.
        let turn = TURNS.iter().any(|turn| text.ends_with(turn)) && matches!(fault.1, UnreadableKind::Direction);
        let from = turn.then(|| format!("{text} from {}", reference.zero()));
        from.map_or(Err(fault), |text| heading::read(&text, &reference.frame, reference.level(), mark))
    })?;
    let words = heading.words(&reference.frame, |angle, form| echo_number(angle, form.written()));
    Ok(NumberAnswer {
        number: heading.counted(reference).ok_or((0, UnreadableKind::TooLarge))?,
        written: heading.form.written(),
        signed: false,
        unit: Some(Unit::degree()),
        pounds_as_mass: false,
        sense: None,
        heading: Some(words),
        unjudged: None,
    })
}
