//! Texts for a terminal: those that others wrote show their control characters, so that the terminal obeys none of them.

use std::borrow::Cow;
use std::io;
use std::io::Write;

use super::style::CODES;

/// Signs that turn the direction of writing, so that a text reads otherwise than it is.
const TURNS: [std::ops::RangeInclusive<char>; 2] = ['\u{202a}'..='\u{202e}', '\u{2066}'..='\u{2069}'];

/// The text with its control characters written out, as `\u{1b}`; line ends and tabs stay.
pub(super) fn visible(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_obeyed) { Cow::Owned(shown(text, &[])) } else { Cow::Borrowed(text) }
}

fn is_obeyed(letter: char) -> bool {
    letter.is_control() && !"\n\t".contains(letter) || TURNS.iter().any(|turns| turns.contains(&letter))
}

/// The text with its control characters written out, apart from those of these codes.
fn shown(text: &str, codes: &[&str]) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    loop {
        let code = codes.iter().chain(&["\r\n"]).find_map(|code| Some((code, rest.strip_prefix(code)?)));
        if let Some((code, behind)) = code {
            shown.push_str(code);
            rest = behind;
            continue;
        }
        let mut letters = rest.chars();
        match letters.next() {
            Some(letter) if is_obeyed(letter) => shown.extend(letter.escape_unicode()),
            Some(letter) => shown.push(letter),
            None => break,
        }
        rest = letters.as_str();
    }
    shown
}

/// A terminal to which whole lines go. Of control characters, only the program's own colours reach it as they are.
#[derive(Debug)]
pub(super) struct Terminal<W: Write> {
    to: W,
    waiting: Vec<u8>,
}

impl<W: Write> Terminal<W> {
    pub(super) fn new(to: W) -> Self {
        Self { to, waiting: Vec::new() }
    }

    /// Writes the first bytes of what is waiting.
    fn pass(&mut self, length: usize) -> io::Result<()> {
        let bytes: Vec<u8> = self.waiting.drain(..length).collect();
        self.to.write_all(shown(&String::from_utf8_lossy(&bytes), &CODES).as_bytes())
    }
}

impl<W: Write> Write for Terminal<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let before = self.waiting.len();
        self.waiting.extend_from_slice(bytes);
        if let Some(end) = bytes.iter().rposition(|byte| *byte == b'\n') {
            self.pass(before + end + 1)?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.pass(self.waiting.len())?;
        self.to.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_would_obey_is_written_out() {
        assert_eq!(visible("\u{1b}]0;pwned\u{7}\r"), r"\u{1b}]0;pwned\u{7}\u{d}");
        assert_eq!(visible("\u{9b}31m \u{202e}txt.exe\u{7f}"), r"\u{9b}31m \u{202e}txt.exe\u{7f}");
        let plain = "Größe\tä\r\n日本 \u{200f}";
        assert_eq!((visible("Größe\tä\n").as_ref(), shown(plain, &[]).as_str()), ("Größe\tä\n", plain));
    }

    #[test]
    fn only_the_programs_own_colours_pass_however_the_text_is_cut() {
        let text = "\u{1b}[32mgood\u{1b}[0m \u{1b}[2J é\u{1b}[8m\n\u{1b}[1mend";
        let expected = "\u{1b}[32mgood\u{1b}[0m \\u{1b}[2J é\\u{1b}[8m\n\u{1b}[1mend";
        for size in 1..=text.len() {
            let mut to = Vec::new();
            let mut terminal = Terminal::new(&mut to);
            for bytes in text.as_bytes().chunks(size) {
                terminal.write_all(bytes).unwrap();
            }
            terminal.flush().unwrap();
            assert_eq!(String::from_utf8(to).unwrap(), expected, "in pieces of {size}");
        }
    }
}
