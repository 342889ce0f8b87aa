//! The outline of a document: prose, equations and figures, in no format yet.

use momentous_expr::Math;
use momentous_figure::Drawing;

/// A worked solution, section by section.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The problem's title.
    pub title: String,
    /// The sections in reading order.
    pub sections: Vec<Section>,
}

impl Outline {
    /// The same with other words; what the author wrote, and mathematics, stay.
    pub(super) fn reworded(mut self, reworded: &dyn Fn(&str) -> String) -> Self {
        for block in self.sections.iter_mut().flat_map(|section| &mut section.blocks) {
            match block {
                Block::Paragraph(run) => reword(run, reworded),
                Block::List(runs) => runs.iter_mut().for_each(|run| reword(run, reworded)),
                Block::Table { rows, .. } => rows.iter_mut().flatten().for_each(|run| reword(run, reworded)),
                Block::Figure(drawing) => drawing.reword(reworded),
                Block::Equation { .. } | Block::Authored(_) | Block::Space { .. } => {}
            }
        }
        self
    }
}

fn reword(run: &mut [Inline], reworded: &dyn Fn(&str) -> String) {
    for inline in run {
        if let Inline::Text(words) | Inline::Emphasis(words) | Inline::Strong(words) = inline {
            *words = reworded(words);
        }
    }
}

/// One section of a worked solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Its heading, without a number.
    pub heading: String,
    /// Its reader.
    pub audience: Audience,
    /// Its contents.
    pub blocks: Vec<Block>,
}

/// The reader of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Audience {
    /// Students and instructors.
    Everyone,
    /// Instructors only: certificates, the equations used.
    Instructor,
}

/// A block of an outline.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Running text.
    Paragraph(Vec<Inline>),
    /// A displayed equation, numbered where it is referred to.
    Equation {
        /// The equation, its first part to be aligned with the first part of `then`.
        lines: Vec<Math>,
        /// Its number.
        number: Option<u32>,
    },
    /// An unordered list.
    List(Vec<Vec<Inline>>),
    /// A figure with its caption.
    Figure(Box<Drawing>),
    /// A table: headings, then rows.
    Table {
        /// Column headings.
        head: Vec<Vec<Inline>>,
        /// Rows of cells.
        rows: Vec<Vec<Vec<Inline>>>,
    },
    /// Markdown that the problem's author wrote, placeholders filled in.
    Authored(String),
    /// Ruled space, where the next steps are left to the student.
    Space {
        /// How many lines.
        lines: u32,
    },
}

impl Block {
    /// A paragraph of plain words.
    pub(super) fn text(words: &str) -> Self {
        Self::Paragraph(vec![Inline::Text(words.to_owned())])
    }
}

/// A run inside a paragraph.
#[derive(Clone, Debug, PartialEq)]
pub enum Inline {
    /// Plain text.
    Text(String),
    /// Emphasised text.
    Emphasis(String),
    /// Strong text.
    Strong(String),
    /// Mathematics.
    Math(Math),
    /// Mathematics that an author wrote: TeX without its dollars.
    Tex(String),
}

impl Inline {
    /// A line that an author wrote: plain text but for mathematics between dollars, which begins and ends without a space.
    ///
    /// ```
    /// use momentous_explain::Inline;
    /// let [text, tex] = [|text: &str| Inline::Text(text.into()), |tex: &str| Inline::Tex(tex.into())];
    /// assert_eq!(Inline::line("it is $m v$."), [text("it is "), tex("m v"), text(".")]);
    /// assert_eq!(Inline::line("from $5 to $ 6"), [text("from $5 to $ 6")]);
    /// ```
    #[must_use]
    pub fn line(line: &str) -> Vec<Self> {
        let mut run = Vec::new();
        let (mut text, mut rest) = (String::new(), line);
        while let Some((before, behind)) = rest.split_once('$') {
            text.push_str(before);
            let tex = behind.split_once('$').filter(|(tex, _)| !tex.is_empty() && tex.trim() == *tex);
            rest = match tex {
                Some((tex, behind)) => {
                    run.extend((!text.is_empty()).then(|| Self::Text(std::mem::take(&mut text))));
                    run.push(Self::Tex(tex.to_owned()));
                    behind
                }
                None => {
                    text.push('$');
                    behind
                }
            };
        }
        text.push_str(rest);
        run.extend((!text.is_empty() || run.is_empty()).then_some(Self::Text(text)));
        run
    }
}
