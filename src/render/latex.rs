//! LaTeX for pdfLaTeX, with the packages that the template loads.

use std::borrow::Cow;

use pulldown_cmark::{Alignment, CodeBlockKind, Event, Tag, TagEnd};

use momentous_expr::Math;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::authored::Piece;
use super::equation::PAPER;
use super::equation::Row;
use super::equation::smaller;
use super::latex_text;
use super::latex_text::escape;
use super::writer::Writer;

/// Sizes of type for equations that are so much too wide and cannot be broken.
const SMALLER: [&str; 3] = ["\\small", "\\footnotesize", "\\scriptsize"];

/// The writer of LaTeX.
pub(super) struct Latex;

impl Writer for Latex {
    fn text<'a>(&self, text: &'a str) -> Cow<'a, str> {
        Cow::Owned(escape(text))
    }

    fn emphasis(&self, text: &str) -> String {
        format!("\\emph{{{}}}", escape(text))
    }

    fn strong(&self, text: &str) -> String {
        format!("\\textbf{{{}}}", escape(text))
    }

    fn math(&self, math: &Math) -> String {
        format!("${}$", latex_text::math(&math.latex()))
    }

    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String {
        let equation = format!("\\[\n{}\n\\]", latex_text::math(&latex_text::equation(rows, number)));
        match smaller(rows, PAPER, SMALLER) {
            Some(size) => format!("{{{size}\n{equation}\n}}"),
            None => equation,
        }
    }

    fn figure(&self, drawing: &Drawing) -> String {
        figure::tikz(drawing)
    }

    fn tex(&self, tex: &str, _mathml: &str) -> String {
        format!("${}$", latex_text::math(tex))
    }

    fn authored(&self, text: &Authored, _level: usize) -> String {
        let mut body = Body::default();
        for piece in &text.pieces {
            match piece {
                Piece::Event(event) => body.event(event),
                Piece::Math { tex, mathml, display: false } => body.push(&self.tex(tex, mathml)),
                Piece::Math { tex, display: true, .. } => {
                    body.push(&format!("\n\\[\n{}\n\\]\n", latex_text::math(tex.trim())));
                }
            }
        }
        body.out.trim().to_owned()
    }
}

/// The author's text as it is being written.
#[derive(Default)]
struct Body {
    out: String,
    /// Columns of the table being written, and how many cells its present row has.
    columns: Vec<Alignment>,
    cells: usize,
    /// Whether line ends are to be kept, in code.
    in_code: bool,
    /// The next number of each list that is open, where it is numbered.
    numbers: Vec<Option<u64>>,
    /// The targets of the links that are open.
    links: Vec<String>,
}

impl Body {
    fn push(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn event(&mut self, event: &Event) {
        match event {
            Event::Start(tag) => self.start(tag),
            Event::End(tag) => self.end(*tag),
            Event::Text(text) if self.in_code => self.code_lines(text),
            Event::Text(text) => self.push(&escape(text)),
            Event::Code(text) => self.push(&format!("\\texttt{{{}}}", escape(text))),
            Event::SoftBreak => self.push("\n"),
            Event::HardBreak => self.push(" \\newline\n"),
            Event::Rule => self.push("\n\\par\\medskip\\hrule\\medskip\n"),
            // Mathematics and raw HTML are other pieces by now; the rest is switched off in the reader's options.
            Event::Html(_)
            | Event::InlineHtml(_)
            | Event::InlineMath(_)
            | Event::DisplayMath(_)
            | Event::FootnoteReference(_)
            | Event::TaskListMarker(_) => {}
        }
    }

    /// Code keeps its lines and its gaps, without `verbatim`, which the text could close.
    fn code_lines(&mut self, text: &str) {
        for line in text.lines() {
            let line = escape(line).replace(' ', "~");
            self.push(&format!("\\texttt{{{line}}}\\\\\n"));
        }
    }

    /// Numbers are written out, since LaTeX's own counters start at one.
    fn item(&mut self) {
        match self.numbers.last_mut() {
            Some(Some(number)) => {
                let label = format!("\\item[{number}.] ");
                *number = number.saturating_add(1);
                self.push(&label);
            }
            _ => self.push("\\item{} "),
        }
    }

    fn start(&mut self, tag: &Tag) {
        match tag {
            Tag::Paragraph => self.push("\n"),
            Tag::Heading { .. } => self.push("\n\\paragraph*{"),
            Tag::BlockQuote(_) => self.push("\n\\begin{quote}\n"),
            Tag::CodeBlock(CodeBlockKind::Indented | CodeBlockKind::Fenced(_)) => {
                self.in_code = true;
                self.push("\n\\begin{flushleft}\n");
            }
            Tag::List(first) => {
                self.numbers.push(*first);
                self.push("\n\\begin{itemize}\n");
            }
            Tag::Item => self.item(),
            Tag::Emphasis => self.push("\\emph{"),
            Tag::Strong => self.push("\\textbf{"),
            Tag::Link { dest_url, .. } => self.links.push(dest_url.to_string()),
            Tag::Table(columns) => {
                self.columns.clone_from(columns);
                let letters: String = columns.iter().copied().map(column).collect();
                self.push(&format!("\n\\begin{{center}}\n\\begin{{tabular}}{{{letters}}}\n\\toprule\n"));
            }
            Tag::TableHead | Tag::TableRow => self.cells = 0,
            Tag::TableCell => {
                if self.cells > 0 {
                    self.push(" & ");
                }
                self.cells += 1;
                self.push("{}"); // a bracket here would be read as an argument of the line end before it
            }
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Paragraph | TagEnd::Item => self.push("\n"),
            TagEnd::Heading(_) => self.push("}\n"),
            TagEnd::BlockQuote(_) => self.push("\\end{quote}\n"),
            TagEnd::CodeBlock => {
                self.in_code = false;
                self.push("\\end{flushleft}\n");
            }
            TagEnd::List(_) => {
                self.numbers.pop();
                self.push("\\end{itemize}\n");
            }
            TagEnd::Emphasis | TagEnd::Strong => self.push("}"),
            TagEnd::Link => {
                let address = self.links.pop().unwrap_or_default();
                if !self.out.ends_with(&escape(&address)) {
                    self.push(&format!(" (\\texttt{{{}}})", escape(&address)));
                }
            }
            TagEnd::TableHead => self.push(" \\\\\n\\midrule\n"),
            TagEnd::TableRow => self.push(" \\\\\n"),
            TagEnd::Table => self.push("\\bottomrule\n\\end{tabular}\n\\end{center}\n"),
            _ => {}
        }
    }
}

fn column(alignment: Alignment) -> char {
    match alignment {
        Alignment::None | Alignment::Left => 'l',
        Alignment::Center => 'c',
        Alignment::Right => 'r',
    }
}
