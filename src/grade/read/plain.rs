//! The text of an answer in plain characters, each of which still knows where it stood.

use super::latex;
use super::unreadable::{Unreadable, UnreadableKind};

/// The longest answer that is read, in characters.
pub const MAX_LENGTH: usize = 200;

/// The signs that may end an answer, as they end a sentence.
pub(super) const ENDS: [char; 6] = [' ', ',', '.', '!', ';', '?'];

/// The text with one kind of minus sign, space and multiplication dot, and without what LaTeX adds.
#[derive(Debug)]
pub(super) struct Plain {
    text: String,
    /// For each byte of the text, and for its end: the character of the answer.
    places: Vec<usize>,
}

/// The texts that stand for something plainer. Longer writings come before those that begin like them.
const REPLACED: &[(&str, &str)] = &[
    ("^{\\circ}", "°"),
    ("{}^\\circ", "°"),
    ("^\\circ", "°"),
    ("\\circ", "°"),
    ("\\hat{\\imath}", "î"),
    ("\\hat{\\jmath}", "ĵ"),
    ("\\hat{i}", "î"),
    ("\\hat{j}", "ĵ"),
    ("\\mathbf{i}", "î"),
    ("\\mathbf{j}", "ĵ"),
    ("\\langle", "<"),
    ("\\rangle", ">"),
    ("\\left", ""),
    ("\\right", ""),
    ("\\times", "×"),
    ("\\cdot", "·"),
    ("\\%", "%"),
    ("\\mu ", "µ"),
    ("\\mu", "µ"),
    ("\\pi", "π"),
    ("\\,", " "),
    ("\\;", " "),
    ("\\ ", " "),
    ("$", ""),
    (":=", "="),
];

/// Commands of LaTeX with an argument, and what opens the bracket that is read instead.
const WRAPPERS: &[(&str, &str)] = &[("\\mathrm{", "("), ("\\text{", "("), ("\\unit{", "("), ("\\sqrt{", "sqrt(")];

/// The sign of a degree.
const DEGREE: &str = "°";
/// The texts written for it.
const ZEROS_FOR_DEGREES: [&str; 4] = ["^{0}", "^(0)", "^0", "⁰"];

/// The offset between a full-width form and the ASCII character that it shows.
const FULL_WIDTH: u32 = 0xFEE0;

impl Plain {
    /// The plain form of an answer.
    pub(super) fn new(answer: &str) -> Result<Self, Unreadable> {
        if !answer.contains('\\') || answer.chars().count() > MAX_LENGTH {
            return Self::limited(answer, MAX_LENGTH);
        }
        let (expanded, places) = latex::expanded(answer);
        let mut plain = Self::limited(&expanded, usize::MAX)?;
        let starts: Vec<usize> = expanded.char_indices().map(|(at, _)| at).collect();
        let end = answer.chars().count();
        for place in &mut plain.places {
            *place = starts.get(*place).and_then(|at| places.get(*at)).copied().unwrap_or(end);
        }
        Ok(plain)
    }

    /// The plain form of an answer of at most so many characters.
    pub(super) fn limited(answer: &str, most: usize) -> Result<Self, Unreadable> {
        if answer.len() > most && answer.chars().nth(most).is_some() {
            return Err(Unreadable { at: most, kind: UnreadableKind::TooLong(most) });
        }
        let capacity = answer.len() + 1;
        let mut plain = Self { text: String::with_capacity(capacity), places: Vec::with_capacity(capacity) };
        if answer.bytes().all(|byte| byte.is_ascii() && !b"\\$^{}~:\t\n\r".contains(&byte)) {
            // Nothing to replace: the common case.
            plain.text.push_str(answer);
            plain.places.extend(0..=answer.len());
            return Ok(plain);
        }
        let mut braces: Vec<char> = Vec::new();
        let (mut rest, mut place) = (answer, 0);
        while let Some(first) = rest.chars().next() {
            let (read, written) = match known(rest) {
                Some((read, written)) => {
                    if read.ends_with('{') {
                        braces.push(')');
                    }
                    (read.len(), written.to_owned())
                }
                // Behind `s` it begins a power, before digits on the line it is a sign.
                None if first == '⁻' && rest[first.len_utf8()..].starts_with(|next: char| next.is_ascii_digit()) => {
                    (first.len_utf8(), "-".to_owned())
                }
                // At the start it is a sign for about, elsewhere a space that does not break.
                None if first == '~' && !plain.text.trim().is_empty() => (1, " ".to_owned()),
                None => (first.len_utf8(), plain_character(first, &mut braces)),
            };
            plain.push(&written, place);
            place += rest[..read].chars().count();
            rest = &rest[read..];
        }
        plain.places.push(place);
        Ok(plain)
    }

    fn push(&mut self, written: &str, place: usize) {
        self.text.push_str(written);
        self.places.resize(self.text.len(), place);
    }

    /// The plain text.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The same with the sign of a degree where a small zero is written for it, behind a number: `143^0`, `143⁰`.
    pub(super) fn with_degrees(mut self) -> Self {
        let mut at = 0;
        while at < self.text.len() {
            let sign = ZEROS_FOR_DEGREES.iter().find(|sign| self.text[at..].starts_with(**sign));
            let ends = |sign: &&&str| {
                !self.text[at + sign.len()..].starts_with(|next: char| next.is_ascii_digit() || next == '.')
            };
            let is_behind = self.text[..at].trim_end().ends_with(|last: char| last.is_ascii_digit() || last == ')');
            match sign.filter(ends).filter(|_| is_behind) {
                Some(sign) => {
                    let place = self.places.get(at).copied().unwrap_or(0);
                    self.text.replace_range(at..at + sign.len(), DEGREE);
                    self.places.splice(at..at + sign.len(), std::iter::repeat_n(place, DEGREE.len()));
                    at += DEGREE.len();
                }
                None => at += self.text[at..].chars().next().map_or(1, char::len_utf8),
            }
        }
        self
    }

    /// A fault at a byte of the plain text.
    pub(super) fn fault(&self, byte: usize, kind: UnreadableKind) -> Unreadable {
        let at = self.places.get(byte).or(self.places.last()).copied().unwrap_or(0);
        Unreadable { at, kind }
    }
}

fn known(rest: &str) -> Option<(&'static str, &'static str)> {
    REPLACED.iter().chain(WRAPPERS).find(|(read, _)| rest.starts_with(read)).copied()
}

fn plain_character(character: char, braces: &mut Vec<char>) -> String {
    let ascii = match u32::from(character) {
        code @ 0xFF01..=0xFF5E => char::from_u32(code - FULL_WIDTH).unwrap_or(character),
        _ => character,
    };
    match ascii {
        '−' | '–' | '—' | '‒' | '﹣' | '‐' | '‑' | '―' | '﹘' | '⁃' | '˗' | '➖' => "-".to_owned(),
        '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}' => String::new(),
        space if space.is_whitespace() => " ".to_owned(),
        '⋅' | '∙' | '•' | '‧' => "·".to_owned(),
        '’' | '‘' => "'".to_owned(),
        '”' | '“' | '″' => "\"".to_owned(),
        '˚' | '∘' | 'ᵒ' => "°".to_owned(),
        '∕' | '⁄' | '÷' => "/".to_owned(),
        '{' => {
            braces.push('}');
            ascii.to_string()
        }
        '}' => braces.pop().unwrap_or('}').to_string(),
        other => other.to_string(),
    }
}
