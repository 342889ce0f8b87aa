//! The words of a term: numbers, names, operators, each with its place in the text.

use momentous_quantity::Rational;

use super::parse_fault::ParseFault;

/// Powers of ten beyond this are not read.
const MAX_EXPONENT: u32 = 300;

/// The kinds of words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A decimal number, exact.
    Number(Rational),
    /// A name with its component, stage and instant, or a unit.
    Name,
    /// `+ - * / ^`
    Operator(char),
    /// `(`
    Open,
    /// `)`
    Close,
    /// `,`
    Comma,
}

/// A word and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token<'a> {
    /// Its kind.
    pub(crate) kind: Kind,
    /// The word itself.
    pub(crate) written: &'a str,
    /// Its first byte.
    pub(crate) start: usize,
    /// The byte after its last.
    pub(crate) end: usize,
}

/// The words of a text.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, ParseFault> {
    let mut tokens = Vec::new();
    let (mut rest, mut start) = (text, 0);
    while let Some(first) = rest.chars().next() {
        let (kind, length) = match first {
            space if space.is_whitespace() => {
                rest = rest.trim_start();
                start = text.len() - rest.len();
                continue;
            }
            '0'..='9' | '.' => number(rest, start)?,
            letter if is_name_start(letter) => (Kind::Name, name_length(rest)),
            '*' if rest.starts_with("**") => (Kind::Operator('^'), 2),
            '+' | '-' | '*' | '/' | '^' => (Kind::Operator(first), 1),
            '\u{2212}' => (Kind::Operator('-'), first.len_utf8()),
            '\u{d7}' | '\u{b7}' | '\u{22c5}' => (Kind::Operator('*'), first.len_utf8()),
            '(' => (Kind::Open, 1),
            ')' => (Kind::Close, 1),
            ',' => (Kind::Comma, 1),
            other => {
                return Err(ParseFault {
                    start,
                    end: start + other.len_utf8(),
                    message: format!("`{other}` has no meaning in a term"),
                    help: strange_help(other),
                });
            }
        };
        let Some((written, behind)) = rest.split_at_checked(length) else { break };
        let end = start + length;
        tokens.push(Token { kind, written, start, end });
        (rest, start) = (behind, end);
    }
    Ok(tokens)
}

fn strange_help(other: char) -> Option<String> {
    let help = match other {
        '=' => "only one side of an equation can be written here",
        '[' | ']' => "square brackets only name a stage, as in `J_A[hit]`; group with round ones",
        '{' | '}' => "group with round brackets",
        '\u{b2}' | '\u{b3}' => "write a power with `^`, as in `v^2`",
        '\u{221a}' => "write a root as `sqrt(x)`",
        _ => return None,
    };
    Some(help.to_owned())
}

fn is_name_start(first: char) -> bool {
    first.is_alphabetic() || matches!(first, '\u{b0}' | '%')
}

/// Letters, digits and underscores, then any of `.component`, `[stage]` and `@instant`.
fn name_length(rest: &str) -> usize {
    let word = |text: &str| text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    let mut length =
        if rest.starts_with(['\u{b0}', '%']) { rest.chars().next().map_or(0, char::len_utf8) } else { word(rest) };
    while let Some(tail) = rest.get(length..) {
        let more = match tail.chars().next() {
            Some('.' | '@') => match tail.get(1..).map(word) {
                Some(part) if part > 0 => 1 + part,
                _ => break,
            },
            Some('[') => match tail.find(']') {
                Some(close) => close + 1,
                None => break,
            },
            _ => break,
        };
        length += more;
    }
    length
}

/// Digits with at most one point, and a power of ten where digits follow the `e`.
fn number(rest: &str, start: usize) -> Result<(Kind, usize), ParseFault> {
    let bytes = rest.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let whole = digits(0);
    let decimals = if bytes.get(whole) == Some(&b'.') { digits(whole + 1) } else { 0 };
    let mut length = whole + usize::from(bytes.get(whole) == Some(&b'.')) + decimals;
    let fault = |length: usize, message: String, help: &str| {
        Err(ParseFault { start, end: start + length, message, help: Some(help.to_owned()) })
    };
    if whole + decimals == 0 {
        return fault(1, "a point without digits".to_owned(), "write decimals as `0.5`");
    }
    let written = bytes.iter().take(length).filter(|byte| byte.is_ascii_digit());
    let mantissa = written.fold(dashu::Natural::ZERO, |number, digit| number * 10_u8 + (digit - b'0'));
    let mut value = Rational::from(mantissa);
    value /= Rational::from(dashu::Natural::from(10_u32).pow(decimals));
    if matches!(bytes.get(length), Some(b'e' | b'E')) {
        let signed = matches!(bytes.get(length + 1), Some(b'+' | b'-'));
        let from = length + 1 + usize::from(signed);
        let count = digits(from);
        if count > 0 {
            let size = rest.get(from..from + count).and_then(|text| text.parse::<u32>().ok());
            let Some(size) = size.filter(|size| *size <= MAX_EXPONENT) else {
                let message = format!("a power of ten beyond {MAX_EXPONENT}");
                return fault(from + count, message, "use a unit with a prefix");
            };
            let power = Rational::from(dashu::Natural::from(10_u32).pow(size as usize));
            value = if bytes.get(length + 1) == Some(&b'-') { value / power } else { value * power };
            length = from + count;
        }
    }
    if matches!(bytes.get(length), Some(b'.' | b'_' | b'0'..=b'9')) {
        let written: String = rest.chars().take_while(|c| c.is_ascii_digit() || matches!(c, '.' | '_')).collect();
        let message = format!("`{written}` is not a number");
        return fault(written.len(), message, "write a number with at most one point, as in `3.14`");
    }
    Ok((Kind::Number(value), length))
}
