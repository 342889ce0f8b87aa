//! Pieces of HTML for pages that are not documents: everything in a fragment is escaped and complete by itself.

use serde::Serialize;

use momentous_explain::Inline;
use momentous_expr::Math;
use momentous_fault::Faults;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::html::Html;
use super::page::Page;
use super::renderer::Renderer;
use super::writer::Writer;

/// A piece of HTML that is ready for a page. Only this room makes one, so whatever is in it has been escaped.
///
/// ```
/// use momentous_explain::Inline;
/// use momentous_render::Fragment;
/// assert_eq!(Fragment::inline(&[Inline::Text("a < b".into())]).as_str(), "a &lt; b");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Fragment(String);

impl Fragment {
    /// A run of text and mathematics.
    #[must_use]
    pub fn inline(run: &[Inline]) -> Self {
        Self(Html::Narrow.inline(run))
    }

    /// Mathematics within a line.
    #[must_use]
    pub fn math(math: &Math) -> Self {
        Self(Html::Narrow.math(math))
    }

    /// A figure as SVG that takes the style of its page, without its caption.
    #[must_use]
    pub fn figure(drawing: &Drawing) -> Self {
        Self(figure::svg_unstyled(drawing))
    }

    /// Figures among which somebody chooses, all of the same length: which is right is not told by their bytes.
    #[must_use]
    pub fn figures(drawings: &[Drawing]) -> Vec<Self> {
        /// With what every figure ends.
        const END: &str = "</svg>";
        let figures: Vec<String> = drawings.iter().map(figure::svg_unstyled).collect();
        let longest = figures.iter().map(String::len).max().unwrap_or(0);
        let as_long = |mut figure: String| {
            let (room, end) = (longest - figure.len(), figure.rfind(END).unwrap_or(figure.len()));
            figure.insert_str(end, &" ".repeat(room));
            Self(figure)
        };
        figures.into_iter().map(as_long).collect()
    }

    /// Markdown that an author wrote; the name says in faults where it stands.
    ///
    /// # Errors
    /// Where the text is not fit to print.
    pub fn authored(name: &str, text: &str, level: usize) -> Result<Self, Faults> {
        Ok(Self(Html::Narrow.authored(&Authored::check(name, text)?, level)))
    }

    /// A whole page of a document, without the document around it.
    ///
    /// # Errors
    /// Where an author's text is not fit to print, or a template fails.
    pub fn page(renderer: &Renderer, page: &Page) -> Result<Self, Faults> {
        renderer.body(page).map(Self)
    }

    /// The HTML.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }
}
