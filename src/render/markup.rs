//! Pieces of text for the pages of other programs: well-formed as XML where they are HTML, with figures in files of their own.

use std::borrow::Cow;
use std::fmt::Write as _;

use pulldown_cmark::{Alignment, Event, Tag};

use momentous_explain::Audience;
use momentous_explain::Block;
use momentous_explain::Inline;
use momentous_explain::Outline;
use momentous_expr::Math;
use momentous_fault::Faults;
use momentous_figure::Drawing;

use super::authored::{Authored, Piece};

use super::equation::Row;
use super::html;
use super::html::escape;
use super::latex_text;
use super::markdown::Markdown;
use super::writer::Writer;

/// The cells of a row of an aligned equation. Style sheets do not go along, so each says by itself to which side it keeps.
const ALIGNED: [&str; 2] = ["<mtd style=\"text-align: right\">", "<mtd style=\"text-align: left\">"];

/// Markup that the page of another program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Markup {
    /// HTML with mathematics as elements of `MathML`.
    MathMl,
    /// HTML with mathematics as TeX in `\( \)` and `\[ \]`, for a page that typesets it.
    Tex,
    /// HTML with mathematics as the pictures that Canvas makes of TeX.
    Pictures,
    /// Markdown with mathematics as TeX in dollars.
    Markdown,
}

impl Markup {
    /// A text.
    #[must_use]
    pub fn text(self, text: &str) -> String {
        Writer::text(&self, text).into_owned()
    }

    /// A text in an attribute of HTML, between quotation marks.
    #[must_use]
    pub fn attribute(self, text: &str) -> String {
        escape(text)
    }

    /// A run of text and mathematics.
    ///
    /// ```
    /// use momentous_explain::Inline;
    /// use momentous_expr::Math;
    /// use momentous_render::Markup;
    /// let run = [Inline::Text("a < ".into()), Inline::Math(Math::Identifier("v".into()))];
    /// assert_eq!(Markup::Tex.inline(&run), r"a &lt; \(v\)");
    /// ```
    #[must_use]
    pub fn inline(self, run: &[Inline]) -> String {
        Writer::inline(&self, run)
    }

    /// A line that an author wrote, with mathematics between dollars.
    #[must_use]
    pub fn line(self, line: &str) -> String {
        self.inline(&Inline::line(line))
    }

    /// Mathematics within a line.
    #[must_use]
    pub fn math(self, math: &Math) -> String {
        Writer::math(&self, math)
    }

    /// Markdown that an author wrote, its headings at least of that level; the name says in faults where it stands.
    ///
    /// # Errors
    /// Where the text is not fit to print.
    pub fn authored(self, name: &str, text: &str, level: usize) -> Result<String, Faults> {
        Ok(Writer::authored(&self, &Authored::check(name, text)?, level))
    }

    /// A paragraph of what is written already.
    #[must_use]
    pub fn paragraph(self, written: &str) -> String {
        if self == Self::Markdown { format!("{written}\n\n") } else { format!("<p>{written}</p>\n") }
    }

    /// A picture with what it shows in words.
    #[must_use]
    pub fn picture(self, address: &str, drawing: &Drawing) -> String {
        let (about, caption) = (self.text(&drawing.description), &drawing.caption);
        let picture = match self {
            Self::Markdown => format!("![{about}]({address})"),
            _ => format!("<img src=\"{}\" alt=\"{}\"/>", escape(address), escape(&drawing.description)),
        };
        let caption = if caption.is_empty() { String::new() } else { self.paragraph(&self.emphasis(caption)) };
        self.paragraph(&picture) + &caption
    }

    /// The sections of an outline that everyone reads. `picture` says what stands for a figure.
    ///
    /// # Errors
    /// Where an author's text is not fit to print.
    pub fn outline(
        self,
        outline: &Outline,
        level: usize,
        mut picture: impl FnMut(&Drawing) -> String,
    ) -> Result<String, Faults> {
        let mut out = String::new();
        let sections = outline.sections.iter().filter(|section| section.audience == Audience::Everyone);
        for (section, number) in sections.zip(1..) {
            let heading = format!("{number}. {}", self.text(&section.heading));
            let heading = match self {
                Self::Markdown => self.paragraph(&format!("**{heading}**")),
                _ => format!("<h{level}>{heading}</h{level}>\n"),
            };
            out.push_str(&heading);
            for block in &section.blocks {
                match block {
                    Block::Figure(drawing) => out.push_str(&picture(drawing)),
                    Block::Authored(text) => {
                        out.push_str(&self.authored(&outline.title, text, level + 1)?);
                        out.push_str("\n\n");
                    }
                    _ => self.block(block, &mut out),
                }
            }
        }
        Ok(out)
    }

    fn block(self, block: &Block, out: &mut String) {
        match block {
            Block::Paragraph(run) => out.push_str(&self.paragraph(&self.inline(run))),
            Block::Equation { lines, number } => {
                out.push_str(&Writer::displayed(&self, lines, *number));
                out.push_str(if self == Self::Markdown { "\n\n" } else { "\n" });
            }
            Block::List(items) => {
                let items = items.iter().map(|item| self.inline(item));
                let [before, opening, closing, behind] = match self {
                    Self::Markdown => ["", "- ", "\n", "\n"],
                    _ => ["<ul>", "<li>", "</li>", "</ul>\n"],
                };
                out.push_str(before);
                out.extend(items.flat_map(|item| [opening.to_owned(), item, closing.to_owned()]));
                out.push_str(behind);
            }
            Block::Table { head, rows } => out.push_str(&self.table(head, rows)),
            // The first two are no business of a single block; space is left on paper only.
            Block::Figure(_) | Block::Authored(_) | Block::Space { .. } => {}
        }
    }

    fn table(self, head: &[Vec<Inline>], rows: &[Vec<Vec<Inline>>]) -> String {
        if self == Self::Markdown {
            let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
            let written = |cells: &[Vec<Inline>]| row(cells.iter().map(|cell| self.inline(cell)).collect());
            let rows: Vec<String> = rows.iter().map(|cells| written(cells)).collect();
            return format!("{}{}{}\n", written(head), row(vec!["---".to_owned(); head.len()]), rows.concat());
        }
        let row = |cells: &[Vec<Inline>], name: &str| {
            let cells = cells.iter().map(|cell| format!("<{name}>{}</{name}>", self.inline(cell)));
            format!("<tr>{}</tr>", cells.collect::<Vec<_>>().concat())
        };
        let rows: Vec<String> = rows.iter().map(|cells| row(cells, "td")).collect();
        format!("<table><thead>{}</thead><tbody>{}</tbody></table>\n", row(head, "th"), rows.concat())
    }
}

impl Writer for Markup {
    fn text<'a>(&self, text: &'a str) -> Cow<'a, str> {
        match self {
            Self::Markdown => Markdown.text(text),
            _ => Cow::Owned(plain(text)),
        }
    }

    fn emphasis(&self, text: &str) -> String {
        match self {
            Self::Markdown => Markdown.emphasis(text),
            _ => format!("<em>{}</em>", plain(text)),
        }
    }

    fn strong(&self, text: &str) -> String {
        match self {
            Self::Markdown => Markdown.strong(text),
            _ => format!("<strong>{}</strong>", plain(text)),
        }
    }

    fn math(&self, math: &Math) -> String {
        match self {
            Self::Markdown => Markdown.math(math),
            Self::MathMl => math.mathml(false),
            Self::Tex | Self::Pictures => self.on_page(&math.latex(), false),
        }
    }

    fn tex(&self, tex: &str, mathml: &str) -> String {
        match self {
            Self::Markdown => Markdown.tex(tex, mathml),
            Self::MathMl => with_namespace(mathml),
            Self::Tex | Self::Pictures => self.on_page(tex.trim(), false),
        }
    }

    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String {
        match self {
            Self::Markdown => Markdown.equation(rows, number),
            Self::Tex => self.paragraph(&self.on_page(&latex_text::equation(rows, number), true)),
            Self::MathMl => {
                let mut equation = with_namespace(&html::display(rows, ALIGNED));
                if let (Some(number), Some(end)) = (number, equation.rfind("</math>")) {
                    equation.insert_str(end, &format!("<mspace width=\"2em\"/><mtext>({number})</mtext>"));
                }
                self.paragraph(&equation)
            }
            Self::Pictures => {
                let number = number.map(|number| format!(" ({number})")).unwrap_or_default();
                self.paragraph(&(self.on_page(&latex_text::equation(rows, None), true) + &number))
            }
        }
    }

    fn figure(&self, drawing: &Drawing) -> String {
        Writer::text(self, &drawing.description).into_owned()
    }

    fn authored(&self, text: &Authored, level: usize) -> String {
        if *self == Self::Markdown {
            return Markdown.authored(text, level);
        }
        let events = text.pieces.iter().map(|piece| match piece {
            // How columns are aligned is a matter of style, which many programs take out.
            Piece::Event(Event::Start(Tag::Table(columns))) => {
                Event::Start(Tag::Table(vec![Alignment::None; columns.len()]))
            }
            Piece::Event(Event::Text(text)) => Event::InlineHtml(plain(text).into()),
            Piece::Event(Event::Code(text)) => Event::InlineHtml(format!("<code>{}</code>", plain(text)).into()),
            Piece::Event(event) => html::lower_heading(event.clone(), level),
            Piece::Math { tex, display: true, .. } if *self != Self::MathMl => {
                Event::InlineHtml(self.on_page(tex.trim(), true).into())
            }
            Piece::Math { tex, mathml, .. } => Event::InlineHtml(Writer::tex(self, tex, mathml).into()),
        });
        let mut out = String::new();
        pulldown_cmark::html::push_html(&mut out, events);
        out.trim_end().to_owned()
    }
}

impl Markup {
    /// TeX on a page of HTML.
    fn on_page(self, source: &str, display: bool) -> String {
        let tex = escape(source);
        match (self, display) {
            (Self::Pictures, _) => {
                let address = percent_encoded(source);
                format!(
                    "<img class=\"equation_image\" src=\"/equation_images/{address}?scale=1\" alt=\"LaTeX: {tex}\" \
                     data-equation-content=\"{tex}\"/>"
                )
            }
            (_, false) => format!("\\({tex}\\)"),
            (_, true) => format!("\\[{tex}\\]"),
        }
    }
}

/// Text in which no page finds mathematics.
fn plain(text: &str) -> String {
    let mut out = escape(text);
    for (opening, apart) in [("\\(", "\\<span>(</span>"), ("\\[", "\\<span>[</span>"), ("$", "<span>$</span>")] {
        if out.contains(opening) {
            out = out.replace(opening, apart);
        }
    }
    out
}

/// A text as part of an address.
fn percent_encoded(text: &str) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-_.~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            // Writing to a string cannot fail.
            let _ = write!(out, "%{byte:02X}");
        }
    }
    out
}

/// An element that stands by itself also in XML.
fn with_namespace(mathml: &str) -> String {
    let rest = mathml.strip_prefix("<math").filter(|_| !mathml.contains("xmlns="));
    rest.map_or_else(|| mathml.to_owned(), |rest| format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\"{rest}"))
}
