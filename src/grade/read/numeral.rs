//! A written number: digits, their grouping, the decimal mark and the power of ten.

use serde::Deserialize;
use serde::Serialize;

use momentous_quantity::Decimal;
use momentous_quantity::DecimalFault;

use super::unreadable::UnreadableKind;

/// Digits are grouped by threes.
const GROUP: usize = 3;

/// Which mark begins the decimals.
///
/// Where nothing was chosen, whatever has only one reading is read, and the rest is asked back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DecimalMark {
    /// Nothing was chosen: `3.1` and `3,14` and `1,200.5` are read, `1,200` is asked back.
    #[default]
    Either,
    /// The point; one comma alone is asked back, for it may group thousands or begin the decimals.
    Point,
    /// The comma; a point groups thousands, though one point alone is asked back, for calculators write it for decimals.
    Comma,
}

/// A number at the start of a text.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Numeral {
    pub(super) decimal: Decimal,
    /// How many bytes it takes.
    pub(super) length: usize,
    /// The fewest figures that the writing can mean.
    pub(super) least: usize,
    /// Whether it is nothing but digits, ungrouped.
    pub(super) digits_only: bool,
    /// Whether spaces, or apostrophes, group its digits.
    pub(super) spaced: bool,
}

/// Reads the number at the start of a text that begins with a digit, or with a point and a digit.
///
/// # Errors
/// Where points, commas or underscores have no reading or two, with their place in the text.
pub(super) fn read(text: &str, mark: DecimalMark) -> Result<Numeral, (usize, UnreadableKind)> {
    let (mut written, mut length) = grouped_by_spaces(text);
    // `1.7333...`: the rest of the digits is not told.
    if let Some(end) = written.strip_suffix("...").map(str::len) {
        written.truncate(end);
    }
    if text[length..].starts_with('_') {
        return Err((length, UnreadableKind::Underscore));
    }
    let digits_only = written.bytes().all(|byte| byte.is_ascii_digit());
    let spaced = written.len() != length;
    let mut plain = plain_mark(&written, mark).map_err(|kind| (written.find([',', '.']).unwrap_or(0), kind))?;
    let exponent = exponent_length(&text[length..]);
    plain.push_str(&text[length..length + exponent]);
    length += exponent;
    length += if text[length..].starts_with('…') { '…'.len_utf8() } else { 0 };
    let decimal = Decimal::parse(&plain).map_err(|fault| match fault {
        DecimalFault::NotANumber { .. } => (0, UnreadableKind::Marks),
        DecimalFault::TooManyDigits | DecimalFault::ExponentTooLarge => (0, UnreadableKind::TooLarge),
    })?;
    // Behind a decimal mark, and before a power of ten, zeros are written to be counted.
    let counts = exponent > 0 || plain.contains('.');
    let least = if counts { decimal.figures() } else { decimal.least_figures() };
    Ok(Numeral { decimal, length, least, digits_only: digits_only && !spaced && exponent == 0, spaced })
}

/// The digits and marks at the start, without the spaces that group them by threes; and how many bytes they take.
fn grouped_by_spaces(text: &str) -> (String, usize) {
    let mut length = run(text);
    let mut written = text[..length].to_owned();
    let mut may_follow = begins_groups(&written);
    let mut groups = 0;
    while may_follow && begins_with_group(&text[length..], groups > 0 && written.contains(['.', ','])) {
        let more = run(&text[length + 1..]);
        written.push_str(&text[length + 1..=length + more]);
        length += 1 + more;
        groups += 1;
        // Behind a decimal mark no further group is expected.
        may_follow = more == GROUP;
    }
    (written, length)
}

/// How many bytes at the start are digits, and points and commas that belong to them.
fn run(text: &str) -> usize {
    let run = text.find(|next: char| !next.is_ascii_digit() && next != '.' && next != ',').unwrap_or(text.len());
    // A comma at the end belongs to the sentence.
    text[..run].trim_end_matches(',').len()
}

/// Whether groups of three digits may follow these: one to three digits, or decimals in whole groups.
fn begins_groups(written: &str) -> bool {
    match written.rsplit_once(['.', ',']) {
        None => (1..=GROUP).contains(&written.len()) && !written.starts_with('0'),
        Some((_, decimals)) => !decimals.is_empty() && decimals.len() % GROUP == 0,
    }
}

/// Whether a space or an apostrophe and three digits stand at the start; of decimals in groups, the last may be shorter.
fn begins_with_group(text: &str, may_end: bool) -> bool {
    let Some(rest) = text.strip_prefix([' ', '\'']) else { return false };
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    digits == GROUP || may_end && (1..GROUP).contains(&digits)
}

/// How many bytes at the start are a power of ten: `e3`, `E+3`.
fn exponent_length(text: &str) -> usize {
    let Some(rest) = text.strip_prefix(['e', 'E']) else { return 0 };
    let digits = rest.strip_prefix(['+', '-']).unwrap_or(rest);
    let count = digits.bytes().take_while(u8::is_ascii_digit).count();
    if count == 0 { 0 } else { text.len() - digits.len() + count }
}

/// The number with a decimal point and without grouping.
fn plain_mark(written: &str, mark: DecimalMark) -> Result<String, UnreadableKind> {
    let count = |mark: u8| written.bytes().filter(|byte| *byte == mark).count();
    let (points, commas) = (count(b'.'), count(b','));
    let last = written.rfind(['.', ',']).and_then(|at| written[at..].chars().next());
    match (points, commas, last) {
        (0, 0, _) | (_, _, None) => Ok(written.to_owned()),
        (0, 1, _) | (1, 0, _) => one_mark(written, if points == 1 { '.' } else { ',' }, mark),
        (0, _, _) if mark != DecimalMark::Comma => grouped(written, ','),
        (_, 0, _) if mark != DecimalMark::Point => grouped(written, '.'),
        (_, 1, Some(',')) if mark != DecimalMark::Point => split(written, ',', '.'),
        (1, _, Some('.')) if mark != DecimalMark::Comma => split(written, '.', ','),
        _ => Err(UnreadableKind::Marks),
    }
}

/// A number with a single mark, which may begin the decimals or group thousands.
fn one_mark(written: &str, sign: char, mark: DecimalMark) -> Result<String, UnreadableKind> {
    let decimal = || Ok(written.replace(',', "."));
    let ungrouped = || grouped(written, sign);
    match (mark, sign) {
        (DecimalMark::Point | DecimalMark::Either, '.') | (DecimalMark::Comma, ',') => decimal(),
        // Nobody groups thousands behind a zero.
        (DecimalMark::Point, _) if written.starts_with("0,") => decimal(),
        (DecimalMark::Point, _) => {
            let Ok(ungrouped) = ungrouped() else { return Err(UnreadableKind::OtherMark('.')) };
            Err(UnreadableKind::AmbiguousMark([ungrouped, written.replace(',', ".")]))
        }
        (DecimalMark::Comma, _) => {
            let Ok(ungrouped) = ungrouped() else { return Err(UnreadableKind::OtherMark(',')) };
            Err(UnreadableKind::AmbiguousMark([ungrouped, written.replace('.', ",")]))
        }
        (DecimalMark::Either, _) => {
            let Ok(ungrouped) = ungrouped() else { return decimal() };
            Err(UnreadableKind::AmbiguousMark([ungrouped, written.replace(',', ".")]))
        }
    }
}

/// The digits of a whole number grouped by threes.
fn grouped(written: &str, group: char) -> Result<String, UnreadableKind> {
    let mut parts = written.split(group);
    let first = parts.next().unwrap_or_default();
    let well = (1..=GROUP).contains(&first.len()) && !first.starts_with('0') && parts.all(|part| part.len() == GROUP);
    if well { Ok(written.replace(group, "")) } else { Err(UnreadableKind::Marks) }
}

/// A grouped whole part and decimals.
fn split(written: &str, decimal: char, group: char) -> Result<String, UnreadableKind> {
    let (whole, decimals) = written.split_once(decimal).ok_or(UnreadableKind::Marks)?;
    Ok(format!("{}.{decimals}", grouped(whole, group)?))
}
