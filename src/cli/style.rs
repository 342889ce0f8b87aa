//! A little colour, on a terminal only.

use std::io::IsTerminal;

/// The beginnings of colours, and what ends them.
pub(super) const CODES: [&str; 5] = [STRONG, GOOD, BAD, NOTE, END];

const STRONG: &str = "\u{1b}[1m";
const GOOD: &str = "\u{1b}[32m";
const BAD: &str = "\u{1b}[1;31m";
const NOTE: &str = "\u{1b}[33m";
const END: &str = "\u{1b}[0m";

/// Writes words strongly where somebody looks, plainly into files and pipes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    on: bool,
}

impl Style {
    /// The style of standard output; off where `NO_COLOR` is set.
    pub(super) fn of_stdout() -> Self {
        let asked = std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        Self { on: asked && std::io::stdout().is_terminal() }
    }

    /// A heading.
    pub(super) fn strong(self, text: &str) -> String {
        self.wrap(STRONG, text)
    }

    /// Something that is right.
    pub(super) fn good(self, text: &str) -> String {
        self.wrap(GOOD, text)
    }

    /// Something that is wrong.
    pub(super) fn bad(self, text: &str) -> String {
        self.wrap(BAD, text)
    }

    /// Something to know.
    pub(super) fn note(self, text: &str) -> String {
        self.wrap(NOTE, text)
    }

    fn wrap(self, code: &str, text: &str) -> String {
        if self.on { format!("{code}{text}{END}") } else { text.to_owned() }
    }
}
