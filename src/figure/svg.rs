//! A drawing as SVG: within a page, its ink following the page's text colour; or as a file, on a card of its own.

use std::sync::LazyLock;

use momentous_expr::Math;

use super::extent::{Extent, Measure};
use super::geometry::{arc_points, arrow_head, coordinate, corners, hundredths, put_coordinate};
use super::style::{Style, TYPE_SIZE, style};
use super::typeset::{Face, Run, runs};
use super::{Drawing, Point, Role, Shape};

/// Serif faces that readers' machines have; no font is loaded.
const FONTS: &str = "'STIX Two Text','Times New Roman',Times,'Liberation Serif',serif";
const DASHES: &str = "5 3";
/// To what the rules of figures are confined.
const SCOPE: &str = ".momentous-figure";
/// Areas have no edge. It comes last, for it overrules the roles.
const AREA: &str = ".momentous-figure .area{stroke:none}\n";
/// The room that a figure takes, in bytes, so that its text is not moved about as it grows.
const USUAL_SIZE: usize = 8192;
/// How much further a card reaches than its drawing.
const CARD_MARGIN: f64 = 8.0;
/// Paper and ink of a file, in light and in dark.
const CARD_STYLE: &str = "\
.momentous-figure{color:#1f2328;color-scheme:light dark}
.momentous-figure .card{fill:#fdfdfb}
@media (prefers-color-scheme:dark){.momentous-figure{color:#e2e5e9}.momentous-figure .card{fill:#16191d}}
";

/// The drawing as an SVG element, with title and description for screen readers. No line of it is blank.
///
/// ```
/// use momentous_figure::{Drawing, Point, svg};
///
/// let (low, high) = (Point { x: 0.0, y: 0.0 }, Point { x: 40.0, y: 20.0 });
/// let words = |text: &str| text.to_owned();
/// let (title, description, caption) = (words("A & B"), words("Two bodies."), words(""));
/// let text = svg(&Drawing { title, description, caption, low, high, shapes: Vec::new() });
/// assert!(text.starts_with("<svg ") && text.contains("<title>A &amp; B</title>"));
/// ```
#[must_use]
pub fn svg(drawing: &Drawing) -> String {
    element(drawing, Some((&SHEET, "")), "")
}

/// The drawing as an SVG element for a page whose own style sheet holds the rules of all figures ([`style_sheet`]).
#[must_use]
pub fn svg_unstyled(drawing: &Drawing) -> String {
    element(drawing, None, "")
}

/// The drawing as an SVG element for paper: for programs that know one colour of ink.
#[must_use]
pub fn svg_paper(drawing: &Drawing) -> String {
    element(drawing, Some((&PAPER_SHEET, "")), "")
}

/// The rules of all figures, for the style sheet of a page.
///
/// ```
/// assert!(momentous_figure::style_sheet().contains(".momentous-figure text"));
/// ```
#[must_use]
pub fn style_sheet() -> String {
    format!("{}{}{AREA}", SHEET.general, SHEET.roles.concat())
}

/// The drawing as an SVG file. A picture cannot know the colour of the page that shows it (a page may be dark for a reader
/// whose screen is light), so it stands on a card of its own, which is light or dark as the reader's screen is.
///
/// ```
/// use momentous_figure::{Drawing, Point, svg_file};
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
    element(&drawing, Some((&SHEET, CARD_STYLE)), "<rect class=\"card\" width=\"100%\" height=\"100%\" rx=\"6\"/>\n")
}

fn element(drawing: &Drawing, style: Option<(&Sheet, &str)>, ground: &str) -> String {
    let size = drawing.high - drawing.low;
    let mut page = Page { out: String::with_capacity(USUAL_SIZE), low: drawing.low, high: drawing.high };
    page.put(["<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" class=\"momentous-figure\" width=\""]);
    page.number(size.x);
    page.put(["pt\" height=\""]);
    page.number(size.y);
    page.put(["pt\" viewBox=\"0 0 "]);
    page.number(size.x);
    page.put([" "]);
    page.number(size.y);
    page.put(["\">\n<title>"]);
    page.text(&drawing.title);
    page.put(["</title>\n<desc>"]);
    page.text(&drawing.description);
    page.put(["</desc>\n"]);
    if let Some((sheet, style)) = style {
        page.put(["<style>\n"]);
        page.style_sheet(sheet, drawing);
        page.put([style, "</style>\n"]);
    }
    page.put([ground]);
    for shape in &drawing.shapes {
        page.shape(shape);
    }
    page.put(["</svg>\n"]);
    page.out
}

/// The rules that figures may have, the same in all of them.
struct Sheet {
    general: String,
    /// In the order of the roles.
    roles: [String; Role::ALL.len()],
}

/// How a property is set to the colour of a style.
type Paint = fn(&str, &Style) -> String;

static SHEET: LazyLock<Sheet> = LazyLock::new(|| sheet(paint));
static PAPER_SHEET: LazyLock<Sheet> = LazyLock::new(|| sheet(paint_on_paper));

fn sheet(paint: Paint) -> Sheet {
    Sheet { general: general_rules(), roles: Role::ALL.map(|role| rules(role, paint)) }
}

fn general_rules() -> String {
    let size = coordinate(TYPE_SIZE);
    format!(
        "{SCOPE}{{max-width:100%;height:auto}}\n{SCOPE} *{{stroke-linejoin:round;stroke-linecap:round}}\n\
         {SCOPE} text{{font:{size}px {FONTS};text-anchor:middle}}\n\
         {SCOPE} .i{{font-style:italic}}\n{SCOPE} .b{{font-weight:bold}}\n{SCOPE} .dashed{{stroke-dasharray:{DASHES}}}\n"
    )
}

fn rules(role: Role, paint: Paint) -> String {
    let style = style(role);
    let (class, width) = (style.class, coordinate(style.width));
    let [stroke, fill] = ["stroke", "fill"].map(|property| paint(property, &style));
    let filled = if style.fill > 0.0 {
        format!("{SCOPE} .{class}.filled{{{fill};fill-opacity:{}}}\n", coordinate(style.fill))
    } else {
        String::new()
    };
    format!(
        "{SCOPE} .{class}{{{stroke};stroke-width:{width};fill:none}}\n\
         {SCOPE} .{class}.head,{SCOPE} text.{class}{{{fill};stroke:none}}\n{filled}"
    )
}

/// A colour for the light and the dark scheme of the page; programs that do not know of schemes keep the first.
fn paint(property: &str, style: &Style) -> String {
    let (light, dark) = (style.colour, style.dark);
    let scheme = if light == dark { String::new() } else { format!(";{property}:light-dark({light},{dark})") };
    format!("{property}:{light}{scheme}")
}

fn paint_on_paper(property: &str, style: &Style) -> String {
    format!("{property}:{}", style.colour)
}

struct Page {
    out: String,
    low: Point,
    high: Point,
}

impl Page {
    fn put<const N: usize>(&mut self, pieces: [&str; N]) {
        for piece in pieces {
            self.out.push_str(piece);
        }
    }

    fn number(&mut self, value: f64) {
        put_coordinate(&mut self.out, value);
    }

    /// Text for XML: markup escaped, characters that XML forbids left out.
    fn text(&mut self, text: &str) {
        let mut written = 0;
        for (place, character) in text.char_indices() {
            let instead = match character {
                '&' => "&amp;",
                '<' => "&lt;",
                '>' => "&gt;",
                '"' => "&quot;",
                '\t' | '\n' | '\r' => " ",
                '\u{fffe}' | '\u{ffff}' => "",
                control if control.is_control() => "",
                _ => continue,
            };
            self.put([&text[written..place], instead]);
            written = place + character.len_utf8();
        }
        self.put([&text[written..]]);
    }

    /// The rules of the roles that are drawn. They are confined to figures, because a page's style sheets are shared by all
    /// that is on it.
    fn style_sheet(&mut self, sheet: &Sheet, drawing: &Drawing) {
        self.put([&sheet.general]);
        for (role, rules) in Role::ALL.iter().zip(&sheet.roles) {
            if drawing.has(*role) {
                self.put([rules]);
            }
        }
        self.put([AREA]);
    }

    /// SVG counts downwards from the upper left corner.
    fn pair(&mut self, point: Point, between: &str) {
        self.number(point.x - self.low.x);
        self.put([between]);
        self.number(self.high.y - point.y);
    }

    fn points(&mut self, points: &[Point]) {
        self.put(["\" points=\""]);
        for (index, point) in points.iter().enumerate() {
            self.put([if index > 0 { " " } else { "" }]);
            self.pair(*point, ",");
        }
        self.put(["\"/>\n"]);
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
                self.put(["<circle class=\""]);
                self.closed_class(*role);
                self.put(["\" cx=\""]);
                self.pair(*centre, "\" cy=\"");
                self.put(["\" r=\""]);
                self.number(*radius);
                self.put(["\"/>\n"]);
            }
            Shape::Rectangle { centre, size, angle, role } => {
                self.put(["<polygon class=\""]);
                self.closed_class(*role);
                self.points(&corners(*centre, *size, *angle));
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
                self.put(["<polygon class=\"", style(*role).class, " filled area"]);
                self.points(points);
            }
            Shape::Label { at, text, role } => self.label(*at, text, *role),
        }
    }

    fn closed_class(&mut self, role: Role) {
        let style = style(role);
        self.put([style.class, if style.fill > 0.0 { " filled" } else { "" }]);
    }

    fn line(&mut self, points: &[Point], role: Role, dashed: bool) {
        self.put(["<polyline class=\"", style(role).class, if dashed { " dashed" } else { "" }]);
        self.points(points);
    }

    fn head(&mut self, from: Point, to: Point, role: Role) {
        let (head, _) = arrow_head(from, to);
        self.put(["<polygon class=\"", style(role).class, " head"]);
        self.points(&head);
    }

    fn label(&mut self, at: Point, text: &Math, role: Role) {
        let baseline = Point::new(at.x, at.y - Measure::of(text).drop());
        self.put(["<text class=\"", style(role).class, "\" x=\""]);
        self.pair(baseline, "\" y=\"");
        self.put(["\">"]);
        self.markup(text);
        self.put(["</text>\n"]);
    }

    fn markup(&mut self, text: &Math) {
        let mut rise = 0.0;
        for Run { text, look } in runs(text).iter().filter(|run| !run.text.is_empty()) {
            let start = self.out.len();
            self.put(["<tspan"]);
            let plain = self.out.len();
            self.put([match look.face {
                Face::Upright => "",
                Face::Italic => " class=\"i\"",
                Face::Bold => " class=\"b\"",
            }]);
            self.attribute("dy", (rise - look.rise) * TYPE_SIZE, 0.0);
            self.attribute("font-size", look.size * TYPE_SIZE, TYPE_SIZE);
            rise = look.rise;
            if self.out.len() == plain {
                self.out.truncate(start);
                self.text(text);
            } else {
                self.put([">"]);
                self.text(text);
                self.put(["</tspan>"]);
            }
        }
    }

    /// A number as an attribute, left out where it has the value that holds without it.
    fn attribute(&mut self, name: &str, value: f64, usual: f64) {
        if hundredths(value) != hundredths(usual) {
            self.put([" ", name, "=\""]);
            self.number(value);
            self.put(["\""]);
        }
    }
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
    fn no_line_is_blank() {
        let [title, description, caption] = [" ", "\n\n", ""].map(str::to_owned);
        let text = Math::Text("\n \n".to_owned());
        let shapes = vec![Shape::Label { at: Point::default(), text, role: Role::Body }];
        let (low, high) = (Point::default(), Point::default());
        let text = svg(&Drawing { title, description, caption, low, high, shapes });
        assert!(text.lines().all(|line| !line.trim().is_empty()), "{text}");
    }

    #[test]
    fn markup_and_control_characters_do_not_reach_the_page() {
        let mut page = Page { out: String::new(), low: Point::default(), high: Point::default() };
        page.text("a<b & \"c\"\u{1}\nd");
        assert_eq!(page.out, "a&lt;b &amp; &quot;c&quot; d");
    }
}
