//! From pages to a document.

use std::path::Path;
use std::sync::OnceLock;

use momentous_fault::Faults;
use momentous_grade::Statistics;

use super::document::{Document, Figures, Format};
use super::font;
use super::page::{Key, Page, PageView, Sheet, Solution};
use super::templates::Templates;
use super::typst_text;
use super::view::View;

/// Renders pages through templates.
///
/// ```
/// use momentous_render::{Format, Identity, Renderer, Sheet};
///
/// let sheet = Sheet {
///     title: "Two carts".into(),
///     identity: Identity { problem: "impact/two-carts".into(), seed: Some(1), ..Identity::default() },
///     statement: "Cart A moves at $v = 2$ m/s & cart B is at rest.".into(),
///     ..Sheet::default()
/// };
/// let renderer = Renderer::new(None)?;
/// assert!(renderer.render_sheets(&[sheet.clone()], Format::Html)?.text.contains("m/s &amp; cart B"));
/// assert!(renderer.render_sheets(&[sheet], Format::Latex)?.text.contains(r"m/s \& cart B"));
/// # Ok::<(), momentous_fault::Faults>(())
/// ```
pub struct Renderer {
    /// In the order of the formats. The built-in ones are read when they are first wanted: that takes longer than a solution,
    /// and most programs write one format.
    templates: [OnceLock<Templates>; Format::ALL.len()],
    figures: Figures,
    language: String,
    /// A rule with the font of mathematics; empty where documents do without.
    font: String,
    /// Whether HTML is as wide as paper.
    is_wide: bool,
}

impl Renderer {
    /// A renderer with the built-in templates, or with a folder's files in their place.
    ///
    /// The folder is laid out as `templates/` is: `markdown/sheet.tera`, `html/style.css`. Further `.tera` files in it
    /// may be included or extended from there.
    ///
    /// # Errors
    /// Where the folder cannot be read, or a template is not well formed.
    pub fn new(overrides: Option<&Path>) -> Result<Self, Faults> {
        let templates = [const { OnceLock::new() }; Format::ALL.len()];
        if overrides.is_some() {
            // What is wrong with a user's is said before anything is written.
            for (format, kept) in Format::ALL.into_iter().zip(&templates) {
                let loaded = Templates::load(format, overrides)?;
                kept.get_or_init(|| loaded);
            }
        }
        Ok(Self { templates, figures: Figures::Inline, language: "en".to_owned(), font: String::new(), is_wide: false })
    }

    /// The same renderer, with the figures of Markdown documents elsewhere.
    #[must_use]
    pub fn figures(mut self, figures: Figures) -> Self {
        self.figures = figures;
        self
    }

    /// The same renderer, for texts in that language (a BCP 47 tag such as `en` or `de-CH`).
    #[must_use]
    pub fn language(mut self, tag: &str) -> Self {
        tag.clone_into(&mut self.language);
        self
    }

    /// The same renderer, whose HTML documents are as wide as paper: their equations break as in print, and not for a telephone.
    #[must_use]
    pub fn wide(mut self) -> Self {
        self.is_wide = true;
        self
    }

    /// The same renderer, whose HTML documents hold the font of their mathematics where they have any.
    ///
    /// Without it, roots and brackets grow only where the reader's machine has such a font. It makes a document longer by
    /// four thirds of [`super::MATH_FONT`].
    #[must_use]
    pub fn with_font(mut self) -> Self {
        self.font = font::rule();
        self
    }

    /// A document of problem sheets, each on a page of its own where it is printed.
    ///
    /// # Errors
    /// Where a statement is not fit to print, or a template fails.
    pub fn render_sheets(&self, sheets: &[Sheet], format: Format) -> Result<Document, Faults> {
        let pages: Vec<PageView> = sheets.iter().map(PageView::Sheet).collect();
        self.document(&pages, format)
    }

    /// A document of one worked solution, faded where it says so.
    ///
    /// # Errors
    /// Where the author's text in it is not fit to print, or a template fails.
    pub fn render_solution(&self, solution: &Solution, format: Format) -> Result<Document, Faults> {
        self.document(&[PageView::Solution(solution)], format)
    }

    /// A document of one answer key.
    ///
    /// # Errors
    /// Where a template fails.
    pub fn render_key(&self, key: &Key, format: Format) -> Result<Document, Faults> {
        self.document(&[PageView::Key(key)], format)
    }

    /// A page with the statistics of a class's answers, as HTML.
    ///
    /// # Errors
    /// Where a template fails.
    pub fn render_statistics(&self, statistics: &Statistics) -> Result<String, Faults> {
        let templates = self.templates(Format::Html)?;
        let mut context = tera::Context::new();
        context.insert("language", &self.language);
        context.insert_value("style", tera::Value::safe_string(&templates.style));
        context.insert("statistics", statistics);
        // A class of which nothing counts has bars, too.
        context.insert("most", &statistics.histogram.iter().max().map_or(1, |most| (*most).max(1)));
        templates.render_from("statistics.tera", &context)
    }

    /// A document of any pages: a sheet with its solution, a whole class's sheets with the key.
    ///
    /// # Errors
    /// Where an author's text is not fit to print, or a template fails.
    pub fn render(&self, pages: &[Page], format: Format) -> Result<Document, Faults> {
        let pages: Vec<PageView> = pages.iter().map(PageView::from).collect();
        self.document(&pages, format)
    }

    /// A page alone, as HTML.
    pub(super) fn body(&self, page: &Page) -> Result<String, Faults> {
        let mut view = View::new(Format::Html, &self.figures, self.is_wide);
        let context = view.document(&[PageView::from(page)])?;
        self.templates(Format::Html)?.render_from("body.tera", &context)
    }

    fn templates(&self, format: Format) -> Result<&Templates, Faults> {
        let kept = &self.templates[format as usize];
        match kept.get() {
            Some(templates) => Ok(templates),
            None => {
                let loaded = Templates::load(format, None)?;
                Ok(kept.get_or_init(|| loaded))
            }
        }
    }

    fn document(&self, pages: &[PageView], format: Format) -> Result<Document, Faults> {
        let templates = self.templates(format)?;
        let mut view = View::new(format, &self.figures, self.is_wide);
        let mut context = view.document(pages)?;
        context.insert("language", &self.language);
        let (code, region) = typst_text::language(&self.language);
        context.insert("language_code", &code);
        context.insert("region", &region);
        context.insert_value("style", tera::Value::safe_string(&templates.style));
        context.insert_value("font", tera::Value::safe_string(&self.font));
        let text = templates.render(&context)?;
        Ok(Document { text, beside: view.beside })
    }
}
