//! One panel: a title, two axes, curves and a legend.

use std::fmt::Write;

use super::axis::Axis;
use super::escaped;
use super::marks::{COLOURS, Mark};

/// The width of a panel, in pixels.
pub(super) const WIDTH: f64 = 820.0;

/// The place of the axes: from the left, and their distance from the top and from the bottom.
const LEFT: f64 = 76.0;
const RIGHT: f64 = 600.0;
const HEAD: f64 = 46.0;
const FOOT: f64 = 54.0;

/// How much lower the axes begin where failures stand above them.
const FAILURES: f64 = 32.0;

/// The room of a line of the legend, with and without a note.
const LINE: f64 = 20.0;
const NOTE: f64 = 16.0;

/// A panel.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// The title above it.
    pub title: String,
    /// Its height in pixels.
    pub height: f64,
    /// Along the bottom.
    pub across: Axis,
    /// Along the side.
    pub up: Axis,
    /// The curves, in the order of the legend.
    pub curves: Vec<Curve>,
    /// Whether there is a row for failures above the axes.
    pub failures: bool,
}

/// A line through points.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    /// Its name.
    pub name: String,
    /// A line beneath its name.
    pub note: Option<String>,
    /// Which of the colours it has.
    pub colour: usize,
    /// The shape of its points; none for a plain line.
    pub mark: Option<Mark>,
    /// Whether its points are joined.
    pub joined: bool,
    /// Whether its line is dashed.
    pub dashed: bool,
    /// Its points, in order.
    pub spots: Vec<Spot>,
}

/// A point of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spot {
    /// Along the bottom.
    pub across: f64,
    /// Along the side; none where there is no value.
    pub up: Option<f64>,
    /// From where to where a thin line shows its spread.
    pub spread: Option<[f64; 2]>,
    /// Whether a cross stands above it.
    pub failed: bool,
}

impl Curve {
    /// A plain line.
    pub(crate) fn line(name: &str, colour: usize, points: impl Iterator<Item = (f64, f64)>) -> Self {
        let spots = points.map(|(across, up)| Spot { across, up: Some(up), spread: None, failed: false }).collect();
        Self { name: name.to_owned(), note: None, colour, mark: None, joined: true, dashed: false, spots }
    }

    /// The same line, dashed.
    pub(crate) fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }
}

impl Panel {
    fn top(&self) -> f64 {
        HEAD + if self.failures { FAILURES } else { 0.0 }
    }

    fn bottom(&self) -> f64 {
        self.height - FOOT
    }

    fn x(&self, value: f64) -> f64 {
        LEFT + (RIGHT - LEFT) * self.across.part(value)
    }

    fn y(&self, value: f64) -> f64 {
        self.bottom() - (self.bottom() - self.top()) * self.up.part(value)
    }

    /// The height of the crosses of failures.
    fn failed(&self) -> f64 {
        self.top() - 18.0
    }

    /// The panel with its upper left corner at the origin.
    pub(super) fn svg(&self) -> String {
        let mut out = String::new();
        let _ = writeln!(out, "<text class=\"name\" x=\"{LEFT}\" y=\"30\">{}</text>", escaped(&self.title));
        self.axes(&mut out);
        let mut line = self.top() + 6.0;
        for curve in &self.curves {
            let _ = writeln!(out, "<g class=\"m m{}\">", curve.colour % COLOURS.len());
            self.curve(&mut out, curve);
            line = legend(&mut out, line, curve);
            out.push_str("</g>\n");
        }
        out
    }

    fn axes(&self, out: &mut String) {
        let (top, bottom) = (self.top(), self.bottom());
        let (width, height) = (RIGHT - LEFT, bottom - top);
        for (value, text) in &self.up.ticks {
            let y = self.y(*value);
            if !text.is_empty() {
                let x = LEFT - 8.0;
                let _ = writeln!(out, "<text x=\"{x}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>", y + 4.0);
            }
            let _ = writeln!(out, "<path class=\"grid\" d=\"M{LEFT} {y:.1}H{RIGHT}\"/>");
        }
        for (value, text) in &self.across.ticks {
            let (x, y) = (self.x(*value), bottom + 18.0);
            let _ = writeln!(out, "<path class=\"grid\" d=\"M{x:.1} {top}V{bottom}\"/>");
            let _ = writeln!(out, "<text class=\"small\" x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">{text}</text>");
        }
        let (middle, turn) = (f64::midpoint(LEFT, RIGHT), f64::midpoint(top, bottom));
        let (across, up) = (&self.across.label, &self.up.label);
        let _ = writeln!(
            out,
            "<rect class=\"axis\" x=\"{LEFT}\" y=\"{top}\" width=\"{width}\" height=\"{height}\"/>\n\
             <text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{across}</text>\n\
             <text transform=\"translate(18 {turn}) rotate(-90)\" text-anchor=\"middle\">{up}</text>",
            bottom + 40.0
        );
        if self.failures {
            let (x, y) = (LEFT - 8.0, self.failed() + 4.0);
            let _ = writeln!(out, "<text class=\"small\" x=\"{x}\" y=\"{y}\" text-anchor=\"end\">failures</text>");
        }
    }

    /// The line, its points, the thin lines of their spread, and the crosses of the failures.
    fn curve(&self, out: &mut String, curve: &Curve) {
        let mut way = String::new();
        for spot in &curve.spots {
            let x = self.x(spot.across);
            if spot.failed {
                let _ = writeln!(out, "<path d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\"/>", x - 4.0, self.failed() - 4.0);
            }
            let Some(up) = spot.up.filter(|up| up.is_finite()) else { continue };
            let y = self.y(up);
            let _ = write!(way, "{}{x:.1} {y:.1}", if way.is_empty() { 'M' } else { 'L' });
            if let Some([low, high]) = spot.spread.map(|ends| ends.map(|end| self.y(end))) {
                let _ = writeln!(out, "<path class=\"spread\" d=\"M{x:.1} {low:.1}V{high:.1}\"/>");
            }
            draw(out, curve.mark, x, y);
        }
        if curve.joined && way.contains('L') {
            let _ = writeln!(out, "<path{} d=\"{way}\"/>", dashes(curve));
        }
    }
}

fn dashes(curve: &Curve) -> &'static str {
    if curve.dashed { " class=\"dashed\"" } else { "" }
}

fn draw(out: &mut String, mark: Option<Mark>, x: f64, y: f64) {
    if let Some(mark) = mark {
        let shape = mark.path();
        let _ = writeln!(out, "<path class=\"f\" style=\"stroke-width:.5\" d=\"M{x:.1} {y:.1}{shape}\"/>");
    }
}

/// A curve's mark and name with its note beneath; gives where the next line of the legend stands.
fn legend(out: &mut String, y: f64, curve: &Curve) -> f64 {
    let x = RIGHT + 28.0;
    if curve.joined {
        let _ = writeln!(out, "<path{} d=\"M{:.1} {y}h24\"/>", dashes(curve), x - 12.0);
    }
    draw(out, curve.mark, x, y);
    let mut text = |below: f64, class: &str, words: &str| {
        let (x, y, words) = (x + 20.0, y + below, escaped(words));
        let _ = writeln!(out, "<text{class} style=\"stroke:none\" x=\"{x}\" y=\"{y}\">{words}</text>");
    };
    text(4.0, "", &curve.name);
    match &curve.note {
        Some(note) => {
            text(19.0, " class=\"small\"", note);
            y + LINE + NOTE
        }
        None => y + LINE,
    }
}
