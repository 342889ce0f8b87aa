//! Typst, of which PDF is made.

use std::borrow::Cow;
use std::fmt::Write;

use pulldown_cmark::{Alignment, Event, Tag, TagEnd};

use momentous_expr::Math;
use momentous_expr::TypstMath;
use momentous_expr::quoted;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::authored::Piece;
use super::equation::PAPER;
use super::equation::Row;
use super::equation::smaller;
use super::mathml_typst;
use super::typst_text::escape;
use super::writer::Writer;

/// Sizes of type for equations that are so much too wide and cannot be broken.
const SMALLER: [&str; 3] = ["0.9em", "0.8em", "0.7em"];

/// The writer of Typst. What it calls ends with a semicolon, so that no text behind it is read as an argument.
pub(super) struct Typst;

impl Writer for Typst {
    fn text<'a>(&self, text: &'a str) -> Cow<'a, str> {
        Cow::Owned(escape(text))
    }

    fn emphasis(&self, text: &str) -> String {
        format!("#emph[{}];", escape(text))
    }

    fn strong(&self, text: &str) -> String {
        format!("#strong[{}];", escape(text))
    }

    fn math(&self, math: &Math) -> String {
        inline(&math.plain(), &math.typst())
    }

    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String {
        let mut code = TypstMath::default();
        if let [row] = rows {
            code.row(row.whole());
        } else {
            for (index, row) in rows.iter().enumerate() {
                if index > 0 {
                    code.put(" \\\n");
                }
                code.row(row.left());
                code.put("&");
                code.row(row.right());
            }
        }
        let plain: Vec<String> = rows.iter().map(|row| Math::row_plain(row.whole())).collect();
        let written = displayed(&plain.join(" "), &code.into_code(), number);
        match smaller(rows, PAPER, SMALLER) {
            Some(size) => format!("#[#set text(size: {size})\n{written}];"),
            None => written,
        }
    }

    /// The call that makes the picture, without a hash: it stands within a figure.
    fn figure(&self, drawing: &Drawing) -> String {
        let (picture, width) = (quoted(&figure::svg_paper(drawing)), drawing.high.x - drawing.low.x);
        let alternative = quoted(&format!("{}. {}", drawing.title, drawing.description));
        format!("image(bytes({picture}), format: \"svg\", width: {width:.2}pt, alt: {alternative})")
    }

    fn tex(&self, tex: &str, mathml: &str) -> String {
        inline(tex, &mathml_typst::typst(mathml))
    }

    fn authored(&self, text: &Authored, level: usize) -> String {
        let mut body = Body { level, deepest: level, ..Body::default() };
        for piece in &text.pieces {
            match piece {
                Piece::Event(event) => body.event(event),
                Piece::Math { tex, mathml, display: false } => {
                    body.out.push_str(&self.tex(tex, mathml));
                }
                Piece::Math { tex, mathml, display: true } => {
                    body.out.push_str(&displayed(tex.trim(), &mathml_typst::typst(mathml), None));
                }
            }
        }
        body.out.trim().to_owned()
    }
}

/// Mathematics within a line; whoever cannot see it is told the plain text. What is blank is no mathematics: it could not
/// be told.
fn inline(plain: &str, code: &str) -> String {
    if plain.trim().is_empty() {
        return String::new();
    }
    format!("#math.equation(alt: {}, ${code}$);", quoted(plain))
}

fn displayed(plain: &str, code: &str, number: Option<u32>) -> String {
    if plain.trim().is_empty() {
        return String::new();
    }
    let numbering = number.map_or_else(String::new, |number| format!(", numbering: _ => [({number})]"));
    format!("#math.equation(block: true, alt: {}{numbering}, $ {code} $);", quoted(plain))
}

/// The author's text as it is being written.
#[derive(Default)]
struct Body {
    out: String,
    /// The level of the author's first headings, and the deepest that may follow: no level is left out.
    level: usize,
    deepest: usize,
    /// The code being read, kept as it is.
    code: Option<String>,
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
            Event::Text(text) => match &mut self.code {
                Some(code) => code.push_str(text),
                None => self.push(&escape(text)),
            },
            Event::Code(text) => self.push(&format!("#raw({});", quoted(text))),
            Event::SoftBreak => self.push("\n"),
            Event::HardBreak => self.push("#linebreak();"),
            Event::Rule => self.push("\n#line(length: 100%, stroke: 0.5pt);\n"),
            // Mathematics and raw HTML are other pieces by now; the rest is switched off in the reader's options.
            Event::Html(_)
            | Event::InlineHtml(_)
            | Event::InlineMath(_)
            | Event::DisplayMath(_)
            | Event::FootnoteReference(_)
            | Event::TaskListMarker(_) => {}
        }
    }

    fn start(&mut self, tag: &Tag) {
        match tag {
            Tag::Paragraph => self.push("\n\n"),
            Tag::Heading { level, .. } => {
                let level = (*level as usize + self.level - 1).min(self.deepest);
                self.deepest = level + 1;
                self.push(&format!("\n#heading(level: {level})["));
            }
            Tag::BlockQuote(_) => self.push("\n#quote(block: true)["),
            Tag::CodeBlock(_) => self.code = Some(String::new()),
            Tag::List(None) => self.push("\n#list"),
            Tag::List(Some(first)) => self.push(&format!("\n#enum(start: {first})")),
            Tag::Item | Tag::TableCell => self.push("["),
            Tag::Emphasis => self.push("#emph["),
            Tag::Strong => self.push("#strong["),
            Tag::Link { dest_url, .. } => {
                self.push(&format!("#link({})[", quoted(dest_url)));
                self.links.push(dest_url.to_string());
            }
            Tag::Table(columns) => {
                let sides: Vec<&str> = columns.iter().copied().map(side).collect();
                let _ = write!(self.out, "\n#table(columns: {}, align: ({},), ", columns.len(), sides.join(", "));
            }
            Tag::TableHead => self.push("table.header("),
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Paragraph => self.push("\n\n"),
            TagEnd::Heading(_) | TagEnd::BlockQuote(_) => self.push("];\n"),
            TagEnd::CodeBlock => {
                let code = self.code.take().unwrap_or_default();
                // Lines keep their ends, which a literal has as `\n`; code without any line has one that is empty.
                let lines: Vec<String> = code.trim_end_matches('\n').split('\n').map(quoted).collect();
                self.push(&format!("\n#raw(block: true, ({},).join(\"\\n\"));\n", lines.join(", ")));
            }
            TagEnd::List(_) => self.push(";\n"),
            TagEnd::Item => self.push("]"),
            TagEnd::Emphasis | TagEnd::Strong => self.push("];"),
            TagEnd::Link => {
                let address = self.links.pop().unwrap_or_default();
                let is_shown = self.out.ends_with(&escape(&address));
                self.push("];");
                if !is_shown {
                    self.push(&format!(" ({})", escape(&address)));
                }
            }
            TagEnd::TableCell => self.push("], "),
            TagEnd::TableHead => self.push("), "),
            TagEnd::Table => self.push(");\n"),
            _ => {}
        }
    }
}

fn side(alignment: Alignment) -> &'static str {
    match alignment {
        Alignment::None | Alignment::Left => "left",
        Alignment::Center => "center",
        Alignment::Right => "right",
    }
}
