//! A number with its unit and direction, in whatever order people write them.

use crate::quantity::Unit;
use crate::quantity::UnitFault;

use super::super::expected::ExpectedNumber;
use super::super::expected::Reference;
use super::super::number::Number;
use super::answer::{NumberAnswer, Sense, echo_number};
use super::arithmetic::{self, Term};
use super::direction::{self, Phrase};
use super::heading;
use super::known_units;
use super::numeral::DecimalMark;
use super::plain::Plain;
use super::unreadable::{Unreadable, UnreadableKind};

/// The most words that a direction has.
const MOST_WORDS: usize = 6;
/// The largest power of ten of an answer, either way.
const LARGEST: f64 = 1e300;
/// What says that an answer is not one value.
const NOT_ONE_VALUE: [char; 7] = ['±', '<', '>', '≤', '≥', '∓', '≠'];

/// Reads a number with its unit and direction.
pub(super) fn read(answer: &str, asked: &ExpectedNumber, mark: DecimalMark) -> Result<NumberAnswer, Unreadable> {
    let plain = Plain::new(answer)?;
    let text = plain.text();
    let found = read_plain(text, asked.senses.as_ref(), &asked.unit, mark);
    let found = match &asked.reference {
        Some(reference) => found.or_else(|fault| match in_words(text, reference, mark) {
            Err((_, UnreadableKind::Direction)) => Err(fault),
            words => words,
        }),
        None => found,
    };
    found.map_err(|(at, kind)| plain.fault(at, kind))
}

/// A direction in words, as the question counts it.
fn in_words(text: &str, reference: &Reference, mark: DecimalMark) -> Result<NumberAnswer, (usize, UnreadableKind)> {
    let heading = heading::read(text.trim_end_matches([' ', '.']), &reference.frame, mark)?;
    let words = heading.words(&reference.frame, |angle, form| echo_number(angle, form.written()));
    Ok(NumberAnswer {
        number: heading.counted(reference).ok_or((0, UnreadableKind::TooLarge))?,
        written: heading.form.written(),
        signed: false,
        unit: Unit::parse("deg").ok(),
        pounds_as_mass: false,
        sense: None,
        heading: Some(words),
    })
}

/// The same in plain characters; a fault with its byte.
pub(super) fn read_plain(
    text: &str,
    senses: Option<&[String; 2]>,
    asked: &Unit,
    mark: DecimalMark,
) -> Result<NumberAnswer, (usize, UnreadableKind)> {
    if let Some(at) = text.find(NOT_ONE_VALUE) {
        return Err((at, UnreadableKind::NotOneValue));
    }
    let text = text.trim_end();
    let (before, start) = leading_direction(text, senses)?;
    let signed = text[start..].starts_with(['+', '-']);
    let (Term { number, form }, length) =
        arithmetic::read(&text[start..], mark).map_err(|(at, kind)| (start + at, kind))?;
    check_size(&number).map_err(|kind| (start, kind))?;
    let (unit, behind) = unit_and_direction(text, start + length, senses, asked)?;
    let sense = match (before, behind) {
        (Some(_), Some((_, at))) => return Err((at, UnreadableKind::SignAndDirection)),
        (before, behind) => before.or(behind.map(|(sense, _)| sense)),
    };
    if sense.is_some() && (signed || number.is_negative()) {
        return Err((start, UnreadableKind::SignAndDirection));
    }
    let as_mass = unit.as_ref().and_then(|unit| pounds_as_mass(unit, asked));
    let pounds_as_mass = as_mass.is_some();
    Ok(NumberAnswer {
        number,
        written: form.written(),
        signed,
        unit: as_mass.or(unit),
        pounds_as_mass,
        sense,
        heading: None,
    })
}

/// A pound is a force, unless only a mass makes sense of it.
fn pounds_as_mass(unit: &Unit, asked: &Unit) -> Option<Unit> {
    if unit.dimension() == asked.dimension() {
        return None;
    }
    unit.with_pounds_as_mass().filter(|mass| mass != unit && mass.dimension() == asked.dimension())
}

fn check_size(number: &Number) -> Result<(), UnreadableKind> {
    let size = number.to_f64().abs();
    if number.is_zero() || (1.0 / LARGEST..=LARGEST).contains(&size) { Ok(()) } else { Err(UnreadableKind::TooLarge) }
}

/// The direction before the number, and where the number begins.
fn leading_direction(
    text: &str,
    senses: Option<&[String; 2]>,
) -> Result<(Option<Sense>, usize), (usize, UnreadableKind)> {
    let is_filling = |next: char| next == ' ' || next == '=' || next == '≈' || next == '~';
    let first = text.len() - text.trim_start_matches(is_filling).len();
    if arithmetic::begins_number(&text[first..]) {
        return Ok((None, first));
    }
    let mut words = spans(text, first);
    words.truncate(MOST_WORDS + 1);
    let Some(next) = words.iter().position(|(start, _)| arithmetic::begins_number(&text[*start..])) else {
        return Err((first, name_or_nothing(text)));
    };
    let Some(last) = next.checked_sub(1) else { return Ok((None, first)) };
    let (start, end) = (words[0].0, words[last].1);
    let sense = declared(&text[start..end], start, senses)?.ok_or((start, name_or_nothing(text)))?;
    Ok((Some(sense), words[next].0))
}

fn name_or_nothing(text: &str) -> UnreadableKind {
    let named = text.split_once('=').is_some_and(|(_, value)| arithmetic::begins_number(value));
    if named { UnreadableKind::NameBefore } else { UnreadableKind::NotANumber }
}

/// The unit behind the number, and the direction behind the unit with its place.
#[allow(clippy::type_complexity)] // a pair of options, each with one use
fn unit_and_direction(
    text: &str,
    end: usize,
    senses: Option<&[String; 2]>,
    asked: &Unit,
) -> Result<(Option<Unit>, Option<(Sense, usize)>), (usize, UnreadableKind)> {
    if arithmetic::begins_number(&text[end..]) && !text[end..].trim_start_matches([' ', '(']).starts_with("1/") {
        return Err((end + text[end..].len() - text[end..].trim_start().len(), UnreadableKind::SecondNumber));
    }
    // What is a unit of what is asked has no direction behind it; `N` is then a newton.
    if let Ok(Some(whole)) = unit(text, end, text.len())
        && whole.dimension() == asked.dimension()
    {
        return Ok((Some(whole), None));
    }
    let words = spans(text, end);
    let mut found = None;
    for (start, _) in words.iter().rev().take(MOST_WORDS) {
        let phrase = text[*start..].trim_end_matches([' ', ')', '.', ',']);
        // The longest phrase counts: `towards the wall` ends like `away from the wall`.
        if let Some(sense) = declared(phrase, *start, senses)? {
            found = Some((sense, *start, phrase));
        }
    }
    let Some((sense, start, phrase)) = found else { return Ok((unit(text, end, text.len())?, None)) };
    if !direction::is_compass_letter(phrase) {
        return Ok((unit(text, end, start)?, Some((sense, start))));
    }
    // `5 N` is a force or northwards: what is asked decides, and where it does not, the student.
    let fits = |to| unit(text, end, to).ok().flatten().filter(|unit| unit.dimension() == asked.dimension());
    match (fits(text.len()), fits(start)) {
        (Some(unit), None) => Ok((Some(unit), None)),
        (None, Some(unit)) => Ok((Some(unit), Some((sense, start)))),
        _ => {
            unit(text, end, start)?;
            Err((start, UnreadableKind::UnitOrDirection(phrase.to_owned())))
        }
    }
}

/// The declared sense that a phrase says; a direction that is not declared is a fault.
fn declared(phrase: &str, at: usize, senses: Option<&[String; 2]>) -> Result<Option<Sense>, (usize, UnreadableKind)> {
    let word = || phrase.to_owned();
    match (direction::read(phrase, senses), senses) {
        (Phrase::Declared(sense), _) => Ok(Some(sense)),
        // A letter that is no direction here is left to the units.
        (Phrase::Other, _) if direction::is_compass_letter(phrase) => Ok(None),
        (Phrase::Other, Some(senses)) => {
            Err((at, UnreadableKind::OtherDirection { word: word(), senses: senses.clone() }))
        }
        (Phrase::Other, None) => Err((at, UnreadableKind::NoDirection(word()))),
        (Phrase::None, _) => Ok(None),
    }
}

/// The unit between two bytes of a text; `None` where there is nothing.
pub(super) fn unit(text: &str, from: usize, to: usize) -> Result<Option<Unit>, (usize, UnreadableKind)> {
    let written = text[from..to].trim_end_matches([' ', ',']);
    // A full stop ends the sentence, and an opening bracket belongs to the direction behind it.
    let written = written.trim_end_matches('.').trim_end_matches(" (").trim_end();
    let (start, written) = without_frame(from, written);
    if written.trim().is_empty() {
        return Ok(None);
    }
    let fault = |fault: UnitFault, shift: usize| {
        let at = (start + fault.span.start).saturating_sub(shift);
        (at, UnreadableKind::Unit(fault))
    };
    let bare = written.trim_start();
    let per = bare.strip_prefix("per ").filter(|below| below.split(' ').next() != Some("cent"));
    match bare.strip_prefix('/').or(per) {
        // `5 /s`: five per second.
        Some(below) => known_units::parse(&format!("1/{below}")).map_err(|found| fault(found, 1)),
        None => known_units::parse(written).map_err(|found| fault(found, 0)),
    }
    .map(Some)
}

/// The text without square brackets around it, or a sign of multiplication before it, and where it starts.
fn without_frame(from: usize, written: &str) -> (usize, &str) {
    let start = from + written.len() - written.trim_start().len();
    let written = written.trim_start();
    if let Some(inner) = written.strip_prefix('[').and_then(|inner| inner.strip_suffix(']')) {
        return (start + 1, inner);
    }
    for times in ["*", "·", "×"] {
        if let Some(inner) = written.strip_prefix(times) {
            return (start + times.len(), inner);
        }
    }
    (start, written)
}

/// Where the words and arrows from a byte on begin and end.
fn spans(text: &str, from: usize) -> Vec<(usize, usize)> {
    let mut spans: Vec<(usize, usize)> = Vec::new();
    let mut open = false;
    for (offset, character) in text[from..].char_indices() {
        let (start, end) = (from + offset, from + offset + character.len_utf8());
        let arrow = direction::is_arrow(character);
        match spans.last_mut() {
            _ if matches!(character, ' ' | ',' | '(' | ')') => open = false,
            Some(last) if open && !arrow => last.1 = end,
            _ => {
                spans.push((start, end));
                open = !arrow;
            }
        }
    }
    spans
}
