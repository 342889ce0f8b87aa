//! How much room shapes take: boxes of labels by a table of character widths, boxes of shapes, and what touches what.

use momentous_expr::Math;

use super::geometry::{arc_points, arrow_head, corners};
use super::style::TYPE_SIZE;
use super::typeset::{Face, Look, set};
use super::{Point, Role, Shape};

/// Readers' fonts differ; some are this much wider than Times.
const ALLOWANCE: f64 = 1.06;

/// Heights above and below the baseline, in units of the type size.
const LOW_HEIGHT: f64 = 0.46;
const FULL_HEIGHT: f64 = 0.69;
const HANG: f64 = 0.22;

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// Its lower left corner.
    pub low: Point,
    /// Its upper right corner.
    pub high: Point,
}

/// How a box lies to a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contact {
    /// They have nothing in common.
    Clear,
    /// The box lies wholly inside a closed outline.
    Inside,
    /// The box meets a line or an outline.
    Crosses,
}

impl Extent {
    /// The box around points; of none, the empty box at the origin.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Point>) -> Self {
        let join = |extent: Self, point: Point| extent.joined(Self { low: point, high: point });
        let single = |point| Self { low: point, high: point };
        let mut points = points.into_iter();
        let first = single(points.next().unwrap_or_default());
        points.fold(first, join)
    }

    /// The box of that size about a point.
    fn level(centre: Point, size: Point) -> Self {
        let half = size * 0.5;
        Self { low: centre - half, high: centre + half }
    }

    /// The smallest box around both.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self {
            low: Point::new(self.low.x.min(other.low.x), self.low.y.min(other.low.y)),
            high: Point::new(self.high.x.max(other.high.x), self.high.y.max(other.high.y)),
        }
    }

    /// The box with `margin` more on every side.
    #[must_use]
    pub fn grown(self, margin: f64) -> Self {
        let step = Point::new(margin, margin);
        Self { low: self.low - step, high: self.high + step }
    }

    /// The box somewhere else.
    #[must_use]
    pub(super) fn moved(self, by: Point) -> Self {
        Self { low: self.low + by, high: self.high + by }
    }

    /// Width and height.
    #[must_use]
    pub fn size(self) -> Point {
        self.high - self.low
    }

    /// Its middle.
    #[must_use]
    pub fn centre(self) -> Point {
        self.low.towards(self.high, 0.5)
    }

    /// Whether the boxes share more than their edges.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.low.x < other.high.x && other.low.x < self.high.x && self.low.y < other.high.y && other.low.y < self.high.y
    }

    fn corners(self) -> [Point; 4] {
        corners(self.centre(), self.size(), 0.0)
    }

    fn holds(self, point: Point) -> bool {
        self.low.x < point.x && point.x < self.high.x && self.low.y < point.y && point.y < self.high.y
    }

    /// Whether a straight line from `start` to `end` enters the box: the line is cut by each pair of sides in turn.
    fn is_entered(self, start: Point, end: Point) -> bool {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        let along = end - start;
        for (from, step, low, high) in
            [(start.x, along.x, self.low.x, self.high.x), (start.y, along.y, self.low.y, self.high.y)]
        {
            if step.abs() < 1e-12 {
                if from <= low || from >= high {
                    return false;
                }
                continue;
            }
            let (one, other) = ((low - from) / step, (high - from) / step);
            enter = enter.max(one.min(other));
            leave = leave.min(one.max(other));
        }
        enter < leave
    }

    fn is_entered_by(self, points: &[Point]) -> bool {
        points.windows(2).any(|pair| matches!(pair, [start, end] if self.is_entered(*start, *end)))
    }

    /// How the box lies to `shape`.
    pub(super) fn contact(self, shape: &Shape) -> Contact {
        let crosses = match shape {
            Shape::Line { points, .. } => self.is_entered_by(points),
            Shape::Arrow { from, to, .. } => {
                let ([tip, left, right], _) = arrow_head(*from, *to);
                self.is_entered_by(&[*from, tip, left, right, tip])
            }
            Shape::Arc { centre, radius, from, to, .. } => {
                self.is_entered_by(&arc_points(*centre, *radius, *from, *to))
            }
            Shape::Circle { centre, radius, .. } => {
                if self.corners().iter().all(|corner| (*corner - *centre).length() <= *radius) {
                    return Contact::Inside;
                }
                let nearest =
                    Point::new(centre.x.max(self.low.x).min(self.high.x), centre.y.max(self.low.y).min(self.high.y));
                (nearest - *centre).length() < *radius
            }
            Shape::Rectangle { centre, size, angle: 0.0, .. } => {
                let outline = Self::level(*centre, *size);
                if outline.joined(self) == outline {
                    return Contact::Inside;
                }
                self.meets(outline)
            }
            Shape::Rectangle { centre, size, angle, .. } => {
                let within = |corner: &Point| {
                    let turned = (*corner - *centre).rotated(-angle);
                    turned.x.abs() <= size.x / 2.0 && turned.y.abs() <= size.y / 2.0
                };
                if self.corners().iter().all(within) {
                    return Contact::Inside;
                }
                let [a, b, c, d] = corners(*centre, *size, *angle);
                self.is_entered_by(&[a, b, c, d, a]) || self.holds(*centre)
            }
            Shape::Area { .. } => false,
            Shape::Label { at, text, .. } => self.meets(label_extent(*at, text)),
        };
        if crosses { Contact::Crosses } else { Contact::Clear }
    }
}

impl Shape {
    /// Whether it is the outline of a body.
    pub(super) fn is_body(&self) -> bool {
        matches!(self, Self::Circle { role: Role::Body, .. } | Self::Rectangle { role: Role::Body, .. })
    }
}

/// The box of a shape, without the width of its line.
#[must_use]
pub fn extent(shape: &Shape) -> Extent {
    match shape {
        Shape::Line { points, .. } | Shape::Area { points, .. } => Extent::around(points.iter().copied()),
        Shape::Arrow { from, to, .. } => {
            let (head, _) = arrow_head(*from, *to);
            Extent::around(head.into_iter().chain([*from]))
        }
        Shape::Circle { centre, radius, .. } => Extent { low: *centre, high: *centre }.grown(*radius),
        Shape::Rectangle { centre, size, angle: 0.0, .. } => Extent::level(*centre, *size),
        Shape::Rectangle { centre, size, angle, .. } => Extent::around(corners(*centre, *size, *angle)),
        Shape::Arc { centre, radius, from, to, .. } => Extent::around(arc_points(*centre, *radius, *from, *to)),
        Shape::Label { at, text, .. } => label_extent(*at, text),
    }
}

/// The box around all shapes.
#[must_use]
pub fn bounds(shapes: &[Shape]) -> Extent {
    shapes.iter().map(extent).reduce(Extent::joined).unwrap_or_default()
}

/// The estimated box of a label centred on `at`.
#[must_use]
pub fn label_extent(at: Point, text: &Math) -> Extent {
    let measure = Measure::of(text);
    let half = Point::new(measure.width, measure.above + measure.below) * 0.5;
    Extent { low: at - half, high: at + half }
}

/// The estimated size of a label, in drawing units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Measure {
    pub width: f64,
    /// Above its baseline.
    pub above: f64,
    /// Below its baseline.
    pub below: f64,
}

impl Measure {
    pub(super) fn of(text: &Math) -> Self {
        let mut gauge = Gauge { whole: Self { width: 0.0, above: LOW_HEIGHT, below: 0.0 }, run: None };
        set(text, &mut |piece, look| gauge.put(piece, look));
        gauge.close();
        let Self { width, above, below } = gauge.whole;
        Self { width: width * TYPE_SIZE * ALLOWANCE, above: above * TYPE_SIZE, below: below * TYPE_SIZE }
    }

    /// How far its baseline lies below its middle.
    pub(super) fn drop(self) -> f64 {
        (self.above - self.below) / 2.0
    }
}

/// Measures a label as it is set, run by run: what looks alike is one run.
struct Gauge {
    whole: Measure,
    run: Option<Measured>,
}

/// A run as far as it is measured, in units of its own size.
struct Measured {
    look: Look,
    width: f64,
    height: f64,
    hang: f64,
}

impl Gauge {
    fn put(&mut self, piece: &str, look: Look) {
        let run = match &mut self.run {
            Some(run) if run.look == look => run,
            _ => {
                self.close();
                self.run.insert(Measured { look, width: 0.0, height: LOW_HEIGHT, hang: 0.0 })
            }
        };
        for character in piece.chars() {
            run.width += width(character);
            run.height = if is_low(character) { run.height } else { FULL_HEIGHT };
            run.hang = if hangs(character) { HANG } else { run.hang };
        }
    }

    /// Adds the run that is complete.
    fn close(&mut self) {
        let (whole, Some(Measured { look, width, height, hang })) = (&mut self.whole, self.run.take()) else { return };
        // Bold faces and slanted last letters stick out a little.
        let extra = if look.face == Face::Upright { 0.0 } else { 0.06 };
        whole.width += (width + extra) * look.size;
        whole.above = whole.above.max(look.rise + look.size * height);
        whole.below = whole.below.max(-look.rise + look.size * hang);
    }
}

/// Widths of characters in units of the type size, after Times.
fn width(character: char) -> f64 {
    match character {
        '\u{2009}' => 0.18,
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | ' ' | '\u{a0}' => 0.28,
        't' | 'f' | 'r' | 's' | '(' | ')' | '[' | ']' | '/' | 'I' | '-' => 0.37,
        '0'..='9' | 'a' | 'c' | 'e' | 'o' | 'z' | '?' | '*' => 0.5,
        'b' | 'd' | 'g' | 'h' | 'k' | 'n' | 'p' | 'q' | 'u' | 'v' | 'x' | 'y' | 'J' | '\u{b0}' | '\u{3b1}'
        | '\u{3b2}' | '\u{3b8}' | '\u{3c9}' => 0.53,
        '+' | '=' | '<' | '>' | '\u{b1}' | '\u{d7}' | '\u{2212}' | '\u{221a}' | '\u{2248}' | '\u{2260}'
        | '\u{2264}' | '\u{2265}' => 0.58,
        'B' | 'C' | 'E' | 'F' | 'L' | 'P' | 'R' | 'S' | 'T' | 'V' | 'X' | 'Y' | 'Z' => 0.67,
        'm' | 'w' | 'M' | 'W' | '\u{2026}' | '\u{21d2}' => 0.87,
        // Wide capitals, other scripts.
        _ => 0.74,
    }
}

/// Whether it is no higher than an x.
fn is_low(character: char) -> bool {
    matches!(
        character,
        'a' | 'c' | 'e' | 'g' | 'm'..='s' | 'u'..='z' | '.' | ',' | ':' | '+' | '=' | '\u{2212}' | '\u{2009}' | '\u{a0}'
            | '\u{3b1}' | '\u{3b5}' | '\u{3bc}' | '\u{3c0}' | '\u{3c3}' | '\u{3c9}'
    )
}

/// Whether it reaches below the baseline.
fn hangs(character: char) -> bool {
    matches!(character, 'g' | 'j' | 'p' | 'q' | 'y' | ',' | '(' | ')' | '[' | ']' | '/' | 'Q' | '|')
        || matches!(character, '\u{222b}' | '\u{3b2}' | '\u{3bc}')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Extent {
        Extent { low: Point::ORIGIN, high: Point::new(10.0, 10.0) }
    }

    #[test]
    fn a_line_beside_the_box_is_clear_and_one_through_it_is_not() {
        let line = |y: f64| Shape::Line {
            points: vec![Point::new(-5.0, y), Point::new(20.0, y)],
            role: Role::Axis,
            dashed: false,
        };
        assert_eq!(square().contact(&line(11.0)), Contact::Clear);
        assert_eq!(square().contact(&line(5.0)), Contact::Crosses);
    }

    #[test]
    fn a_box_may_lie_inside_a_disc_but_not_across_its_rim() {
        let disc = |radius: f64| Shape::Circle { centre: Point::new(5.0, 5.0), radius, role: Role::Body };
        assert_eq!(square().contact(&disc(8.0)), Contact::Inside);
        assert_eq!(square().contact(&disc(6.0)), Contact::Crosses);
    }

    #[test]
    fn longer_labels_are_wider() {
        let width = |text: &str| Measure::of(&Math::Text(text.into())).width;
        assert!(width("cart A") > width("A") && width("W") > width("l"));
    }
}
