//! A drawing as SVG: within a page, its ink following the page's text colour; or as a file, on a card of its own.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::expr::Math;

use super::extent::{Extent, Measure};
use super::geometry::{arc_points, arrow_head, coordinate, corners};
use super::style::{Style, TYPE_SIZE, style};
use super::typeset::{Face, runs};
use super::{Drawing, Point, Role, Shape};

/// Serif faces that readers' machines have; no font is loaded.
const FONTS: &str = "'STIX Two Text','Times New Roman',Times,'Liberation Serif',serif";
const DASHES: &str = "5 3";
/// How much further a card reaches than its drawing.
const CARD_MARGIN: f64 = 8.0;
/// Paper and ink of a file, in light and in dark.
const CARD_STYLE: &str = "\
.momentous-figure{color:#1f2328;color-scheme:light dark}
.momentous-figure .card{fill:#fdfdfb}
@media (prefers-color-scheme:dark){.momentous-figure{color:#e2e5e9}.momentous-figure .card{fill:#16191d}}
";

/// The drawing as an SVG element, with title and description for screen readers.
///
/// ```
/// use momentous::figure::{Drawing, Point, svg};
///
/// let (low, high) = (Point { x: 0.0, y: 0.0 }, Point { x: 40.0, y: 20.0 });
/// let words = |text: &str| text.to_owned();
/// let (title, description, caption) = (words("A & B"), words("Two bodies."), words(""));
/// let text = svg(&Drawing { title, description, caption, low, high, shapes: Vec::new() });
/// assert!(text.starts_with("<svg ") && text.contains("<title>A &amp; B</title>"));
/// ```
#[must_use]
pub fn svg(drawing: &Drawing) -> String {
    element(drawing, "", "")
}

/// The drawing as an SVG file. A picture cannot know the colour of the page that shows it (a page may be dark for a reader
/// whose screen is light), so it stands on a card of its own, which is light or dark as the reader's screen is.
///
/// ```
/// use momentous::figure::{Drawing, Point, svg_file};
///
/// let (low, high) = (Point { x: 0.0, y: 0.0 }, Point { x: 40.0, y: 20.0 });
/// let words = String::new;
/// let text = svg_file(&Drawing { title: words(), description: words(), caption: words(), low, high, shapes: Vec::new() });
/// assert!(text.contains("prefers-color-scheme:dark") && text.contains("<rect class=\"card\""));
/// ```
#[must_use]
pub fn svg_file(drawing: &Drawing) -> String {
    let frame = Extent { low: drawing.low, high: drawing.high }.grown(CARD_MARGIN);
    let drawing = Drawing { low: frame.low, high: frame.high, ..drawing.clone() };
    element(&drawing, CARD_STYLE, "<rect class=\"card\" width=\"100%\" height=\"100%\" rx=\"6\"/>\n")
}

fn element(drawing: &Drawing, style: &str, ground: &str) -> String {
    let size = drawing.high - drawing.low;
    let (width, height) = (coordinate(size.x), coordinate(size.y));
    let (title, description) = (escape(&drawing.title), escape(&drawing.description));
    let mut page = Page { out: String::new(), low: drawing.low, high: drawing.high };
    page.put(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" class=\"momentous-figure\" \
         width=\"{width}pt\" height=\"{height}pt\" viewBox=\"0 0 {width} {height}\">\n\
         <title>{title}</title>\n<desc>{description}</desc>\n<style>\n{}{style}</style>\n{ground}",
        style_sheet(&drawing.roles())
    ));
    for shape in &drawing.shapes {
        page.shape(shape);
    }
    page.out.push_str("</svg>\n");
    page.out
}

/// The rules of the roles that are drawn. They are confined to figures, because a page's style sheets are shared by all that is
/// on it.
fn style_sheet(roles: &BTreeSet<Role>) -> String {
    let scope = ".momentous-figure";
    let mut sheet = format!(
        "{scope}{{max-width:100%;height:auto}}\n\
         {scope} *{{stroke-linejoin:round;stroke-linecap:round}}\n\
         {scope} text{{font:{TYPE_SIZE}px {FONTS};text-anchor:middle}}\n\
         {scope} .i{{font-style:italic}}\n{scope} .b{{font-weight:bold}}\n\
         {scope} .dashed{{stroke-dasharray:{DASHES}}}\n"
    );
    for style in roles.iter().copied().map(style) {
        let (class, width, fill) = (style.class, style.width, style.fill);
        let rule = format!(
            "{scope} .{class}{{{};stroke-width:{width};fill:none}}\n\
             {scope} .{class}.head,{scope} text.{class}{{{};stroke:none}}\n",
            paint("stroke", &style),
            paint("fill", &style),
        );
        sheet.push_str(&rule);
        if fill > 0.0 {
            let filled = format!("{scope} .{class}.filled{{{};fill-opacity:{fill}}}\n", paint("fill", &style));
            sheet.push_str(&filled);
        }
    }
    sheet.push_str(".momentous-figure .area{stroke:none}\n");
    sheet
}

/// A colour for the light and the dark scheme of the page; programs that do not know of schemes keep the first.
fn paint(property: &str, style: &Style) -> String {
    let (light, dark) = (style.colour, style.dark);
    if light == dark {
        format!("{property}:{light}")
    } else {
        format!("{property}:{light};{property}:light-dark({light},{dark})")
    }
}

struct Page {
    out: String,
    low: Point,
    high: Point,
}

impl Page {
    fn put(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.out.write_fmt(text);
    }

    /// SVG counts downwards from the upper left corner.
    fn pair(&self, point: Point) -> (String, String) {
        (coordinate(point.x - self.low.x), coordinate(self.high.y - point.y))
    }

    fn list(&self, points: &[Point]) -> String {
        let pairs = points.iter().map(|point| {
            let (x, y) = self.pair(*point);
            format!("{x},{y}")
        });
        pairs.collect::<Vec<_>>().join(" ")
    }

    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { points, role, dashed } => self.line(points, *role, *dashed),
            Shape::Arrow { from, to, role } => {
                let (_, base) = arrow_head(*from, *to);
                self.line(&[*from, base], *role, false);
                self.head(*from, *to, *role);
            }
            Shape::Circle { centre, radius, role } => {
                let ((x, y), radius, class) = (self.pair(*centre), coordinate(*radius), closed_class(*role));
                self.put(format_args!("<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>\n"));
            }
            Shape::Rectangle { centre, size, angle, role } => {
                let (points, class) = (self.list(&corners(*centre, *size, *angle)), closed_class(*role));
                self.put(format_args!("<polygon class=\"{class}\" points=\"{points}\"/>\n"));
            }
            Shape::Arc { centre, radius, from, to, arrow, role } => {
                let points = arc_points(*centre, *radius, *from, *to);
                // A line to the very tip would blunt it.
                let line = if *arrow { points.get(..points.len().saturating_sub(2)) } else { None };
                self.line(line.unwrap_or(&points), *role, false);
                if *arrow && let [.., before, last] = points.as_slice() {
                    // The head follows the arc's tangent at its end.
                    let tangent = *last - *before;
                    let back = *last - tangent * (12.0 / tangent.length().max(1e-9));
                    self.head(back, *last, *role);
                }
            }
            Shape::Area { points, role } => {
                let (points, class) = (self.list(points), style(*role).class);
                self.put(format_args!("<polygon class=\"{class} filled area\" points=\"{points}\"/>\n"));
            }
            Shape::Label { at, text, role } => self.label(*at, text, *role),
        }
    }

    fn line(&mut self, points: &[Point], role: Role, dashed: bool) {
        let (points, class) = (self.list(points), style(role).class);
        let pattern = if dashed { " dashed" } else { "" };
        self.put(format_args!("<polyline class=\"{class}{pattern}\" points=\"{points}\"/>\n"));
    }

    fn head(&mut self, from: Point, to: Point, role: Role) {
        let (head, _) = arrow_head(from, to);
        let (points, class) = (self.list(&head), style(role).class);
        self.put(format_args!("<polygon class=\"{class} head\" points=\"{points}\"/>\n"));
    }

    fn label(&mut self, at: Point, text: &Math, role: Role) {
        let runs = runs(text);
        let baseline = Point::new(at.x, at.y - Measure::of_runs(&runs).drop());
        let ((x, y), class) = (self.pair(baseline), style(role).class);
        self.put(format_args!("<text class=\"{class}\" x=\"{x}\" y=\"{y}\">"));
        let mut rise = 0.0;
        for run in runs.iter().filter(|run| !run.text.is_empty()) {
            let face = match run.face {
                Face::Upright => "",
                Face::Italic => " class=\"i\"",
                Face::Bold => " class=\"b\"",
            };
            let shift = attribute("dy", (rise - run.rise) * TYPE_SIZE, 0.0);
            let size = attribute("font-size", run.size * TYPE_SIZE, TYPE_SIZE);
            let attributes = [face, &shift, &size].concat();
            rise = run.rise;
            let text = escape(&run.text);
            if attributes.is_empty() {
                self.out.push_str(&text);
            } else {
                self.put(format_args!("<tspan{attributes}>{text}</tspan>"));
            }
        }
        self.out.push_str("</text>\n");
    }
}

/// A number as an attribute, left out where it has the value that holds without it.
fn attribute(name: &str, value: f64, usual: f64) -> String {
    let (value, usual) = (coordinate(value), coordinate(usual));
    if value == usual { String::new() } else { format!(" {name}=\"{value}\"") }
}

fn closed_class(role: Role) -> String {
    let style = style(role);
    if style.fill > 0.0 { format!("{} filled", style.class) } else { style.class.to_owned() }
}

/// Text for XML: markup escaped, characters that XML forbids left out.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(' '),
            character if character.is_control() || matches!(character, '\u{fffe}' | '\u{ffff}') => {}
            character => out.push(character),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_roles_that_are_drawn_have_rules() {
        let shapes = vec![Shape::Line { points: vec![Point::default()], role: Role::Axis, dashed: false }];
        let (title, description, caption) = (String::new(), String::new(), String::new());
        let (low, high) = (Point::default(), Point::default());
        let text = svg(&Drawing { title, description, caption, low, high, shapes });
        assert!(text.contains(".axis{") && !text.contains(".momentum{"), "{text}");
    }

    #[test]
    fn markup_and_control_characters_do_not_reach_the_page() {
        assert_eq!(escape("a<b & \"c\"\u{1}\nd"), "a&lt;b &amp; &quot;c&quot; d");
    }
}
