//! Markdown with `$`-mathematics, as GitHub and pandoc read it.

use std::borrow::Cow;

use momentous_expr::Math;
use momentous_figure as figure;
use momentous_figure::Drawing;

use super::authored::Authored;
use super::equation::Row;
use super::latex_text;
use super::writer::Writer;

/// Room for what more is written than mathematics has signs.
const ROOM: usize = 8;

/// The writer of Markdown.
pub(super) struct Markdown;

impl Writer for Markdown {
    fn text<'a>(&self, text: &'a str) -> Cow<'a, str> {
        escape(text)
    }

    fn emphasis(&self, text: &str) -> String {
        wrapped(text, "*")
    }

    fn strong(&self, text: &str) -> String {
        wrapped(text, "**")
    }

    fn math(&self, math: &Math) -> String {
        let mut tex = without_dollars(math.latex());
        // A bar would end a cell where the text stands in a table.
        if tex.contains('|') {
            tex = tex.replace('|', r"\vert ");
        }
        tex.insert(0, '$');
        tex.push('$');
        tex
    }

    fn equation(&self, rows: &[Row<'_>], number: Option<u32>) -> String {
        ["$$\n", &without_dollars(latex_text::equation(rows, number)), "\n$$"].concat()
    }

    fn figure(&self, drawing: &Drawing) -> String {
        // A blank line would end a block of raw HTML; an SVG has none.
        let mut svg = figure::svg(drawing);
        svg.truncate(svg.trim_end().len());
        svg
    }

    fn tex(&self, tex: &str, _mathml: &str) -> String {
        format!("${tex}$")
    }

    fn authored(&self, text: &Authored, _level: usize) -> String {
        let mut out = String::with_capacity(text.source.len());
        let mut done = 0;
        for range in &text.raw_html {
            out.push_str(text.source.get(done..range.start).unwrap_or_default());
            out.push_str(&text.source.get(range.clone()).unwrap_or_default().replace('<', "&lt;"));
            done = range.end;
        }
        out.push_str(text.source.get(done..).unwrap_or_default());
        out.trim_end().to_owned()
    }
}

fn wrapped(text: &str, mark: &str) -> String {
    match text.trim() {
        "" => String::new(),
        // Beside a blank a mark is none, so that blanks stand outside.
        inner => text.replacen(inner, &format!("{mark}{}{mark}", escape(inner)), 1),
    }
}

/// Text that Markdown prints as it is: no emphasis, code, link, HTML, mathematics, heading or list comes of it.
pub(super) fn escape(text: &str) -> Cow<'_, str> {
    let mut out = String::new();
    let start = text.len() - text.trim_start().len();
    let mut written = 0;
    for place in text.bytes().enumerate().filter(|(_, byte)| SUSPECT[usize::from(*byte)]).map(|(place, _)| place) {
        let Some(character) = text.get(place..).and_then(|rest| rest.chars().next()) else { continue };
        let behind = || text[place + character.len_utf8()..].chars().next();
        // What begins a list stands before a space: `3. May`, but not `3.5 m` or `-3`.
        let apart = || behind().is_none_or(char::is_whitespace);
        let mark = match character {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '&' | '$' | '|' | '~' => "\\",
            '#' | '=' if place == start => "\\",
            '+' | '-' if place == start && (apart() || behind() == Some(character)) => "\\",
            '.' | ')' if apart() && is_list_number(&text[..place]) => "\\",
            control if control.is_control() => " ",
            _ => continue,
        };
        out.push_str(&text[written..place]);
        out.push_str(mark);
        written = if mark == " " { place + character.len_utf8() } else { place };
    }
    if out.is_empty() && written == 0 {
        return Cow::Borrowed(text);
    }
    out.push_str(&text[written..]);
    Cow::Owned(out)
}

/// Whether something that [`escape`] changes may begin with the byte; most bytes are letters, and are passed over at once.
static SUSPECT: [bool; 256] = suspects();

const fn suspects() -> [bool; 256] {
    const BEFORE_CONTROL: u8 = 0xc2; // the first byte of U+0080 to U+00BF
    let mut suspects = [false; 256];
    let mut byte = 0;
    while byte < BEFORE_CONTROL {
        let marks = matches!(byte, b'\\' | b'`' | b'*' | b'_' | b'[' | b']' | b'<' | b'>' | b'&' | b'$' | b'|' | b'~');
        let starts = matches!(byte, b'#' | b'=' | b'+' | b'-' | b'.' | b')');
        suspects[byte as usize] = marks || starts || byte.is_ascii_control();
        byte += 1;
    }
    suspects[BEFORE_CONTROL as usize] = true;
    suspects
}

/// The same mathematics without mathematics inside text: `\text{m/s$^2$}` is `\text{m/s}^2`, since a dollar inside
/// would end the whole.
fn without_dollars(tex: String) -> String {
    const OPEN: &str = r"\text{";
    if !tex.contains('$') {
        return tex;
    }
    let mut out = String::with_capacity(tex.len() + ROOM);
    let mut inside = false;
    let mut rest = tex.as_str();
    while let Some(place) = rest.find(['\\', '$']) {
        let (plain, marked) = rest.split_at(place);
        out.push_str(plain);
        let mut signs = marked.chars();
        let mark = signs.next();
        if mark == Some('\\') {
            out.push('\\');
            out.extend(signs.next());
            rest = signs.as_str();
            continue;
        }
        rest = signs.as_str();
        if inside {
            match rest.strip_prefix('}') {
                Some(behind) => rest = behind,
                None => out.push_str(OPEN),
            }
        } else {
            match out.strip_suffix(OPEN).map(str::len) {
                Some(length) => {
                    out.truncate(length);
                    out.push_str("{}");
                }
                None => out.push('}'),
            }
        }
        inside = !inside;
    }
    out.push_str(rest);
    out
}

/// Whether what stands before is a number only, which a full stop would make the start of a list.
fn is_list_number(before: &str) -> bool {
    let written = before.trim_start_matches(|character: char| character.is_whitespace() || character.is_control());
    !written.is_empty() && written.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanks_stand_outside_strong_text() {
        assert_eq!([" of it", "it ", " "].map(|text| wrapped(text, "**")), [" **of it**", "**it** ", ""]);
    }

    #[test]
    fn no_dollar_is_left_inside_mathematics() {
        assert_eq!(without_dollars(r"9.81\ \text{m/s$^{2}$}".into()), r"9.81\ \text{m/s}^{2}");
        assert_eq!(without_dollars(r"30\text{$^\circ$ left}".into()), r"30{}^\circ\text{ left}");
        assert_eq!(without_dollars(r"\text{5 \$}".into()), r"\text{5 \$}");
    }

    #[test]
    fn text_stays_text() {
        let hostile = "<b>*x* _y_ `z` [l](u) $m$ a|b ~c~ &amp;";
        let escaped = escape(hostile);
        let html = {
            let mut html = String::new();
            let options = pulldown_cmark::Options::all();
            pulldown_cmark::html::push_html(&mut html, pulldown_cmark::Parser::new_ext(&escaped, options));
            html
        };
        assert_eq!(html, "<p>&lt;b&gt;*x* _y_ `z` [l](u) $m$ a|b ~c~ &amp;amp;</p>\n");
        assert_eq!(escape("# 1"), "\\# 1");
        assert_eq!(escape("12. May"), "12\\. May");
        assert_eq!((escape("3.5 m").as_ref(), escape("-3 m").as_ref()), ("3.5 m", "-3 m"));
        assert_eq!(escape("é\u{7f}−\u{85}\u{a0}ü"), "é − \u{a0}ü");
        assert_eq!((escape("- 3").as_ref(), escape("---").as_ref()), ("\\- 3", "\\---"));
    }
}
