//! The writer of each format.

use super::document::Format;
use super::html::Html;
use super::latex::Latex;
use super::markdown::Markdown;
use super::typst::Typst;
use super::writer::Writer;

/// The writer of a format, as wide as paper or for a screen of any width.
pub(super) fn writer(format: Format, is_wide: bool) -> &'static dyn Writer {
    match format {
        Format::Html if is_wide => &Html::Wide,
        Format::Markdown => &Markdown,
        Format::Latex => &Latex,
        Format::Html => &Html::Narrow,
        Format::Typst => &Typst,
    }
}
