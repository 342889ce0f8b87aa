//! Calculations that can be read in two ways: a range or a difference, a lost exponent or a product, a point or a product.

use super::unreadable::{At, UnreadableKind};

/// Signs of multiplication.
const TIMES: [char; 5] = ['*', '×', '·', 'x', 'X'];

/// A written number, or a sign between numbers; with its first byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Token<'t> {
    Number(usize, &'t str),
    Sign(usize, char),
}

/// Asks back what a calculation may mean where it is not plain.
///
/// # Errors
/// Where it can be read in two ways, with its readings.
pub(super) fn check(text: &str) -> At<()> {
    // Most answers are plain numbers.
    if text.bytes().skip(1).all(|byte| byte.is_ascii_digit() || byte == b'.' || byte == b',') {
        return Ok(());
    }
    let tokens = tokens(text);
    for (at, pair) in text.char_indices().zip(text.chars().skip(1)).map(|((at, first), second)| (at, [first, second])) {
        let is_sign = |sign: char| sign == '+' || sign == '-';
        if at > 0 && pair.into_iter().all(is_sign) {
            return Err((at, UnreadableKind::NotOneValue));
        }
    }
    range(text, &tokens)?;
    for (place, window) in tokens.windows(3).enumerate() {
        let [Token::Number(start, left), Token::Sign(at, sign), Token::Number(_, right)] = *window else { continue };
        let next = tokens.get(place + 3);
        let glued = text[..at].ends_with(|last: char| last.is_ascii_digit())
            && text[at + sign.len_utf8()..].starts_with(|first: char| first.is_ascii_digit());
        let is_power = matches!(next, Some(Token::Sign(_, '^')));
        if sign == '·' && glued && !is_power && is_digits(left) && is_digits(right) {
            return ambiguous(at, [format!("{left}.{right}"), format!("{left}*{right}")]);
        }
        let lost = TIMES.contains(&sign) && !is_power && is_lost_power(right);
        if lost && (is_mantissa(left) || next.is_none()) {
            let power = right.trim_start_matches("10");
            return ambiguous(start, [format!("{left}*10^{power}"), format!("{left}*({right})")]);
        }
    }
    for window in tokens.windows(2) {
        if let [Token::Number(at, number), Token::Sign(_, '^')] = *window
            && let Some(whole) = number.strip_suffix(".10").or(number.strip_suffix(",10"))
        {
            let power = &text[at + number.len()..];
            return ambiguous(at, [format!("{whole}*10{power}"), format!("({number}){power}")]);
        }
    }
    Ok(())
}

/// The two readings, in words that are read as them.
fn ambiguous(at: usize, readings: [String; 2]) -> At<()> {
    Err((at, UnreadableKind::Ambiguous(readings)))
}

/// Right angles and their multiples, from which angles are taken.
const RIGHT_ANGLES: [&str; 4] = ["90", "180", "270", "360"];

/// `1190-1210`, `2-1/2`: nothing but two numbers with a minus sign directly between them; or with spaces around it, the
/// greater one last. `360-17.5` is a difference: no range descends from a full turn.
fn range(text: &str, tokens: &[Token<'_>]) -> At<()> {
    let bare = tokens.strip_prefix(&[Token::Sign(0, '(')]).and_then(|rest| match rest {
        [inner @ .., Token::Sign(_, ')')] => Some(inner),
        _ => None,
    });
    let is_bracketed = bare.is_some();
    let (left, at, right, fraction) = match bare.unwrap_or(tokens) {
        [Token::Number(_, left), Token::Sign(at, '-'), Token::Number(_, right)] => (*left, *at, *right, false),
        [
            Token::Number(_, left),
            Token::Sign(at, '-'),
            Token::Number(_, right),
            Token::Sign(_, '/'),
            Token::Number(..),
        ] => (*left, *at, *right, true),
        _ => return Ok(()),
    };
    let glued = !text[..at].ends_with(' ') && !text[at + 1..].starts_with(' ');
    let descends = value(left).zip(value(right)).is_some_and(|(left, right)| left > right);
    if descends && !fraction && RIGHT_ANGLES.contains(&left) {
        return Ok(());
    }
    let ascends = value(left).zip(value(right)).is_some_and(|(left, right)| left < right);
    if glued && fraction {
        return ambiguous(at, [format!("{left} {}", &text[at + 1..]), format!("{left} - {}", &text[at + 1..])]);
    }
    if glued || ascends && !is_bracketed && !fraction {
        return Err((at, UnreadableKind::RangeOrDifference));
    }
    Ok(())
}

fn tokens(text: &str) -> Vec<Token<'_>> {
    let mut found: Vec<Token> = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let digits = rest.find(|next: char| !next.is_ascii_digit() && next != '.' && next != ',').unwrap_or(rest.len());
        if digits > 0 {
            let length = digits + exponent(&rest[digits..]);
            found.push(Token::Number(at, &rest[..length]));
            at += length;
            continue;
        }
        if rest.starts_with("**") {
            found.push(Token::Sign(at, '^'));
            at += 2;
            continue;
        }
        if super::arithmetic::superscript(rest).is_some() {
            found.push(Token::Sign(at, '^'));
        } else if first != ' ' {
            found.push(Token::Sign(at, first));
        }
        at += first.len_utf8();
    }
    found
}

/// How many bytes at the start are a power of ten: `e3`, `E+3`.
fn exponent(text: &str) -> usize {
    let Some(rest) = text.strip_prefix(['e', 'E']) else { return 0 };
    let digits = rest.strip_prefix(['+', '-']).unwrap_or(rest);
    let count = digits.bytes().take_while(u8::is_ascii_digit).count();
    if count == 0 { 0 } else { text.len() - digits.len() + count }
}

fn is_digits(number: &str) -> bool {
    number.bytes().all(|byte| byte.is_ascii_digit())
}

/// `103` may be 10^3, and `1012` 10^12; `100` and `110` are nothing else.
fn is_lost_power(number: &str) -> bool {
    let power = number.strip_prefix("10").filter(|_| is_digits(number));
    power.is_some_and(|power| (1..=2).contains(&power.len()) && power.bytes().any(|digit| digit != b'0'))
}

/// Whether a number stands before powers of ten as a rule: between one and ten.
fn is_mantissa(number: &str) -> bool {
    value(number).is_some_and(|value| (1.0..10.0).contains(&value))
}

fn value(number: &str) -> Option<f64> {
    number.replace(',', ".").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn asks_back_what_has_two_readings() {
        let doubtful = [
            "1190-1210",
            "1.4-1.6",
            "1.4 - 1.6",
            "(1.4-1.6)",
            "10-3",
            "2-1/2",
            "1200+-5",
            "2--3",
            "1.2 × 103",
            "1.2*103",
            "3*1012",
            "0.5*102",
            "3.10^8",
            "5.10^-1",
            "3,10^8",
            "3.10⁸",
            "3·2",
        ];
        for text in doubtful {
            assert!(check(text).is_err(), "{text}");
        }
    }

    #[test]
    fn leaves_what_is_plain() {
        let plain = [
            "3.1",
            "-3.1",
            "3*3-2*2",
            "(3*3-2*2)/5",
            "5 - 3",
            "(3 - 5)",
            "2*100",
            "1.2*10^3",
            "1.2·10^3",
            "0.5*102*9",
            "2*103.5",
            "3.1^2",
            "0.5·2",
            "2·10^3",
            "10^3",
            "12-sqrt(2)",
            "2*-3",
            "1.2e-3",
            "2 - -3",
            "1/2 - 1/3",
            "3-2*2",
        ];
        for text in plain {
            assert_eq!(check(text), Ok(()), "{text}");
        }
    }
}
