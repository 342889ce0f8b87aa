//! The result: the format, the text, and the files that lie beside it.

use std::fmt;
use std::str::FromStr;

/// The formats a document can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Format {
    /// Markdown with `$`-mathematics, as GitHub and pandoc read it.
    Markdown,
    /// A complete document for pdfLaTeX.
    Latex,
    /// One page that needs no script and no network.
    Html,
    /// A complete document for Typst, which makes the PDF.
    Typst,
}

impl Format {
    /// Every format, in a fixed order.
    pub const ALL: [Self; 4] = [Self::Markdown, Self::Latex, Self::Html, Self::Typst];

    /// Its name, which is also the name of its folder of templates.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Markdown => "markdown",
            Self::Latex => "latex",
            Self::Html => "html",
            Self::Typst => "typst",
        }
    }

    /// The usual ending of its files, without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Markdown => "md",
            Self::Latex => "tex",
            Self::Html => "html",
            Self::Typst => "typ",
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.name())
    }
}

impl FromStr for Format {
    type Err = String;

    /// # Errors
    /// Where no format has that name; the message lists them.
    fn from_str(name: &str) -> Result<Self, String> {
        let named = Self::ALL.into_iter().find(|format| format.name() == name);
        named.ok_or_else(|| format!("`{name}` is not a format; there are {}", Self::ALL.map(Self::name).join(", ")))
    }
}

/// The place of the figures of a Markdown document; the others always hold their own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Figures {
    /// In the document, as SVG.
    #[default]
    Inline,
    /// In the document, without the rules that give them their look: the page around it has them ([`momentous_figure::style_sheet`]).
    Unstyled,
    /// In files named `PREFIX-1.svg`, `PREFIX-2.svg`, ... that the document refers to.
    Beside(String),
}

/// A document, ready to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// The text of the document itself.
    pub text: String,
    /// The files it refers to; they belong into the same folder.
    pub beside: Vec<BesideFile>,
}

/// A file that a document refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BesideFile {
    /// Its name, relative to the document's folder.
    pub name: String,
    /// Its text.
    pub text: String,
}
