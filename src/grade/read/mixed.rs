//! Additions behind the digits of a number: a fraction, as in `2 1/2` and `2½`, or a power of ten behind a space.

use momentous_quantity::Decimal;
use momentous_quantity::Rational;

use super::super::number::Number;
use super::vulgar::of_character;

/// The ` 1/2` of `2 1/2`, and its length.
pub(super) fn proper_fraction(text: &str) -> Option<(Number, usize)> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let above = text.trim_start();
    let bar = above.get(digits(above)..)?.strip_prefix('/')?;
    let (above, below) = (above.get(..digits(above))?, bar.get(..digits(bar))?);
    let length = text.len() - bar.len() + below.len();
    let (above, below) = (above.parse::<u32>().ok()?, below.parse::<u32>().ok()?);
    let is_proper = text.starts_with(' ') && 0 < above && above < below;
    is_proper.then(|| (Number::exact(Rational::from(above) / Rational::from(below)), length))
}

/// A fraction in one character, perhaps behind a space, and its length.
pub(super) fn vulgar(text: &str) -> Option<(Number, usize)> {
    if text.is_empty() || text.as_bytes().first().is_some_and(|first| first.is_ascii() && *first != b' ') {
        return None;
    }
    let bare = text.trim_start();
    let first = bare.chars().next()?;
    let (above, below) = of_character(first)?;
    let length = text.len() - bare.len() + first.len_utf8();
    Some((Number::exact(Rational::from(above) / Rational::from(below)), length))
}

/// The number with the power of ten that stands behind a space, ` e3`, and the length of that.
pub(super) fn spaced_exponent(number: &str, text: &str) -> Option<(Decimal, usize)> {
    let power = text.strip_prefix(" e")?;
    let digits = power.strip_prefix(['+', '-']).unwrap_or(power);
    let end = digits.find(|next: char| !next.is_ascii_digit()).unwrap_or(digits.len());
    let length = text.len() - digits.len() + end;
    let goes_on = digits[end..].starts_with(|next: char| next.is_alphanumeric() || next == '.' || next == '^');
    let plain = number.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    (end > 0 && !goes_on && plain)
        .then(|| Decimal::parse(&format!("{number}{}", &text[1..length])).ok())?
        .map(|decimal| (decimal, length))
}

/// Whether a ten stands here, perhaps with the digits of its lost exponent, not the beginning of 10.5.
pub(super) fn begins_ten(text: &str) -> bool {
    let Some(behind) = text.trim_start().strip_prefix("10") else { return false };
    let rest = behind.trim_start_matches(|next: char| next.is_ascii_digit());
    behind.len() - rest.len() <= 2 && !rest.starts_with(['.', ','])
}

/// Whether a sign stands here with a digit directly behind it.
pub(super) fn is_glued_sign(text: &str) -> bool {
    text.strip_prefix(['+', '-']).is_some_and(|behind| behind.starts_with(|next: char| next.is_ascii_digit()))
}

/// A raised integer, `⁻³`, and its length.
pub(super) fn superscript(text: &str) -> Option<(i32, usize)> {
    const RAISED: [char; 12] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻', '⁺'];
    let raised = &text[..text.find(|next: char| !RAISED.contains(&next)).unwrap_or(text.len())];
    let lower =
        |raised: char| RAISED.iter().position(|known| *known == raised).and_then(|at| "0123456789-+".chars().nth(at));
    let lowered: String = raised.chars().filter_map(lower).collect();
    lowered.parse().ok().map(|value| (value, raised.len()))
}
