//! The formats that a user can choose.

use clap::ValueEnum;

use crate::render::Format;

/// The format of a table or a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Listing {
    /// For people.
    #[value(alias = "table")]
    Text,
    /// One JSON object per line.
    Json,
}

/// The format of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Paper {
    /// Markdown with $-mathematics.
    Markdown,
    /// A document for pdfLaTeX.
    Latex,
    /// A document for Typst.
    Typst,
    /// A PDF, tagged and with its fonts, in a program built with the feature `pdf`.
    Pdf,
    /// One page that needs neither scripts nor a network.
    Html,
    /// One JSON object per line, one line per variant.
    Json,
}

impl Paper {
    /// The ending of its files, without the dot.
    pub(super) fn extension(self) -> &'static str {
        match self {
            Self::Pdf => "pdf",
            Self::Json => "json",
            Self::Markdown | Self::Latex | Self::Typst | Self::Html => self.document().map_or("", Format::extension),
        }
    }

    /// The format in which the document is written; none for JSON, which is data. PDF is made of Typst.
    pub(super) fn document(self) -> Option<Format> {
        match self {
            Self::Markdown => Some(Format::Markdown),
            Self::Latex => Some(Format::Latex),
            Self::Typst | Self::Pdf => Some(Format::Typst),
            Self::Html => Some(Format::Html),
            Self::Json => None,
        }
    }
}
