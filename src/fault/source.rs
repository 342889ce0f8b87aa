//! A text that faults point into, and the printing of a fault with its excerpt.

use std::sync::Arc;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

use super::Fault;

/// A half-open range of bytes of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// The byte after the last.
    pub end: usize,
}

/// A text with a name, as a rule a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Its path, as the user wrote it.
    pub name: Arc<str>,
    /// Its text.
    pub text: Arc<str>,
}

impl Source {
    /// A source of that name.
    #[must_use]
    pub fn new(name: &str, text: &str) -> Self {
        Self { name: name.into(), text: text.into() }
    }

    /// Line and column of a byte, both from 1; the column counts characters.
    ///
    /// ```
    /// use momentous_fault::Source;
    /// assert_eq!(Source::new("a.yaml", "id: a\nm: 2").line_and_column(9), (2, 4));
    /// ```
    #[must_use]
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let mut end = byte.min(self.text.len());
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &self.text[..end];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }

    /// A fault of this source as text: message, place, excerpt, way out.
    #[must_use]
    pub fn render(&self, fault: &Fault) -> String {
        let mut title =
            Level::ERROR.primary_title(fault.message.as_str()).elements([] as [annotate_snippets::Padding; 0]);
        if let Some(span) = fault.span {
            let start = span.start.min(self.text.len());
            let end = span.end.clamp(start, self.text.len());
            let snippet = Snippet::source(self.text.as_ref()).path(self.name.as_ref());
            title = title.element(snippet.annotation(AnnotationKind::Primary.span(start..end)));
        }
        if let Some(help) = &fault.help {
            title = title.element(Level::HELP.message(help.as_str()));
        }
        let place = match fault.span {
            None => format!("{}: ", self.name),
            Some(_) => String::new(),
        };
        format!("{place}{}\n", Renderer::plain().render(&[title]))
    }
}
