//! A vector by its components, each with its own name or direction: `1.5 to the right and 2 down`, `px = 1.5, py = -2 N s`.

use momentous_quantity::Unit;

use super::super::expected::ExpectedVector;
use super::answer::NumberAnswer;
use super::arithmetic;
use super::direction::{self, Phrase};
use super::heading::is_compass;
use super::numeral::DecimalMark;
use super::plain::ENDS;
use super::unit::unit;
use super::unreadable::{At, UnreadableKind};
use super::value;
use super::value::Asked;

/// Components as they were read; one without a value stands for zero.
pub(super) type Parts = Vec<Option<NumberAnswer>>;

/// Words and signs between components.
const BETWEEN: [&str; 4] = [" and", ",", ";", " &"];

/// `1.5 to the right and 2 down`; nothing where the text is not of that form.
pub(super) fn by_directions(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> Option<At<Parts>> {
    let starts = numbers(text, mark)?;
    if starts.len() < 2 || starts.first() != Some(&0) {
        return None;
    }
    if let Some(kind) = bearing(text, asked) {
        return Some(Err((0, kind)));
    }
    let mut parts: Parts = vec![None; asked.components.len()];
    for (place, start) in starts.iter().enumerate() {
        let end = starts.get(place + 1).copied().unwrap_or(text.len());
        let piece = without_between(&text[*start..end]);
        let (axis, part) = match directed(piece, asked, mark)? {
            Ok(directed) => directed,
            Err((at, kind)) => return Some(Err((start + at, kind))),
        };
        match parts.get_mut(axis) {
            Some(place @ None) => *place = Some(part),
            _ => return Some(Err((*start, UnreadableKind::Axis))),
        }
    }
    // `3.6 m/s S 30° W` is a size and a direction.
    if parts.iter().flatten().any(|part| part.unit.as_ref().is_some_and(Unit::is_plain_angle)) {
        return None;
    }
    let with_unit = parts.iter().flatten().filter(|part| part.unit.is_some()).count();
    let last = starts.last().is_some_and(|last| text[*last..].split(' ').count() > 2);
    (with_unit == 0 || with_unit == starts.len() || with_unit == 1 && last).then_some(Ok(parts))
}

/// A number with its unit and the direction of an axis, and which axis that is.
fn directed(piece: &str, asked: &ExpectedVector, mark: DecimalMark) -> Option<At<(usize, NumberAnswer)>> {
    let (term, length) = arithmetic::read(piece, mark).ok()?;
    let wanted = asked.components.first().map(|component| component.unit.clone()).unwrap_or_default();
    let words = piece.char_indices().filter(|(at, next)| {
        let gap = piece[..*at].ends_with([' ', ',', '(']) || direction::is_arrow(*next) || *at == length;
        *at >= length && gap && *next != ' '
    });
    for (start, _) in words {
        let phrase = piece[start..].trim_matches([' ', '(', ')', '.', ',']);
        let axis_and_sense = asked.frame.axes.iter().enumerate().find_map(|(axis, frame_axis)| {
            match direction::read(phrase, Some(&frame_axis.senses), Some(frame_axis.letter)) {
                Phrase::Declared(sense) => Some((axis, sense)),
                Phrase::None | Phrase::Other => None,
            }
        });
        let Some((axis, sense)) = axis_and_sense else { continue };
        let unit_found = match unit(piece, length, start, &wanted) {
            Ok(unit_found) => unit_found,
            Err(fault) => return Some(Err(fault)),
        };
        // `4 N` is a force, or northwards.
        let whole = unit(piece, length, piece.len(), &wanted).ok().flatten();
        if direction::is_compass_letter(phrase)
            && whole.is_some_and(|whole: Unit| whole.dimension() == wanted.dimension())
        {
            return Some(Err((start, UnreadableKind::UnitOrDirection(phrase.to_owned()))));
        }
        if term.number.is_negative() || piece.starts_with(['+', '-']) {
            return Some(Err((0, UnreadableKind::SignAndDirection)));
        }
        let part = NumberAnswer {
            number: term.number,
            written: term.form.written(),
            signed: false,
            unit: unit_found,
            pounds_as_mass: false,
            sense: Some(sense),
            heading: None,
            unjudged: None,
        };
        return Some(Ok((axis, part)));
    }
    None
}

/// The beginnings of the numbers of a text; none where one of them cannot be read.
fn numbers(text: &str, mark: DecimalMark) -> Option<Vec<usize>> {
    let mut starts = Vec::new();
    let (mut at, mut before) = (0, ' ');
    while let Some(next) = text[at..].chars().next() {
        let digit = |next: char| next.is_ascii_digit();
        let begins = next.is_ascii_digit() || next == '.' && text[at + 1..].starts_with(digit);
        // What is glued to a unit is its power.
        if begins && !before.is_alphanumeric() && before != '^' && before != '-' {
            starts.push(at);
            at += arithmetic::read(&text[at..], mark).ok()?.1;
            before = '0';
            continue;
        }
        before = next;
        at += next.len_utf8();
    }
    Some(starts)
}

fn without_between(piece: &str) -> &str {
    let mut piece = piece.trim_end();
    while let Some(shorter) = BETWEEN.iter().find_map(|word| piece.strip_suffix(word)) {
        piece = shorter.trim_end();
    }
    piece.trim_end_matches(ENDS)
}

/// `px = 1.5, py = -2 N s`; nothing where the text is not of that form.
pub(super) fn by_names(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> Option<At<Parts>> {
    // `x: 1.5; y: -2`
    let text = &if text.contains('=') { text.to_owned() } else { text.replace(':', "=") };
    if text.matches('=').count() != asked.components.len() {
        return None;
    }
    let wanted = asked.components.first().map(|component| component.unit.clone()).unwrap_or_default();
    let mut parts: Parts = vec![None; asked.components.len()];
    let mut from = 0;
    while let Some(sign) = text[from..].find('=').map(|sign| from + sign) {
        let name = text[from..sign].trim_matches([' ', ',', ';', '}']).trim_start_matches("and ");
        let letter = name.chars().next_back()?;
        let axis = asked.frame.axes.iter().position(|axis| axis.letter == letter)?;
        // The next name begins behind the last sign between components before its equals sign.
        let next = text[sign + 1..].find('=').map(|next| sign + 1 + next);
        let end = match next {
            None => text.len(),
            Some(next) => {
                let value = &text[sign + 1..next];
                let between = BETWEEN.iter().filter_map(|word| value.rfind(word)).max();
                // `v_x = 1.2 v_y = -3.4`: only a space.
                let at = between.or_else(|| value.trim_end().rfind(' '))?;
                sign + 1 + at
            }
        };
        let value = text[sign + 1..end].trim_end_matches(ENDS);
        let start = sign + 1 + value.len() - value.trim_start().len();
        let part = match value::read(value.trim_start(), Asked::in_unit(&wanted), mark) {
            Ok(part) => part,
            Err((at, kind)) => return Some(Err((start + at, kind))),
        };
        match parts.get_mut(axis) {
            Some(place @ None) => *place = Some(part),
            _ => return Some(Err((start, UnreadableKind::Axis))),
        }
        if next.is_none() {
            break;
        }
        let rest = &text[end..];
        from = end + BETWEEN.iter().find(|word| rest.starts_with(**word)).map_or(0, |word| word.len());
    }
    Some(Ok(parts))
}

/// `5 N 30 E`: two components, or 5 at N30°E. Nothing where the text is not of that form.
fn bearing(text: &str, asked: &ExpectedVector) -> Option<UnreadableKind> {
    let words: Vec<&str> = text.split_whitespace().collect();
    match words.as_slice() {
        [size, first @ ("N" | "S"), angle, last @ ("E" | "W")] if is_compass(&asked.frame) => {
            Some(UnreadableKind::Ambiguous([
                format!("{size} {first}, {angle} {last}"),
                format!("{size} at {first}{angle}°{last}"),
            ]))
        }
        _ => None,
    }
}
