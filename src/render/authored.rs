//! The author's Markdown, read once and checked, so that every format may print it.

use std::ops::Range;

use math_core::LatexToMathML;
use math_core::MathDisplay;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use momentous_explain::Inline;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_fault::Span;

use super::depth::DEEPEST as DEEPEST_MATH;
use super::depth::too_deep;

/// How deep lists and quotations may nest: LaTeX knows no deeper.
const DEEPEST: usize = 4;

/// The schemes of links; anything else could run code or name a file of the reader.
const SCHEMES: [&str; 3] = ["https://", "http://", "mailto:"];

/// Markdown that was checked: its mathematics is well formed, nothing in it reaches outside the document.
///
/// Raw HTML in it is text, and is printed as such.
#[derive(Debug)]
pub(super) struct Authored<'a> {
    /// The text that the author wrote.
    pub source: &'a str,
    /// Its pieces in reading order.
    pub pieces: Vec<Piece<'a>>,
    /// The places of raw HTML in the source.
    pub raw_html: Vec<Range<usize>>,
}

/// A piece of checked Markdown.
#[derive(Debug)]
pub(super) enum Piece<'a> {
    /// Anything but mathematics; never raw HTML, never a picture.
    Event(Event<'a>),
    /// Mathematics.
    Math {
        /// The text as the author wrote it, without its dollars.
        tex: String,
        /// The same as a complete `<math>` element.
        mathml: String,
        /// Whether it is displayed.
        display: bool,
    },
}

/// Every fault of an author's Markdown, with its place in that text.
#[must_use]
pub fn text_faults(text: &str) -> Vec<Fault> {
    Authored::check("", text).err().map_or_else(Vec::new, |faults| faults.list)
}

/// Every fault of the mathematics in a line that is plain text but for it.
#[must_use]
pub fn line_faults(line: &str) -> Vec<Fault> {
    let faults = Inline::line(line).into_iter().filter_map(|part| match part {
        Inline::Tex(tex) => inline(&tex).err(),
        Inline::Text(_) | Inline::Emphasis(_) | Inline::Strong(_) | Inline::Math(_) => None,
    });
    faults.map(|fault| Fault { span: None, ..fault }).collect()
}

/// Mathematics within a line as a complete `<math>` element; none where it is at fault.
pub(super) fn inline_mathml(tex: &str) -> Option<String> {
    match inline(tex) {
        Ok(Piece::Math { mathml, .. }) => Some(mathml),
        Ok(Piece::Event(_)) | Err(_) => None,
    }
}

fn inline(tex: &str) -> Result<Piece<'static>, Fault> {
    math(tex, tex, &(0..tex.len()), MathDisplay::Inline, &LatexToMathML::default())
}

impl<'a> Authored<'a> {
    /// Reads and checks Markdown; `name` says in faults where it comes from.
    pub fn check(name: &str, source: &'a str) -> Result<Self, Faults> {
        let options = Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_SMART_PUNCTUATION;
        let converter = LatexToMathML::default();
        let mut checked = Self { source, pieces: Vec::new(), raw_html: Vec::new() };
        let mut faults = Vec::new();
        let mut depth = 0_usize;
        for (event, range) in Parser::new_ext(source, options).into_offset_iter() {
            depth = match &event {
                Event::Start(Tag::List(_) | Tag::BlockQuote(_)) => depth + 1,
                Event::End(TagEnd::List(_) | TagEnd::BlockQuote(_)) => depth.saturating_sub(1),
                _ => depth,
            };
            match checked.piece(event, &range, depth, &converter) {
                Ok(piece) => checked.pieces.push(piece),
                Err(fault) => {
                    let span = fault.span.unwrap_or(Span { start: range.start, end: range.end });
                    faults.push(fault.at(span));
                }
            }
        }
        if faults.is_empty() { Ok(checked) } else { Err(Faults { source: Source::new(name, source), list: faults }) }
    }

    fn piece(
        &mut self,
        event: Event<'a>,
        range: &Range<usize>,
        depth: usize,
        converter: &LatexToMathML,
    ) -> Result<Piece<'a>, Fault> {
        let text_fault = |message: &str| Fault::new(Code::Text, message);
        let event = match event {
            Event::InlineMath(tex) => return math(self.source, &tex, range, MathDisplay::Inline, converter),
            Event::DisplayMath(tex) => return math(self.source, &tex, range, MathDisplay::Block, converter),
            Event::Html(text) | Event::InlineHtml(text) => {
                self.raw_html.push(range.clone());
                Event::Text(text)
            }
            Event::Start(Tag::HtmlBlock) => Event::Start(Tag::Paragraph),
            Event::End(TagEnd::HtmlBlock) => Event::End(TagEnd::Paragraph),
            Event::Start(Tag::Image { .. }) => {
                return Err(text_fault("a document holds its own pictures, and cannot fetch one")
                    .help("the figure is drawn from the scene; describe anything else in words"));
            }
            Event::Start(Tag::Link { ref dest_url, .. })
                if !SCHEMES.iter().any(|scheme| dest_url.starts_with(scheme)) =>
            {
                return Err(text_fault(&format!("a link cannot lead to `{dest_url}`"))
                    .help(format!("a link starts with {}", SCHEMES.join(", "))));
            }
            Event::Start(Tag::List(_) | Tag::BlockQuote(_)) if depth > DEEPEST => {
                return Err(text_fault(&format!("lists and quotations nest deeper than {DEEPEST}")));
            }
            other => other,
        };
        Ok(Piece::Event(event))
    }
}

/// Mathematics that both `MathML` and LaTeX can print.
fn math(
    source: &str,
    tex: &str,
    range: &Range<usize>,
    display: MathDisplay,
    converter: &LatexToMathML,
) -> Result<Piece<'static>, Fault> {
    // In a list or a quotation, the text of the event lacks the markers of its further lines, and offsets with it.
    let offset = source.get(range.clone()).and_then(|whole| whole.find(tex)).map(|inside| range.start + inside);
    let at = |part: Range<usize>| {
        offset.map(|start| Span { start: start + part.start.min(tex.len()), end: start + part.end.min(tex.len()) })
    };
    if let Some(place) = unescaped_percent(tex) {
        let fault = Fault::new(Code::Text, "a bare % starts a comment in LaTeX, and would hide the rest");
        return Err(fault.help(r"write \%").at_maybe(at(place..place + 1)));
    }
    if let Some(place) = too_deep(tex) {
        let fault = Fault::new(Code::Text, format!("this mathematics nests deeper than {DEEPEST_MATH} levels"));
        return Err(fault.help("give an inner part a name of its own").at_maybe(at(place..place + 1)));
    }
    let result = converter.convert_with_local_state(tex, display).map_err(|error| {
        let message = error.error_message();
        Fault::new(Code::Text, format!("this mathematics cannot be set: {}", message.trim_end_matches('.')))
            .at_maybe(at(error.0.clone()))
    })?;
    Ok(Piece::Math { tex: tex.to_owned(), mathml: result.mathml, display: display == MathDisplay::Block })
}

fn unescaped_percent(tex: &str) -> Option<usize> {
    let mut escaped = false;
    tex.bytes().position(|byte| {
        let is_comment = byte == b'%' && !escaped;
        escaped = byte == b'\\' && !escaped;
        is_comment
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(source: &str) -> Vec<String> {
        match Authored::check("demo", source) {
            Ok(_) => Vec::new(),
            Err(faults) => faults.list.into_iter().map(|fault| fault.message).collect(),
        }
    }

    #[test]
    fn honest_markdown_passes() {
        let source =
            "A *cart* moves at $v = 2\\,\\text{m/s}$, 5\\% of\n\n$$p = m v$$\n\n- [see](https://example.org)\n";
        assert_eq!(messages(source), [] as [&str; 0]);
    }

    #[test]
    fn every_fault_is_told_at_once() {
        let source = "$\\input{x}$ ![a](b.png) [c](javascript:alert) $a % b$";
        let shown = Authored::check("demo", source).map_or_else(|faults| faults.to_string(), |_| String::new());
        insta::assert_snapshot!(shown);
    }

    #[test]
    fn what_would_leave_mathematics_in_latex_is_refused() {
        for tex in [
            r"\end{document}",
            r"\input{/etc/passwd}",
            r"\write18{ls}",
            r"\catcode`\%=12",
            r"a}b",
            r"{a",
            r"\def\x{y}",
            r"\text{^^5cinput}",
            r"a^^5cinput",
            r"#1",
            r"\csname end\endcsname",
            r"\) x \(",
            r"\] x \[",
        ] {
            let source = format!("${tex}$");
            let as_math = |piece: &Piece| matches!(piece, Piece::Math { .. });
            let passed = Authored::check("demo", &source).is_ok_and(|checked| checked.pieces.iter().any(as_math));
            assert!(!passed, "{tex}");
        }
    }

    #[test]
    fn nesting_is_bounded() {
        let deep = "> ".repeat(3000) + "x";
        assert!(!messages(&deep).is_empty());
        assert_eq!(messages("> > > > x"), [] as [&str; 0]);
    }
}
