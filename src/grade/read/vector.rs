//! A vector: by its components, by unit vectors, or by magnitude and direction.

use momentous_quantity::Rational;
use momentous_quantity::Unit;

use super::super::expected::ExpectedVector;
use super::super::number::Number;
use super::answer::{NumberAnswer, VectorAnswer, Written, echo_number};
use super::components::{self, Parts};
use super::direction;
use super::hats;
use super::heading;
use super::multiple;
use super::numeral::DecimalMark;
use super::plain::ENDS;
use super::plain::Plain;
use super::remarks;
use super::unit::unit;
use super::unit_vectors::unit_vectors;
use super::unreadable::{At, Unreadable, UnreadableKind};
use super::value::{self, Asked};

/// Brackets around components.
const BRACKETS: [(char, char); 5] = [('(', ')'), ('<', '>'), ('[', ']'), ('⟨', '⟩'), ('{', '}')];

/// A magnitude is looked for before so many words.
const MOST_WORDS: usize = 16;

/// Reads a vector.
pub(super) fn read(answer: &str, asked: &ExpectedVector, mark: DecimalMark) -> Result<VectorAnswer, Unreadable> {
    let answer = match asked.components.first() {
        Some(component) => multiple::without(answer, component)?,
        None => answer.into(),
    };
    let plain = Plain::new(&answer)?;
    let text = hats::without_brackets(&hats::put_on(plain.text()));
    read_plain(&text, asked, mark).map_err(|(at, kind)| plain.fault(at, kind))
}

fn read_plain(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> At<VectorAnswer> {
    let text = text.trim_end_matches(ENDS);
    let mut start = text.len() - text.trim_start_matches([' ', '=', '≈', '~']).len();
    let at = |shift: usize| move |(at, kind)| (at + shift, kind);
    if let Some(parts) = components::by_names(&text[start..], asked, mark) {
        return together(&parts.map_err(at(start))?, None, start);
    }
    if let Some(behind) = remarks::behind_name(&text[start..], "").map_err(|kind| (start, kind))? {
        start += behind + text[start + behind..].len() - text[start + behind..].trim_start().len();
    }
    if let Some((from, to, rest)) = bracketed(text, start) {
        let inside = &text[from..to];
        if unit_vectors(inside).is_empty() {
            return tuple(inside, from, &text[rest..], rest, asked, mark);
        }
        let behind = unit_behind(&text[rest..], asked).map_err(at(rest))?;
        return sum(inside, asked, mark, behind).map_err(at(from));
    }
    if !unit_vectors(&text[start..]).is_empty() {
        return sum(&text[start..], asked, mark, None).map_err(at(start));
    }
    if let Some(parts) = components::by_directions(&text[start..], asked, mark) {
        return together(&parts.map_err(at(start))?, None, start);
    }
    if let Some(pair) = bare_pair(&text[start..], asked, mark) {
        return pair.map_err(at(start));
    }
    polar(&text[start..], asked, mark).map_err(at(start))
}

/// `1.5, -2 N s`: components without brackets, all without a unit, or all with the same one, or with one behind the last.
fn bare_pair(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> Option<At<VectorAnswer>> {
    let pieces: Vec<&str> = text.split(if text.contains(';') { ";" } else { ", " }).collect();
    if pieces.len() != asked.components.len() {
        return None;
    }
    let parts: Parts = pieces.iter().map(|piece| component(piece, asked, mark).ok()).collect();
    let has_unit = |part: &Option<NumberAnswer>| part.as_ref().is_some_and(|part| part.unit.is_some());
    let first_alone = parts.first().is_some_and(has_unit) && !parts.last().is_some_and(has_unit);
    (parts.iter().all(Option::is_some) && !first_alone && !parts.iter().flatten().any(is_angle))
        .then(|| together(&parts, None, 0))
}

/// Whether a component has the unit of an angle.
fn is_angle(part: &NumberAnswer) -> bool {
    part.unit.as_ref().is_some_and(Unit::is_plain_angle)
}

/// The span inside the brackets around the components, and the beginning of what is behind them.
fn bracketed(text: &str, start: usize) -> Option<(usize, usize, usize)> {
    let first = text[start..].chars().next()?;
    let (_, close) = BRACKETS.iter().find(|(open, _)| *open == first)?;
    let (from, mut depth) = (start + first.len_utf8(), 1);
    for (offset, next) in text[from..].char_indices() {
        depth += i32::from(next == first);
        depth -= i32::from(next == *close);
        if depth == 0 {
            let to = from + offset;
            let inside = &text[from..to];
            let many =
                inside.contains([',', ';', '|']) || !unit_vectors(inside).is_empty() || by_spaces(inside, 2).is_some();
            return many.then_some((from, to, to + close.len_utf8()));
        }
    }
    None
}

/// `1.5 -2`: numbers with nothing but spaces between them.
fn by_spaces(inside: &str, least: usize) -> Option<Vec<&str>> {
    let pieces: Vec<&str> = inside.split_whitespace().collect();
    let is_number = |piece: &&str| {
        let bare = piece.strip_prefix(['+', '-']).unwrap_or(piece);
        bare.starts_with(|first: char| first.is_ascii_digit() || first == '.')
            && bare.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.' || byte == b'e' || byte == b'/')
    };
    // `(1 200)` is one number with its digits in groups.
    let grouped =
        pieces.iter().skip(1).all(|piece| piece.len() == 3 && piece.bytes().all(|byte| byte.is_ascii_digit()));
    (pieces.len() >= least && !grouped && pieces.iter().all(is_number)).then_some(pieces)
}

/// `1,2 | -3,4`: components as German schools separate them; a bar around a piece belongs to its size.
fn by_bars(inside: &str, count: usize) -> Option<Vec<&str>> {
    let pieces: Vec<&str> = inside.split('|').collect();
    (pieces.len() == count && count > 1 && pieces.iter().all(|piece| !piece.trim().is_empty())).then_some(pieces)
}

fn tuple(
    inside: &str,
    from: usize,
    rest: &str,
    at: usize,
    asked: &ExpectedVector,
    mark: DecimalMark,
) -> At<VectorAnswer> {
    let count = asked.components.len();
    let split = |mark: &str| inside.split(mark).collect::<Vec<_>>();
    let by_commas = split(",");
    let pieces = if let Some(pieces) = by_bars(inside, count) {
        pieces
    } else if inside.contains(';') {
        split(";")
    } else if mark != DecimalMark::Comma && by_commas.len() == count {
        by_commas
    } else if !inside.contains(',')
        && let Some(pieces) = by_spaces(inside, count)
    {
        pieces
    } else {
        split(", ")
    };
    if pieces.len() != count {
        return Err((from, UnreadableKind::Components(count)));
    }
    let unit = unit_behind(rest, asked).map_err(|(shift, kind)| (at + shift, kind))?;
    let mut parts: Parts = Vec::new();
    for piece in pieces {
        let start = from + (piece.as_ptr() as usize - inside.as_ptr() as usize);
        let part = component(piece, asked, mark).map_err(|(shift, kind)| (start + shift, kind))?;
        parts.push(Some(part));
    }
    if let ([Some(size), Some(turn)], true) = (parts.as_slice(), parts.iter().flatten().any(is_angle)) {
        let shown = |part: &NumberAnswer| echo_number(&part.number, part.written);
        let (size, turn) = (shown(size), shown(turn));
        let readings = [format!("{size} at {turn}°"), format!("({size}, {turn})")];
        return Err((from, UnreadableKind::Ambiguous(readings)));
    }
    together(&parts, unit, from)
}

fn component(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> At<NumberAnswer> {
    let unit = asked.components.first().map(|component| component.unit.clone()).unwrap_or_default();
    let lead = text.len() - text.trim_start().len();
    value::read(text.trim_start(), Asked::in_unit(&unit), mark).map_err(|(at, kind)| (at + lead, kind))
}

/// The unit behind the brackets.
fn unit_behind(rest: &str, asked: &ExpectedVector) -> At<Option<Unit>> {
    let wanted = asked.components.first().map(|component| component.unit.clone()).unwrap_or_default();
    unit(rest, 0, rest.len(), &wanted)
}

/// Components with one unit: behind them, or beside each.
fn together(parts: &Parts, behind: Option<Unit>, at: usize) -> At<VectorAnswer> {
    let written = |part: &Option<NumberAnswer>| part.as_ref().map_or(Written::Computed, |part| part.written);
    let value =
        |part: &Option<NumberAnswer>| part.as_ref().map_or(Number::exact(Rational::ZERO), NumberAnswer::directed);
    let units: Vec<&Unit> = parts.iter().flatten().filter_map(|part| part.unit.as_ref()).collect();
    let present = parts.iter().flatten().count();
    let zeros = parts.iter().flatten().filter(|part| part.number.is_zero() && part.unit.is_none()).count();
    let unit = match (units.as_slice(), behind) {
        ([], behind) => behind,
        // `1.2i - 3.4j m/s`: the unit behind the last belongs to all.
        ([only], None) if present > 1 && parts.iter().flatten().last().is_some_and(|part| part.unit.is_some()) => {
            Some((*only).clone())
        }
        ([first, others @ ..], None) if others.iter().all(|unit| unit == first) && units.len() + zeros >= present => {
            Some((*first).clone())
        }
        _ => return Err((at, UnreadableKind::MixedUnits)),
    };
    Ok(VectorAnswer {
        components: parts.iter().map(value).collect(),
        written: parts.iter().map(written).collect(),
        unit,
        heading: None,
    })
}

/// `1.2i - 3.4j m/s`
fn sum(text: &str, asked: &ExpectedVector, mark: DecimalMark, behind: Option<Unit>) -> At<VectorAnswer> {
    let mut parts: Parts = vec![None; asked.components.len()];
    let mut from = 0;
    let vectors = unit_vectors(text);
    for (position, (axis, start, end)) in vectors.iter().enumerate() {
        let lead = from + text[from..].len() - text[from..].trim_start().len();
        let coefficient = text[lead..*start].trim_end().trim_end_matches(['*', '·', '×']).trim_end();
        let sign = coefficient.trim_end();
        let part = match sign {
            "" | "+" | "-" => component(&format!("{sign}1"), asked, mark),
            _ if is_sum(sign) => Err((0, two_terms(sign, &text[*start..*end]))),
            _ if position > 0 && !sign.starts_with(['+', '-']) => Err((0, UnreadableKind::SecondNumber)),
            _ => coefficient_of(coefficient, asked, mark),
        };
        let part = part.map_err(|(shift, kind)| (lead + shift, kind))?;
        match parts.get_mut(*axis) {
            Some(place @ None) => *place = Some(part),
            _ => return Err((*start, UnreadableKind::Axis)),
        }
        from = *end;
    }
    let rest = unit_behind(&text[from..], asked).map_err(|(shift, kind)| (from + shift, kind))?;
    if rest.is_some() && behind.is_some() {
        return Err((from, UnreadableKind::MixedUnits));
    }
    together(&parts, rest.or(behind), 0)
}

/// Whether two terms stand before one unit vector: `3 + 4j`.
fn is_sum(coefficient: &str) -> bool {
    let mut depth = 0;
    let mut before = 'e';
    coefficient.chars().any(|next| {
        depth += i32::from("({".contains(next)) - i32::from(")}".contains(next));
        let joins = (next == '+' || next == '-') && depth == 0 && !"e^E*/·×+- ".contains(before);
        before = if next == ' ' { before } else { next };
        joins
    })
}

fn two_terms(coefficient: &str, letter: &str) -> UnreadableKind {
    let first = coefficient.rfind(['+', '-']).unwrap_or(0);
    let (one, other) = coefficient.split_at(first);
    let one = one.trim_end_matches([' ', '+']);
    let another = if letter.starts_with(['i', 'î']) { "j" } else { "i" };
    UnreadableKind::Ambiguous([
        format!("({coefficient}){letter}"),
        format!("{}{another} {other}{letter}", one.trim_start()),
    ])
}

/// The number before a unit vector, perhaps in brackets with its unit: `(1.5 N s)i - (2 N s)j`.
fn coefficient_of(written: &str, asked: &ExpectedVector, mark: DecimalMark) -> At<NumberAnswer> {
    let unsigned = written.trim_start_matches(['+', ' ']);
    // `+ -2j`
    let unsigned = if written.starts_with('+') { unsigned } else { written };
    if let Ok(part) = component(unsigned, asked, mark) {
        return Ok(part);
    }
    let minus = unsigned.starts_with('-');
    let inner = unsigned.trim_start_matches(['-', ' ']);
    match inner.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')) {
        Some(inner) => {
            let part = component(inner, asked, mark)?;
            Ok(if minus { NumberAnswer { number: part.number.negated(), ..part } } else { part })
        }
        None => component(unsigned, asked, mark),
    }
}

/// A magnitude and its direction, wherever the one ends and the other begins.
fn polar(text: &str, asked: &ExpectedVector, mark: DecimalMark) -> At<VectorAnswer> {
    let mut last_fault = None;
    let begins = |(at, next): (usize, char)| {
        let gap = text[..at].ends_with([' ', ',', '(']) || direction::is_arrow(next) || next == '@' || next == '∠';
        (at > 0 && gap && next != ' ').then_some(at)
    };
    for at in text.char_indices().filter_map(begins).take(MOST_WORDS) {
        let size = text[..at].trim_end_matches([' ', ',', '(']);
        let bare = size.strip_suffix(" at").or(size.strip_suffix('@')).or(size.strip_suffix('∠')).unwrap_or(size);
        let Ok(size) = component(bare, asked, mark) else { continue };
        match heading::read(&text[at..], &asked.frame, true, mark) {
            Ok(_) if size.number.is_negative() || size.signed => return Err((0, UnreadableKind::SignAndDirection)),
            Ok(heading) => {
                let components = heading.components(&size.number, &asked.frame).ok_or((0, UnreadableKind::TooLarge))?;
                let words = heading.words(&asked.frame, |angle, form| echo_number(angle, form.written()));
                let preposition = if words.starts_with("along") { "" } else { "at " };
                return Ok(VectorAnswer {
                    written: vec![size.written; components.len()],
                    components,
                    unit: size.unit,
                    heading: Some((size.number, format!("{preposition}{words}"))),
                });
            }
            // Two bare numbers with a comma between them may be components, or a magnitude and an angle.
            Err((_, UnreadableKind::AngleUnit)) if text[..at].trim_end().ends_with(',') => {
                last_fault = Some((0, UnreadableKind::Components(asked.components.len())));
            }
            // What stands behind the whole quantity is a direction, so its fault is the one to tell.
            Err((shift, kind)) => {
                last_fault = Some((at + shift, kind));
            }
        }
    }
    let alone = component(text, asked, mark);
    match (alone, last_fault) {
        (Ok(size), _) if size.number.is_zero() => {
            let components = vec![size.number; asked.components.len()];
            Ok(VectorAnswer {
                written: vec![size.written; components.len()],
                components,
                unit: size.unit,
                heading: None,
            })
        }
        (Ok(_), None) => Err((0, UnreadableKind::Components(asked.components.len()))),
        (Ok(size), Some(_)) if size.unit.is_some() => Err((0, UnreadableKind::Components(asked.components.len()))),
        (Ok(_) | Err(_), Some(fault)) | (Err(fault), None) => Err(fault),
    }
}
