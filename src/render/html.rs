//! HTML with `MathML` and SVG, which needs no script and no network.

use std::borrow::Cow;
use std::fmt::Write;

use pulldown_cmark::{Event, HeadingLevel, Tag, TagEnd};

use momentous_expr::Math;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::authored::Piece;
use super::equation;
use super::equation::NUMBER;
use super::equation::PAPER;
use super::equation::Row;
use super::equation::SCREEN;
use super::writer::Writer;

/// The classes of equations that a telephone shows in smaller type, since they could not be broken.
const SMALLER: [&str; 3] = ["tight", "tighter", "tightest"];

/// The writer of HTML.
pub(super) enum Html {
    /// For a screen that may be that of a telephone.
    Narrow,
    /// For a page that is as wide as paper.
    Wide,
}

impl Writer for Html {
    fn widest(&self, is_numbered: bool) -> f64 {
        match self {
            Self::Wide => PAPER,
            Self::Narrow if is_numbered => SCREEN - NUMBER,
            Self::Narrow => SCREEN,
        }
    }

    fn text<'a>(&self, text: &'a str) -> Cow<'a, str> {
        Cow::Owned(escape(text))
    }

    fn emphasis(&self, text: &str) -> String {
        format!("<em>{}</em>", escape(text))
    }

    fn strong(&self, text: &str) -> String {
        format!("<strong>{}</strong>", escape(text))
    }

    fn math(&self, math: &Math) -> String {
        equation::pieces(math, self.widest(false)).iter().map(|piece| piece.mathml(false)).collect()
    }

    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String {
        let class = match equation::smaller(rows, self.widest(number.is_some()), SMALLER) {
            Some(size) => format!("equation {size}"),
            None => "equation".to_owned(),
        };
        let mut out = format!("<div class=\"{class}\">{}", display(rows, ["<mtd>"; 2]));
        if let Some(number) = number {
            let _ = write!(out, "<span class=\"number\">({number})</span>");
        }
        out.push_str("</div>");
        out
    }

    fn figure(&self, drawing: &Drawing) -> String {
        figure::svg(drawing)
    }

    fn tex(&self, _tex: &str, mathml: &str) -> String {
        mathml.to_owned()
    }

    fn authored(&self, text: &Authored, level: usize) -> String {
        let events = text.pieces.iter().map(|piece| match piece {
            Piece::Event(event) => lower_heading(event.clone(), level),
            Piece::Math { tex, mathml, display: false } => Event::InlineHtml(self.tex(tex, mathml).into()),
            Piece::Math { mathml, display: true, .. } => {
                Event::InlineHtml(format!("<span class=\"equation\">{mathml}</span>").into())
            }
        });
        let mut out = String::new();
        pulldown_cmark::html::push_html(&mut out, events);
        out.trim_end().to_owned()
    }
}

/// Rows as one element of mathematics, aligned where there are several. The two cells of a row begin with these tags.
pub(super) fn display(rows: &[Row<'_>], cells: [&str; 2]) -> String {
    let [first, second] = cells;
    let mut out = String::from("<math display=\"block\">");
    if let [row] = rows {
        out.push_str(&Math::row_element(&equation::spread(row.whole())));
    } else {
        out.push_str("<mtable displaystyle=\"true\" class=\"aligned\">");
        for row in rows {
            let [left, right] = [row.left(), row.right()].map(|items| Math::row_element(&equation::spread(items)));
            let _ = write!(out, "<mtr>{first}{left}</mtd>{second}{right}</mtd></mtr>");
        }
        out.push_str("</mtable>");
    }
    out.push_str("</math>");
    out
}

/// The author's first level of headings is that level of the page.
pub(super) fn lower_heading(event: Event, level: usize) -> Event {
    let lower =
        |heading: HeadingLevel| HeadingLevel::try_from((heading as usize + level - 1).min(6)).unwrap_or(heading);
    match event {
        Event::Start(Tag::Heading { level, id, classes, attrs }) => {
            Event::Start(Tag::Heading { level: lower(level), id, classes, attrs })
        }
        Event::End(TagEnd::Heading(level)) => Event::End(TagEnd::Heading(lower(level))),
        other => other,
    }
}

/// Text that HTML prints as it is, in elements and in quoted attributes.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // The ends of lines are part of what stands in a field, or is shown as it was written.
            '\n' | '\t' => out.push(character),
            // Other control characters are not allowed in HTML, not even by number.
            character if character.is_control() => out.push(' '),
            character => out.push(character),
        }
    }
    out
}

/// A message for a page: what stands between backticks, such as something that was typed, is set as code.
pub(super) fn said(text: &str) -> String {
    let pieces: Vec<&str> = text.split('`').collect();
    if pieces.len().is_multiple_of(2) {
        // One of them is no quotation mark.
        return escape(text);
    }
    let set = |(place, piece): (usize, &&str)| match place % 2 {
        0 => escape(piece),
        _ => format!("<code>{}</code>", escape(piece)),
    };
    pieces.iter().enumerate().map(set).collect()
}

#[cfg(test)]
mod tests {
    use super::said;

    #[test]
    fn what_stands_between_backticks_is_set_as_code() {
        assert_eq!(said("the unit `m/<s>` is known"), "the unit <code>m/&lt;s&gt;</code> is known");
        assert_eq!(said("a ` alone stays, <b>"), "a ` alone stays, &lt;b&gt;");
        assert_eq!(said(""), "");
    }
}
