//! The words and signs of a written unit.

use momentous_fault::Span;

use super::unit_lookup::long_name;
use super::{UnitFault, UnitFaultKind};

/// The longest text that is read as a unit, in bytes.
const MAX_LENGTH: usize = 120;
/// The largest exponent that may be written.
const MAX_EXPONENT: i32 = 9;

/// A word or sign of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token<'text> {
    /// A name: `kg`, `°`.
    Word(&'text str),
    /// The number one, as in `1/s`.
    One,
    /// An exponent, of what stands before it.
    Exponent(i32),
    /// A power in words before its unit: `square`, `cubic`.
    Power(i32),
    /// A sign of multiplication; a space is none.
    Times,
    /// A fraction bar, or the word `per`.
    Divide,
    /// `(`
    Open,
    /// `)`
    Close,
}

/// The tokens of a text, with their places.
///
/// # Errors
/// Where the text is too long, has a character that no unit has, or an exponent that is no small integer.
pub(super) fn tokens(text: &str) -> Result<Vec<(Token<'_>, Span)>, UnitFault> {
    if text.len() > MAX_LENGTH {
        return Err(UnitFault::new(UnitFaultKind::TooLong, 0, text.len()));
    }
    let mut tokens: Vec<(Token, Span)> = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let follows =
            tokens.last().is_some_and(|(token, span)| span.end == at && matches!(token, Token::Word(_) | Token::Close));
        let token = if first.is_whitespace() {
            None
        } else if let Some((value, length)) = spoken_power(rest) {
            Some((Token::Exponent(value), length))
        } else if let Some(exponent) = read_exponent(rest, follows) {
            let (value, length) = exponent;
            let fault = UnitFault::new(UnitFaultKind::Exponent, at, at + length);
            let value = value.filter(|value| value.abs() <= MAX_EXPONENT).ok_or(fault)?;
            Some((Token::Exponent(value), length))
        } else {
            let unexpected = UnitFaultKind::Unexpected(first.to_string());
            let fault = UnitFault::new(unexpected, at, at + first.len_utf8());
            Some(read_sign_or_word(rest, first).ok_or(fault)?)
        };
        let length = token.map_or(first.len_utf8(), |(_, length)| length);
        tokens.extend(token.map(|(token, _)| (token, Span { start: at, end: at + length })));
        at += length;
    }
    Ok(tokens)
}

/// A token that is no exponent, and its length.
fn read_sign_or_word(rest: &str, first: char) -> Option<(Token<'_>, usize)> {
    let token = match first {
        '(' => Token::Open,
        ')' => Token::Close,
        '/' | '∕' | '÷' => Token::Divide,
        '*' | '·' | '⋅' | '∙' | '•' | '‧' | '×' | '.' | '‐' | '‑' => Token::Times,
        // Before a digit it would be the sign of an exponent, which stands directly behind its unit.
        '-' | '–' if !rest[first.len_utf8()..].starts_with(|next: char| next.is_ascii_digit()) => Token::Times,
        '1' if !rest[1..].starts_with(|next: char| next.is_ascii_digit() || next == '.') => Token::One,
        '°' | '˚' | '%' => return Some((Token::Word(&rest[..first.len_utf8()]), first.len_utf8())),
        letter if letter.is_alphabetic() => {
            let end = rest.find(|next: char| !next.is_alphabetic()).unwrap_or(rest.len());
            let goes_on = rest[end..].starts_with([' ', '-']);
            let word = &rest[..goes_on.then(|| long_name(rest)).flatten().unwrap_or(end)];
            let token = match word {
                "per" => Token::Divide,
                "x" if rest[1..].trim_start().starts_with(char::is_alphabetic) => Token::Times,
                "square" => Token::Power(2),
                "cubic" => Token::Power(3),
                _ => Token::Word(word),
            };
            return Some((token, word.len()));
        }
        _ => return None,
    };
    Some((token, first.len_utf8()))
}

/// An exponent in words behind its unit, and its length: `squared`, `cubed`, `to the power of 4`.
fn spoken_power(rest: &str) -> Option<(i32, usize)> {
    let is_whole = |word: &str| !rest[word.len()..].starts_with(char::is_alphabetic);
    for (word, value) in [("squared", 2), ("cubed", 3)] {
        if rest.starts_with(word) && is_whole(word) {
            return Some((value, word.len()));
        }
    }
    let digits = rest.strip_prefix("to the power of ")?;
    let (value, length) = read_integer(digits);
    Some((value.filter(|value| value.abs() <= MAX_EXPONENT)?, rest.len() - digits.len() + length))
}

/// An exponent and its length: `^-1`, `^ 2`, `**2`, `^{-1}`, `^(2)`, `⁻¹`, and directly behind a word also `2` and `-1`.
/// The value is missing where there is the sign of a power but no integer behind it.
fn read_exponent(rest: &str, follows: bool) -> Option<(Option<i32>, usize)> {
    if let Some(raised) = rest.strip_prefix("**").or_else(|| rest.strip_prefix('^')) {
        let raised = raised.trim_start();
        let sign = rest.len() - raised.len();
        let close = [('{', '}'), ('(', ')')].into_iter().find(|(open, _)| raised.starts_with(*open));
        let Some((_, close)) = close else {
            let (value, length) = read_integer(raised);
            return Some((value, sign + length));
        };
        let (value, length) = read_integer(&raised[1..]);
        let closed = raised[1 + length..].starts_with(close);
        return Some((value.filter(|_| closed), sign + 1 + length + usize::from(closed)));
    }
    let raised: String = rest.chars().map_while(lower_superscript).collect();
    if !raised.is_empty() {
        let length = rest.chars().take(raised.chars().count()).map(char::len_utf8).sum();
        return Some((raised.parse().ok(), length));
    }
    let (value, length) = read_integer(rest);
    // In `3h00` no power stands.
    let is_power = !rest.trim_start_matches(['-', '−', '–', '+']).starts_with('0');
    value.filter(|_| follows && is_power).map(|value| (Some(value), length))
}

/// An integer at the start of the text, and the length of what looked like one.
fn read_integer(text: &str) -> (Option<i32>, usize) {
    let minus = ['-', '−', '–', '+'].into_iter().find(|sign| text.starts_with(*sign));
    let sign = minus.map_or(0, char::len_utf8);
    let digits = text[sign..].bytes().take_while(u8::is_ascii_digit).count();
    let value: Option<i32> = text[sign..sign + digits].parse().ok();
    let value = if minus.is_some_and(|sign| sign != '+') { value.map(|value| -value) } else { value };
    // A number too long for an i32 is an exponent all the same, though one that is refused.
    (if digits > 0 { value.or(Some(i32::MAX)) } else { None }, sign + digits)
}

fn lower_superscript(raised: char) -> Option<char> {
    let pairs = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁻-⁺+".chars().collect::<Vec<_>>();
    pairs.chunks(2).find(|pair| pair.first() == Some(&raised)).and_then(|pair| pair.last().copied())
}
