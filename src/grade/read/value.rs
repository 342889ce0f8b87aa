//! A number with its unit and direction in plain characters, in whatever order people write them.

use momentous_quantity::Dimension;
use momentous_quantity::Unit;

use super::super::expected::ExpectedNumber;
use super::super::number::Number;
use super::answer::{NumberAnswer, Sense, Written};
use super::arithmetic::{self, Form, Term};
use super::direction::{self, Phrase};
use super::numeral::DecimalMark;
use super::plain::ENDS;
use super::unit::unit;
use super::unreadable::UnreadableKind;

/// The most words that a direction has.
const MOST_WORDS: usize = 9;
/// The largest power of ten of an answer, either way.
const LARGEST: f64 = 1e300;
/// The signs that an answer is not one value.
const NOT_ONE_VALUE: [char; 7] = ['±', '<', '>', '≤', '≥', '∓', '≠'];
/// Signs between a value and its uncertainty.
const PLUS_MINUS: [&str; 4] = ["±", "+/-", "+-", "\\pm"];

/// The facts about the question that reading may know.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked<'a> {
    pub(super) unit: &'a Unit,
    /// The words for the two directions.
    pub(super) senses: Option<&'a [String; 2]>,
    /// The axis along which it is counted.
    pub(super) axis: Option<char>,
    /// The same two directions in space, where the axis follows a string; those of a place, whose sign says them.
    pub(super) in_space: Option<&'a [String; 2]>,
    /// Whether what is told to move moves in the positive direction.
    motion: Option<bool>,
    pub(super) name: &'a str,
}

impl<'a> Asked<'a> {
    /// The facts about that part.
    pub(super) fn of(number: &'a ExpectedNumber) -> Self {
        let called = number.called.as_ref();
        let name = called.map_or("", |called| &called.name);
        let axis = called.and_then(|called| called.axis);
        let in_space = called.and_then(|called| called.in_space.as_ref());
        let motion = called.and_then(|called| called.motion);
        Self { unit: &number.unit, senses: number.senses.as_ref(), axis, in_space, motion, name }
    }

    /// Nothing but a unit.
    pub(super) fn in_unit(unit: &'a Unit) -> Self {
        Self { unit, senses: None, axis: None, in_space: None, motion: None, name: "" }
    }

    /// The meaning of a phrase about direction.
    pub(super) fn direction(&self, phrase: &str) -> Phrase {
        let said = direction::read(phrase, self.senses, self.axis);
        let in_space = |axis| self.in_space.and_then(|words| direction::read(phrase, Some(words), axis).declared());
        // Of a force the same direction may be that of another.
        let is_velocity = self.unit.dimension() == Dimension::VELOCITY;
        let of_motion = || {
            let (along, names_it) = direction::along_motion(phrase)?;
            let motion = self.motion.or(self.senses.filter(|[plus, _]| direction::is_ahead(plus)).map(|_| true));
            Some(along == motion?).filter(|_| is_velocity || names_it)
        };
        let declared = |positive: bool, [plus, minus]: &[String; 2]| {
            Phrase::Declared(Sense { positive, word: if positive { plus } else { minus }.clone() })
        };
        match (&said, self.senses) {
            (Phrase::Other, Some(senses)) => {
                in_space(None).or_else(of_motion).map_or(said, |positive| declared(positive, senses))
            }
            (_, None) => match self.in_space.zip(in_space(self.axis)) {
                Some((words, positive)) => declared(positive, words),
                None if said == Phrase::None && direction::begins(phrase) => Phrase::Other,
                None => said,
            },
            _ => said,
        }
    }
}

/// Reads a number with its unit and direction; a fault with its byte.
pub(super) fn read(text: &str, asked: Asked<'_>, mark: DecimalMark) -> Result<NumberAnswer, (usize, UnreadableKind)> {
    if let Some((at, sign)) = PLUS_MINUS.iter().find_map(|sign| text.find(sign).map(|at| (at, sign))) {
        let [value, error] = [&text[..at], &text[at + sign.len()..]].map(|side| side.trim_matches([' ', '=']));
        let is_error = !value.is_empty() && arithmetic::begins_number(error);
        let reading = || UnreadableKind::Uncertainty(format!("{value} ± {error}"));
        return Err((at, if is_error { reading() } else { UnreadableKind::NotOneValue }));
    }
    if let Some(at) = text.find(NOT_ONE_VALUE) {
        return Err((at, UnreadableKind::NotOneValue));
    }
    if asked.unit.is_none()
        && let Some((first, second)) = text.split_once(':')
        && let Some(ratio) = ratio(first, second, mark)
    {
        return Ok(ratio);
    }
    let text = text.trim_end();
    let (before, start) = leading_direction(text, asked)?;
    let signed = text[start..].starts_with(['+', '-']);
    let (Term { number, form }, length) =
        arithmetic::read(&text[start..], mark).map_err(|(at, kind)| (start + at, kind))?;
    check_size(&number).map_err(|kind| (start, kind))?;
    let (mut unit, behind) = unit_and_direction(text, start + length, asked)?;
    if form == Form::Arc && asked.unit.dimension() == Dimension::NONE {
        // The function gives the angle itself, in whatever unit it is written.
        unit = Some(Unit::radian());
    }
    let sense = match (before, behind) {
        (Some(_), Some((_, at))) => return Err((at, UnreadableKind::SignAndDirection)),
        (before, behind) => before.or(behind.map(|(sense, _)| sense)),
    };
    if sense.is_some() && (signed || number.is_negative()) {
        return Err((start, UnreadableKind::SignAndDirection));
    }
    let as_mass = unit.as_ref().and_then(|unit| pounds_as_mass(unit, asked.unit));
    let pounds_as_mass = as_mass.is_some();
    Ok(NumberAnswer {
        number,
        written: form.written(),
        signed,
        unit: as_mass.or(unit),
        pounds_as_mass,
        sense,
        heading: None,
        unjudged: None,
    })
}

/// A ratio of two plain numbers: `8:1`.
fn ratio(first: &str, second: &str, mark: DecimalMark) -> Option<NumberAnswer> {
    let number = |text: &str| {
        let text = text.trim_matches([' ', '=']);
        let (term, length) = arithmetic::read(text, mark).ok()?;
        (length == text.len()).then_some(term.number)
    };
    let number = number(first)?.over(&number(second)?)?;
    check_size(&number).ok()?;
    let signed = number.is_negative();
    let written = Written::Computed;
    Some(NumberAnswer {
        number,
        written,
        signed,
        unit: None,
        pounds_as_mass: false,
        sense: None,
        heading: None,
        unjudged: None,
    })
}

/// A pound is a force, unless only a mass makes sense of it.
fn pounds_as_mass(unit: &Unit, asked: &Unit) -> Option<Unit> {
    if unit.dimension() == asked.dimension() {
        return None;
    }
    unit.with_pounds_as_mass().filter(|mass| mass != unit && mass.dimension() == asked.dimension())
}

pub(super) fn check_size(number: &Number) -> Result<(), UnreadableKind> {
    let size = number.to_f64().abs();
    if number.is_zero() || (1.0 / LARGEST..=LARGEST).contains(&size) { Ok(()) } else { Err(UnreadableKind::TooLarge) }
}

/// The direction before the number, and where the number begins.
fn leading_direction(text: &str, asked: Asked<'_>) -> Result<(Option<Sense>, usize), (usize, UnreadableKind)> {
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
    let sense = declared(&text[start..end], start, asked)?.ok_or((start, name_or_nothing(text)))?;
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
    asked: Asked<'_>,
) -> Result<(Option<Unit>, Option<(Sense, usize)>), (usize, UnreadableKind)> {
    if arithmetic::begins_number(&text[end..]) && !text[end..].trim_start_matches([' ', '(']).starts_with("1/") {
        return Err((end + text[end..].len() - text[end..].trim_start().len(), UnreadableKind::SecondNumber));
    }
    let unit = |from, to| unit(text, from, to, asked.unit);
    // A second is never written `S` but in capitals.
    let is_south =
        |phrase: &str| phrase == "S" && matches!(direction::read("S", asked.senses, None), Phrase::Declared(_));
    let last = text.trim_end_matches(ENDS);
    // What is a unit of what is asked has no direction behind it; `N` is then a newton.
    if let Ok(Some(whole)) = unit(end, text.len())
        && whole.dimension() == asked.unit.dimension()
        && !last.strip_suffix('S').is_some_and(|before| before.ends_with(' ') && is_south("S"))
    {
        return Ok((Some(whole), None));
    }
    let words = spans(text, end);
    let mut sense_found = None;
    for (start, _) in words.iter().rev().take(MOST_WORDS) {
        let phrase = text[*start..].trim_end_matches(ENDS).trim_end_matches([')', '.', ' ']);
        // The longest phrase counts: `towards the wall` ends like `away from the wall`.
        if let Some(sense) = declared(phrase, *start, asked)? {
            sense_found = Some((sense, *start, phrase));
        }
    }
    let Some((sense, start, phrase)) = sense_found else {
        return match before_unit(text, end, asked) {
            Some((sense, start)) => Ok((unit(start, text.len())?, Some((sense, end)))),
            None => Ok((unit(end, text.len())?, None)),
        };
    };
    if !direction::is_compass_letter(phrase) {
        return Ok((unit(end, start)?, Some((sense, start))));
    }
    // `5 N` is a force or northwards: what is asked decides, and where it does not, the student.
    let fits = |to| unit(end, to).ok().flatten().filter(|unit| unit.dimension() == asked.unit.dimension());
    match (fits(text.len()), fits(start)) {
        (Some(unit), None) if !is_south(phrase) => Ok((Some(unit), None)),
        (None, Some(unit)) => Ok((Some(unit), Some((sense, start)))),
        _ => {
            unit(end, start)?;
            Err((start, UnreadableKind::UnitOrDirection(phrase.to_owned())))
        }
    }
}

/// The direction between the number and its unit, and where the unit begins: `0.25 to the left m/s`.
fn before_unit(text: &str, end: usize, asked: Asked<'_>) -> Option<(Sense, usize)> {
    let words = spans(text, end);
    words.windows(2).take(MOST_WORDS).rev().find_map(|pair| {
        let phrase = text[words[0].0..pair[0].1].trim();
        let sense = declared(phrase, end, asked).ok()??;
        (!direction::is_compass_letter(phrase)).then_some((sense, pair[1].0))
    })
}

/// The declared sense that a phrase says; a direction that is not declared is a fault.
fn declared(phrase: &str, at: usize, asked: Asked<'_>) -> Result<Option<Sense>, (usize, UnreadableKind)> {
    let word = || phrase.to_owned();
    match (asked.direction(phrase), asked.senses) {
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

/// The spans of words and arrows from a byte on.
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
