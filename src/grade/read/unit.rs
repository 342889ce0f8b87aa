//! The unit behind a number, with what people write around it.

use momentous_quantity::Unit;
use momentous_quantity::UnitFault;
use momentous_quantity::UnitFaultKind;

use super::arithmetic::begins_number;
use super::plain::ENDS;
use super::unit_cache;
use super::unreadable::{At, UnreadableKind};

/// Signs behind which something is missing where nothing follows.
const OPERATORS: [&str; 8] = ["*", "·", "×", "x", "+", "^", "-", "**"];
/// Letters that are typed for the sign of a degree.
const DEGREES: [&str; 4] = ["o", "O", "^o", "^0"];
/// Signs behind which something else than a unit begins.
const SEPARATORS: [&str; 5] = [",", ";", ":", "=", "?"];
/// Prefixes as they are spoken, whose letter is their first.
const SPOKEN: [&str; 2] = ["kilo", "milli"];
/// What is shown of a text that is not understood, in characters.
const SHOWN: usize = 20;

/// The unit between two bytes of a text; `None` where there is nothing.
pub(super) fn unit(text: &str, from: usize, to: usize, asked: &Unit) -> At<Option<Unit>> {
    let written = text[from..to].trim_end_matches(ENDS);
    // An opening bracket belongs to the direction behind it.
    let written = written.trim_end_matches(" (").trim_end();
    if written.trim() == "-" && asked.is_none() {
        return Ok(None);
    }
    if written.trim().is_empty() {
        return Ok(None);
    }
    let (start, written) = without_frame(from, written);
    let bare = written.trim_start();
    if bare.is_empty() || OPERATORS.contains(&bare) {
        let behind = text[from..to].trim();
        return Err((to - text[from..to].trim_start().len(), UnreadableKind::Behind(behind.to_owned())));
    }
    if DEGREES.contains(&bare) && asked.is_plain_angle() {
        return Ok(Some(Unit::degree()));
    }
    let fault = |fault: UnitFault, shift: usize| {
        let is_number = |sign: &str| sign.starts_with(|first: char| first.is_ascii_digit());
        if matches!(&fault.kind, UnitFaultKind::Unexpected(sign) if is_number(sign)) {
            return ((start + fault.span.start).saturating_sub(shift), UnreadableKind::SecondNumber);
        }
        if matches!(&fault.kind, UnitFaultKind::Unexpected(sign) if SEPARATORS.contains(&sign.as_str())) {
            let at = (start + fault.span.start).saturating_sub(shift);
            let behind = text.get(at..to).unwrap_or_default().trim();
            let number = begins_number(behind.trim_start_matches(|sign: char| !sign.is_alphanumeric()));
            let shown = UnreadableKind::Behind(behind.chars().take(SHOWN).collect());
            return (at, if number { UnreadableKind::SecondNumber } else { shown });
        }
        let misplaced =
            matches!(fault.kind, UnitFaultKind::Unexpected(_) | UnitFaultKind::Exponent | UnitFaultKind::Missing);
        if misplaced && fault.span.start <= shift && !bare.starts_with(char::is_alphabetic) && !bare.starts_with('/') {
            let shown = bare.chars().take(SHOWN).collect();
            return (start + written.len() - bare.len(), UnreadableKind::Behind(shown));
        }
        ((start + fault.span.start).saturating_sub(shift), UnreadableKind::Unit(fault))
    };
    // Before an article it is no inch.
    if let Some(at) = written.find(" in the ") {
        let behind = written[at..].trim_start().chars().take(SHOWN).collect();
        return Err((start + at + 1, UnreadableKind::Behind(behind)));
    }
    if let Some(unit) = thousandfold(bare, asked) {
        return Ok(Some(unit));
    }
    if let Some(unit) = remarked(bare, asked) {
        return Ok(Some(unit));
    }
    let per = bare.strip_prefix("per ").filter(|below| below.split(' ').next() != Some("cent"));
    match bare.strip_prefix('/').or(per) {
        // `5 /s`: five per second.
        Some(below) => unit_cache::parse(&format!("1/{below}"), asked).map_err(|found| fault(found, 1)),
        None => unit_cache::parse(written, asked).map_err(|found| fault(found, 0)),
    }
    .map(Some)
}

/// `kilo N s`, `mega-newtons`: a spoken prefix apart from its unit. `kilo` alone is a kilogram.
fn thousandfold(written: &str, asked: &Unit) -> Option<Unit> {
    let (prefix, rest) = written.split_once([' ', '-'])?;
    let spoken = SPOKEN.iter().find(|spoken| spoken.eq_ignore_ascii_case(prefix))?;
    let unit = unit_cache::parse(&format!("{spoken}{}", rest.trim_start()), asked);
    let letter = spoken.chars().next().filter(|_| unit.is_err());
    let unit = unit.or_else(|fault| match letter {
        Some(letter) => unit_cache::parse(&format!("{letter}{}", rest.trim_start()), asked),
        None => Err(fault),
    });
    unit.ok().filter(|unit| unit.dimension() == asked.dimension())
}

/// `Ns (kg m/s)`: the same unit again in brackets is a remark.
fn remarked(written: &str, asked: &Unit) -> Option<Unit> {
    let close = [(')', '('), (']', '[')].into_iter().find(|(close, _)| written.ends_with(*close))?;
    let open = written.rfind(close.1)?;
    let (own, again) = (written[..open].trim_end(), &written[open + 1..written.len() - 1]);
    if own.is_empty() || again.trim().is_empty() {
        return None;
    }
    let (own, again) = (unit_cache::parse(own, asked).ok()?, unit_cache::parse(again, asked).ok()?);
    (own.dimension() == again.dimension() && own.factor() == again.factor()).then_some(own)
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
