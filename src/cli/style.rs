//! A little colour, on a terminal only.

use std::io::IsTerminal;

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
        self.wrap("1", text)
    }

    /// Something that is right.
    pub(super) fn good(self, text: &str) -> String {
        self.wrap("32", text)
    }

    /// Something that is wrong.
    pub(super) fn bad(self, text: &str) -> String {
        self.wrap("1;31", text)
    }

    /// Something to know.
    pub(super) fn note(self, text: &str) -> String {
        self.wrap("33", text)
    }

    fn wrap(self, code: &str, text: &str) -> String {
        if self.on { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}
