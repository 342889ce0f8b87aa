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
    /// One page that needs neither scripts nor a network.
    Html,
    /// One JSON object per line, one line per variant.
    Json,
}

impl Paper {
    /// The document's format; none for JSON, which is data.
    pub(super) fn document(self) -> Option<Format> {
        match self {
            Self::Markdown => Some(Format::Markdown),
            Self::Latex => Some(Format::Latex),
            Self::Html => Some(Format::Html),
            Self::Json => None,
        }
    }
}
