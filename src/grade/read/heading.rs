//! Directions in the plane, as people write them: `40° below +x`, `36° N of E`, `S30°W`, `-40°`.

use momentous_quantity::Rational;

use super::super::expected::Frame;
use super::super::expected::Reference;
use super::super::number::Number;
use super::answer::{Written, echo_number};
use super::arithmetic::{self, Form};
use super::direction::{self, Phrase};
use super::functions::{self, AngleUnit};
use super::numeral::DecimalMark;
use super::unreadable::{At, UnreadableKind};

/// Words that say nothing here.
const FILLERS: &[&str] = &[
    "at",
    "@",
    "∠",
    "an",
    "a",
    "angle",
    "the",
    "axis",
    "-axis",
    "-direction",
    "direction",
    "in",
    "to",
    "due",
    "directed",
    "measured",
    "and",
    "along",
    "towards",
    "toward",
];

/// A side of an axis: its position in the frame, and whether it is the positive one.
type Side = (usize, bool);

/// A direction: along a side of an axis, or turned from it towards a side of another.
#[derive(Clone, Debug)]
pub(super) struct Heading {
    base: Side,
    turned: Option<(Number, Side)>,
    /// How the angle is written.
    pub(super) form: Form,
}

/// A word of a direction, with its byte.
#[derive(Clone, Debug)]
enum Word {
    Angle {
        degrees: Number,
        form: Form,
        signed: bool,
        unit: bool,
        /// Whether it is written with a zero before it, as bearings are.
        bearing: bool,
    },
    Side(Side),
    Above(bool),
    /// The horizontal, of which no end is told.
    Horizontal,
    /// Counter-clockwise or not.
    Turn(bool),
    From,
    Of,
}

/// Reads a direction that takes the whole text. The horizontal without an end of its own is meant at that end of the first axis from
/// which the question counts.
pub(super) fn read(text: &str, frame: &Frame, level: bool, mark: DecimalMark) -> At<Heading> {
    let words = words(text, frame, mark)?;
    let start = words.first().map_or(0, |(at, _)| *at);
    let bare: Vec<Word> = words.iter().map(|(_, word)| word.clone()).collect();
    let plain = Form::Computed;
    let (degrees, form, signed, unit, base, towards) = match bare.as_slice() {
        [Word::Side(side)] => return Ok(Heading { base: *side, turned: None, form: plain }),
        [Word::Side(base), Word::Side(towards)] => {
            let half = Number::exact(Rational::from(45));
            return turned(*base, *towards, half, plain).ok_or((start, UnreadableKind::Direction));
        }
        [Word::Angle { degrees, unit: true, bearing: true, .. }] if is_compass(frame) => {
            return Err((start, sense_of_turn(degrees, "north", "east")));
        }
        [Word::Angle { degrees, form, unit: true, .. }] if frame.axes.len() > 1 => {
            return turned((0, true), (1, true), degrees.clone(), *form).ok_or((start, UnreadableKind::Direction));
        }
        [Word::Angle { unit: false, .. }] => return Err((start, UnreadableKind::AngleUnit)),
        [Word::Angle { degrees, form, signed, unit, .. }, Word::Above(above), Word::Side(base)] => {
            (degrees, form, *signed, *unit, *base, (1, *above))
        }
        [Word::Angle { degrees, form, signed, unit, .. }, Word::Above(above), Word::Horizontal] => {
            (degrees, form, *signed, *unit, (0, level), (1, *above))
        }
        [Word::Angle { degrees, form, signed, unit, .. }, Word::Above(above), Word::Horizontal, Word::Side(base)]
            if base.0 == 0 =>
        {
            (degrees, form, *signed, *unit, *base, (1, *above))
        }
        [
            Word::Angle { degrees, form, signed, unit, .. },
            Word::Turn(counter),
            Word::From | Word::Of,
            Word::Side(base),
        ]
        | [Word::Angle { degrees, form, signed, unit, .. }, Word::From, Word::Side(base), Word::Turn(counter)] => {
            (degrees, form, *signed, *unit, *base, quarter(*base, *counter))
        }
        // From +x everybody turns counter-clockwise; from anywhere else nobody knows.
        [Word::Angle { degrees, unit: true, .. }, Word::From, Word::Side(base)]
            if *base != (0, true) || is_compass(frame) && !text.contains('x') =>
        {
            let side = frame.axes.get(base.0).map_or("", |axis| &axis.senses[usize::from(!base.1)]);
            return Err((start, sense_of_turn(degrees, side, side)));
        }
        [Word::Angle { degrees, form, signed, unit, .. }, Word::From, Word::Side(base)] => {
            (degrees, form, *signed, *unit, *base, quarter(*base, true))
        }
        [
            Word::Angle { degrees, form, signed, unit, .. },
            Word::Side(towards),
            Word::Of | Word::From,
            Word::Side(base),
        ]
        | [Word::Angle { degrees, form, signed, unit, .. }, Word::From, Word::Side(base), Word::Side(towards)] => {
            (degrees, form, *signed, *unit, *base, *towards)
        }
        // `S30W` has always meant degrees, and so has `E30N`.
        [Word::Side(base), Word::Angle { degrees, form, signed, unit, .. }, Word::Side(towards)]
            if *unit || base.0 == 1 || is_compass(frame) && !text.contains(' ') =>
        {
            (degrees, form, *signed, true, *base, *towards)
        }
        _ => return Err((start, UnreadableKind::Direction)),
    };
    if signed {
        return Err((start, UnreadableKind::SignAndDirection));
    }
    if !unit {
        return Err((start, UnreadableKind::AngleUnit));
    }
    turned(base, towards, degrees.clone(), *form).ok_or((start, UnreadableKind::Direction))
}

/// An angle whose sense is not told, with both.
fn sense_of_turn(degrees: &Number, clockwise_from: &str, counter_from: &str) -> UnreadableKind {
    let angle = echo_number(degrees, Written::Computed);
    let plain = |side: &str| side.trim_start_matches("to the ").to_owned();
    UnreadableKind::Ambiguous([
        format!("{angle}° clockwise from {}", plain(clockwise_from)),
        format!("{angle}° counter-clockwise from {}", plain(counter_from)),
    ])
}

/// Whether the second axis points up.
fn is_upright(frame: &Frame) -> bool {
    frame.axes.get(1).is_some_and(|axis| axis.senses[0].contains("up"))
}

/// Whether the axes point to the sides of the compass.
pub(super) fn is_compass(frame: &Frame) -> bool {
    frame.axes.get(1).is_some_and(|axis| axis.senses[0].contains("north"))
}

fn turned(base: Side, towards: Side, degrees: Number, form: Form) -> Option<Heading> {
    (base.0 != towards.0).then_some(Heading { base, turned: Some((degrees, towards)), form })
}

/// The side a quarter turn further, among the first two axes.
fn quarter(base: Side, counter: bool) -> Side {
    // From x one turns counter-clockwise towards y, from y towards -x.
    if base.0 == 0 { (1, base.1 == counter) } else { (0, base.1 != counter) }
}

fn words(text: &str, frame: &Frame, mark: DecimalMark) -> At<Vec<(usize, Word)>> {
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(next) = text[at..].chars().next() {
        if [' ', ',', '(', ')', '∠', '@'].contains(&next) {
            at += next.len_utf8();
            continue;
        }
        if let Some((word, length)) = axis_sign(&text[at..], frame) {
            words.push((at, word));
            at += length;
            continue;
        }
        if arithmetic::begins_number(&text[at..]) {
            let (word, length) = angle(&text[at..], mark).map_err(|(shift, kind)| (at + shift, kind))?;
            words.push((at, word));
            at += length;
            continue;
        }
        let length = text[at..].find([' ', ',', '(', ')']).unwrap_or(text.len() - at);
        // In `S30°W` the number follows at once.
        let length =
            text[at..at + length].find(|digit: char| digit.is_ascii_digit()).unwrap_or(length).max(next.len_utf8());
        let word = text[at..at + length].trim_end_matches('.');
        let lower = word.to_lowercase();
        if let "positive" | "negative" = lower.as_str() {
            // The axis that it belongs to follows.
            let rest = text[at + length..].trim_start();
            let start = text.len() - rest.len();
            let Some((Word::Side((axis, true)), taken)) = axis_sign(rest, frame) else {
                return Err((at, UnreadableKind::Direction));
            };
            words.push((at, Word::Side((axis, lower == "positive"))));
            at = start + taken;
            continue;
        }
        if !FILLERS.contains(&lower.as_str()) {
            words.extend(named(word, at, frame)?);
        } else if word == "angle" && text[at + length..].trim_start().starts_with("of ") {
            at += 3;
        }
        at += length;
    }
    Ok(words)
}

/// `+x`, `-y`, or the letter alone.
fn axis_sign(text: &str, frame: &Frame) -> Option<(Word, usize)> {
    let mut letters = text.chars();
    let first = letters.next()?;
    let signed = first == '+' || first == '-';
    let letter = if signed { letters.next()? } else { first };
    let ends = !letters.next().is_some_and(char::is_alphanumeric);
    let axis = frame.axes.iter().position(|axis| axis.letter == letter).filter(|_| ends)?;
    Some((Word::Side((axis, first != '-')), usize::from(signed) + letter.len_utf8()))
}

fn angle(text: &str, mark: DecimalMark) -> At<(Word, usize)> {
    let (term, length) = arithmetic::read(text, mark)?;
    let signed = text.starts_with(['+', '-']) || term.number.is_negative();
    let rest = text[length..].trim_start();
    let name =
        if rest.starts_with('°') { "°" } else { rest.split(|next: char| !next.is_alphabetic()).next().unwrap_or("") };
    let unit = functions::find_angle_unit(name);
    let taken = if unit.is_some() { text.len() - rest.len() + name.len() } else { length };
    let degrees = match unit {
        Some(AngleUnit::Radians) => {
            let turn = Number::rounded(180.0 / std::f64::consts::PI);
            turn.and_then(|turn| term.number.times(&turn)).ok_or((0, UnreadableKind::TooLarge))?
        }
        _ => term.number,
    };
    let bearing = text.starts_with('0') && text[1..].starts_with(|next: char| next.is_ascii_digit());
    Ok((Word::Angle { degrees, form: term.form, signed, unit: unit.is_some(), bearing }, taken))
}

/// The meaning of a word: one side of an axis, two at once as in `NE`, or how to turn.
fn named(word: &str, at: usize, frame: &Frame) -> At<Vec<(usize, Word)>> {
    let lower = word.to_lowercase();
    let one = match lower.as_str() {
        "horizontal" | "horizontally" if is_upright(frame) => Word::Horizontal,
        "above" => Word::Above(true),
        "below" => Word::Above(false),
        "counter-clockwise" | "counterclockwise" | "anticlockwise" | "anti-clockwise" | "ccw" => Word::Turn(true),
        "clockwise" | "cw" => Word::Turn(false),
        "from" => Word::From,
        "of" => Word::Of,
        _ => match side(word, frame) {
            Some(side) => Word::Side(side),
            None => {
                return pair(word, frame)
                    .map(|sides| sides.map(|side| (at, Word::Side(side))).to_vec())
                    .ok_or_else(|| unknown(word, at, frame));
            }
        },
    };
    Ok(vec![(at, one)])
}

fn side(word: &str, frame: &Frame) -> Option<Side> {
    frame.axes.iter().enumerate().find_map(|(index, axis)| {
        match direction::read(word, Some(&axis.senses), Some(axis.letter)) {
            Phrase::Declared(sense) => Some((index, sense.positive)),
            Phrase::None | Phrase::Other => None,
        }
    })
}

/// `NE`, `north-east`, `southwest`.
fn pair(word: &str, frame: &Frame) -> Option<[Side; 2]> {
    let splits = word.char_indices().skip(1).map(|(at, _)| word.split_at(at));
    let mut sides = splits.filter_map(|(first, second)| {
        let (first, second) = (side(first, frame)?, side(second.trim_start_matches('-'), frame)?);
        (first.0 != second.0).then_some([first, second])
    });
    sides.next()
}

fn unknown(word: &str, at: usize, frame: &Frame) -> (usize, UnreadableKind) {
    let kind = match (direction::read(word, None, None), frame.axes.first()) {
        (Phrase::Other, Some(axis)) => {
            UnreadableKind::OtherDirection { word: word.to_owned(), senses: axis.senses.clone() }
        }
        _ => UnreadableKind::Direction,
    };
    (at, kind)
}

impl Heading {
    /// The components of a vector of that size, along the axes of the frame.
    pub(super) fn components(&self, size: &Number, frame: &Frame) -> Option<Vec<Number>> {
        let mut components = vec![Number::exact(Rational::ZERO); frame.axes.len()];
        let mut put = |(axis, positive): Side, part: Number| {
            if let Some(component) = components.get_mut(axis) {
                *component = if positive { part } else { part.negated() };
            }
        };
        match &self.turned {
            None => put(self.base, size.clone()),
            Some((degrees, towards)) => {
                let radians = degrees.times(&Number::rounded(std::f64::consts::PI / 180.0)?)?;
                put(self.base, size.times(&radians.through(libm::cos)?)?);
                put(*towards, size.times(&radians.through(libm::sin)?)?);
            }
        }
        Some(components)
    }

    /// The direction in degrees, as the question counts it.
    pub(super) fn counted(&self, reference: &Reference) -> Option<Number> {
        let quarters = |(axis, positive): Side| i32::try_from(axis).unwrap_or(0) + if positive { 0 } else { 2 };
        let start = Number::exact(Rational::from(90 * (quarters(self.base) - reference.quarters)));
        let counter = match &self.turned {
            None => start,
            Some((degrees, towards)) if *towards == quarter(self.base, true) => start.plus(degrees)?,
            Some((degrees, _)) => start.minus(degrees)?,
        };
        Some(if reference.clockwise { counter.negated() } else { counter })
    }

    /// The direction without doubt: `40° from +x towards -y`.
    pub(super) fn words(&self, frame: &Frame, degrees: impl Fn(&Number, Form) -> String) -> String {
        let side = |(axis, positive): Side| {
            let letter = frame.axes.get(axis).map_or('?', |axis| axis.letter);
            format!("{}{letter}", if positive { '+' } else { '-' })
        };
        match &self.turned {
            None => format!("along {}", side(self.base)),
            Some((angle, towards)) => {
                format!("{}° from {} towards {}", degrees(angle, self.form), side(self.base), side(*towards))
            }
        }
    }
}
