//! Documents in the format that the user chose, as the bytes of their files.

use crate::render::BesideFile;
use crate::render::Figures;
use crate::render::Format;
use crate::render::Page;
#[cfg(feature = "pdf")]
use crate::render::Press;
use crate::render::Renderer;

use super::failure::Failure;
use super::format::Paper;
#[cfg(feature = "pdf")]
use super::pages;
use super::pages::HtmlOptions;

/// The way out that is always there.
#[cfg(not(feature = "pdf"))]
const INSTEAD: &str = "take --format html, which every browser prints";

/// Writes documents in one format.
pub(super) struct Printer {
    renderer: Renderer,
    format: Format,
    #[cfg(feature = "pdf")]
    press: Option<Press>,
}

/// A document as it is written.
pub(super) struct Printed {
    pub bytes: Vec<u8>,
    /// The files that it refers to.
    pub beside: Vec<BesideFile>,
}

impl Printer {
    /// A printer of documents; none for JSON, which is data.
    pub(super) fn new(paper: Paper, held: HtmlOptions) -> Result<Option<Self>, Failure> {
        let Some(format) = paper.document() else { return Ok(None) };
        let renderer = held.renderer()?;
        #[cfg(feature = "pdf")]
        let press = if paper == Paper::Pdf { Some(Press::new(pages::templates().as_deref())?) } else { None };
        #[cfg(not(feature = "pdf"))]
        if paper == Paper::Pdf {
            return Err(Failure::unusable(format!(
                "this program was built without PDF\nhelp: {INSTEAD}, or build it with `cargo build --release --features pdf`"
            )));
        }
        Ok(Some(Self {
            renderer,
            format,
            #[cfg(feature = "pdf")]
            press,
        }))
    }

    /// The same printer, with the figures of Markdown documents elsewhere.
    pub(super) fn figures(mut self, figures: Figures) -> Self {
        self.renderer = self.renderer.figures(figures);
        self
    }

    /// One document of those pages.
    pub(super) fn print(&self, pages: &[Page]) -> Result<Printed, Failure> {
        let document = self.renderer.render(pages, self.format)?;
        #[cfg(feature = "pdf")]
        if let Some(press) = &self.press {
            return Ok(Printed { bytes: press.pdf(&document.text)?, beside: document.beside });
        }
        Ok(Printed { bytes: document.text.into_bytes(), beside: document.beside })
    }
}
