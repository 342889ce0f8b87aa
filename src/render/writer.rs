//! The writer of a format; the templates arrange what it wrote.

use std::borrow::Cow;

use momentous_explain::Inline;
use momentous_expr::Math;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::authored::inline_mathml;
use super::equation;
use super::equation::PAPER;
use super::equation::Row;

/// The room that a run takes, in bytes, or less.
const USUAL_RUN: usize = 128;

/// The pieces of a document in one format. Every string returned is ready for it: escaped, and complete by itself.
pub(super) trait Writer {
    /// Plain text.
    fn text<'a>(&self, text: &'a str) -> Cow<'a, str>;
    /// Emphasised text.
    fn emphasis(&self, text: &str) -> String;
    /// Strong text.
    fn strong(&self, text: &str) -> String;
    /// Mathematics within a line, as an author wrote it and as the element that was made of it to check it.
    fn tex(&self, tex: &str, mathml: &str) -> String;
    /// Mathematics within a line.
    fn math(&self, math: &Math) -> String;
    /// A displayed equation.
    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String;
    /// The widest row of an equation, in widths of a digit, beside its number if it has one.
    fn widest(&self, _is_numbered: bool) -> f64 {
        PAPER
    }
    /// The rows of some lines, no wider than there is room, as a displayed equation.
    fn displayed(&self, lines: &[Math], number: Option<u32>) -> String {
        self.equation(&equation::rows(lines, self.widest(number.is_some())), number)
    }
    /// A figure without its caption.
    fn figure(&self, drawing: &Drawing) -> String;
    /// The author's text, its own headings at least of that level.
    fn authored(&self, text: &Authored, level: usize) -> String;

    /// A run of text and mathematics.
    fn inline(&self, run: &[Inline]) -> String {
        let mut written = String::with_capacity(USUAL_RUN);
        for part in run {
            match part {
                Inline::Text(text) => written.push_str(&self.text(text)),
                Inline::Emphasis(text) => written.push_str(&self.emphasis(text)),
                Inline::Strong(text) => written.push_str(&self.strong(text)),
                Inline::Math(math) => written.push_str(&self.math(math)),
                Inline::Tex(tex) => match inline_mathml(tex) {
                    Some(mathml) => written.push_str(&self.tex(tex, &mathml)),
                    None => written.push_str(&self.text(&format!("${tex}$"))),
                },
            }
        }
        written
    }
}
