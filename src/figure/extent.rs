//! How much room shapes take: boxes of labels by a table of character widths, boxes of shapes, and what touches what.

use crate::expr::Math;

use super::geometry::{arc_points, arrow_head, corners};
use super::style::TYPE_SIZE;
use super::typeset::{Face, Run, runs};
use super::{Point, Role, Shape};

/// Widths of characters in units of the type size, after Times; the first line that holds a character decides.
const WIDTHS: [(&str, f64); 8] = [
    ("\u{2009}", 0.18),
    ("ijl.,:;'| \u{a0}", 0.28),
    ("tfrs()[]/I-", 0.37),
    ("0123456789aceoz?*", 0.5),
    ("mwMW\u{2026}\u{21d2}", 0.87),
    ("bdghknpquvxyJ\u{b0}\u{3b8}\u{3b1}\u{3b2}\u{3c9}", 0.53),
    ("+=<>\u{2212}\u{d7}\u{2248}\u{2264}\u{2265}\u{b1}\u{2260}\u{221a}", 0.58),
    ("BCEFLPRSTVXYZ", 0.67),
];
/// Every other character: wide capitals, other scripts.
const WIDEST: f64 = 0.74;
/// Readers' fonts differ; some are this much wider than Times.
const ALLOWANCE: f64 = 1.06;

/// Heights above and below the baseline, in units of the type size.
const LOW_LETTERS: &str = "acegmnopqrsuvwxyz.,:+\u{2212}=\u{2009}\u{a0}\u{3b1}\u{3b5}\u{3bc}\u{3c0}\u{3c3}\u{3c9}";
const HANGING_LETTERS: &str = "gjpqy,()[]/Q|\u{222b}\u{3b2}\u{3bc}";
const LOW_HEIGHT: f64 = 0.46;
const FULL_HEIGHT: f64 = 0.69;
const HANG: f64 = 0.22;

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
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
        let join = |own: Self, point: Point| own.joined(Self { low: point, high: point });
        let single = |point| Self { low: point, high: point };
        let mut points = points.into_iter();
        let first = single(points.next().unwrap_or_default());
        points.fold(first, join)
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
            Shape::Rectangle { centre, size, angle, .. } => {
                let within = |corner: &Point| {
                    let own = (*corner - *centre).rotated(-angle);
                    own.x.abs() <= size.x / 2.0 && own.y.abs() <= size.y / 2.0
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
        Shape::Rectangle { centre, size, angle, .. } => Extent::around(corners(*centre, *size, *angle)),
        Shape::Arc { centre, radius, from, to, .. } => Extent::around(arc_points(*centre, *radius, *from, *to)),
        Shape::Label { at, text, .. } => label_extent(*at, text),
    }
}

/// The box around all shapes.
#[must_use]
pub fn bounds(shapes: &[Shape]) -> Extent {
    shapes.iter().map(extent).reduce(Extent::joined).unwrap_or(Extent { low: Point::ORIGIN, high: Point::ORIGIN })
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
        Self::of_runs(&runs(text))
    }

    pub(super) fn of_runs(runs: &[Run]) -> Self {
        let mut measure = Self { width: 0.0, above: LOW_HEIGHT, below: 0.0 };
        for run in runs {
            let tall = run.text.chars().any(|character| !LOW_LETTERS.contains(character));
            let hangs = run.text.chars().any(|character| HANGING_LETTERS.contains(character));
            let height = if tall { FULL_HEIGHT } else { LOW_HEIGHT };
            measure.width += width(run) * run.size;
            measure.above = measure.above.max(run.rise + run.size * height);
            measure.below = measure.below.max(-run.rise + if hangs { run.size * HANG } else { 0.0 });
        }
        let scale = TYPE_SIZE;
        Self { width: measure.width * scale * ALLOWANCE, above: measure.above * scale, below: measure.below * scale }
    }

    /// How far its baseline lies below its middle.
    pub(super) fn drop(self) -> f64 {
        (self.above - self.below) / 2.0
    }
}

fn width(run: &Run) -> f64 {
    let of = |character: char| {
        WIDTHS.iter().find(|(characters, _)| characters.contains(character)).map_or(WIDEST, |(_, width)| *width)
    };
    // Bold faces and slanted last letters stick out a little.
    let extra = if run.face == Face::Upright { 0.0 } else { 0.06 };
    run.text.chars().map(of).sum::<f64>() + extra
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
