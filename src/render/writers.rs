//! The writer of each format.

use super::document::Format;
use super::html::Html;
use super::latex::Latex;
use super::markdown::Markdown;
use super::typst::Typst;
use super::writer::Writer;

/// The writer of a format.
pub(super) fn writer(format: Format) -> &'static dyn Writer {
    match format {
        Format::Markdown => &Markdown,
        Format::Latex => &Latex,
        Format::Html => &Html,
        Format::Typst => &Typst,
    }
}
