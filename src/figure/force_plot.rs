//! Force against time: the curve, and the area under it, which is the impulse.

use std::sync::Arc;

use momentous_expr::Math;
use momentous_expr::Operator;

use super::extent::Measure;
use super::input::Wording;
use super::place::{Anchor, Canvas, on_baseline};
use super::ticks::Ticks;
use super::{Drawing, Point, Role, Shape};

const SIZE: Point = Point::new(230.0, 130.0);
const TICK: f64 = 3.5;
const TICK_GAP: f64 = 4.0;
/// Free part of the plot above the curve, and of the axes beyond it.
const HEADROOM: f64 = 1.12;
const AXIS_OVERHANG: f64 = 24.0;

/// Input of a plot of force against time.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcePlot {
    /// Title, description, caption.
    pub wording: Wording,
    /// Time along the bottom.
    pub time: PlotAxis,
    /// Force along the side.
    pub force: PlotAxis,
    /// (time, force) in increasing order of time; straight lines between them. Points that are not finite are left out.
    pub points: Vec<[f64; 2]>,
    /// The label in the shaded area; without it the area is not shaded.
    pub area: Option<Math>,
    /// Times with names of their own, such as `t_a`: marked by dashed lines up to the curve.
    pub marks: Vec<(f64, Math)>,
}

/// The measure along an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotAxis {
    /// Its symbol: `F`.
    pub symbol: Math,
    /// Its unit: `N`.
    pub unit: String,
    /// Values of points of the curve that are written at the axis, in place of round numbers.
    pub told: Vec<(f64, Math)>,
}

/// From (time, force) to places on the drawing.
struct Frame {
    low: Point,
    high: Point,
}

impl Frame {
    fn around(points: &[Point]) -> Self {
        let start = Self { low: Point::ORIGIN, high: Point::ORIGIN };
        let mut plot = points.iter().fold(start, |frame, point| Self {
            low: Point::new(frame.low.x.min(point.x), frame.low.y.min(point.y)),
            high: Point::new(frame.high.x.max(point.x), frame.high.y.max(point.y)),
        });
        plot.low.y *= HEADROOM;
        plot.high.y *= HEADROOM;
        if plot.high.x <= plot.low.x {
            plot.high.x = plot.low.x + 1.0;
        }
        if plot.high.y <= plot.low.y {
            plot.high.y = plot.low.y + 1.0;
        }
        plot
    }

    fn place(&self, point: Point) -> Point {
        let part = |value: f64, low: f64, high: f64| (value - low) / (high - low);
        Point::new(part(point.x, self.low.x, self.high.x) * SIZE.x, part(point.y, self.low.y, self.high.y) * SIZE.y)
    }
}

impl ForcePlot {
    /// The plot, with round numbers at its ticks.
    ///
    /// ```
    /// use momentous_expr::Math;
    /// use momentous_figure::{ForcePlot, PlotAxis, Wording, overlaps};
    ///
    /// let axis = |symbol: &str, unit: &str| PlotAxis {
    ///     symbol: Math::Identifier(symbol.into()),
    ///     unit: unit.into(),
    ///     told: Vec::new(),
    /// };
    /// let plot = ForcePlot {
    ///     wording: Wording::default(),
    ///     time: axis("t", "s"),
    ///     force: axis("F", "N"),
    ///     points: vec![[0.0, 0.0], [0.1, 40.0], [0.4, 0.0]],
    ///     area: Some(Math::Identifier("J".into())),
    ///     marks: Vec::new(),
    /// };
    /// assert!(overlaps(&plot.drawing()).is_empty());
    /// ```
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        self.drawn(&[], &[])
    }

    /// The same with other curves on the same axes.
    #[must_use]
    pub fn beside(&self, others: &[(Vec<[f64; 2]>, Role)]) -> Drawing {
        self.drawn(others, &[])
    }

    /// The same with axes on which these points have a place as well.
    #[must_use]
    pub fn with_room_for(&self, room: &[[f64; 2]]) -> Drawing {
        self.drawn(&[], room)
    }

    fn drawn(&self, others: &[(Vec<[f64; 2]>, Role)], room: &[[f64; 2]]) -> Drawing {
        let finite = |points: &[[f64; 2]]| -> Vec<Point> {
            let points = points.iter().map(|[time, force]| Point::new(*time, *force));
            points.filter(|point| point.x.is_finite() && point.y.is_finite()).collect()
        };
        let points = finite(&self.points);
        let mut all = points.clone();
        all.extend(others.iter().flat_map(|(points, _)| finite(points)));
        all.extend(finite(room));
        let frame = Frame::around(&all);
        let curve: Vec<Point> = points.iter().map(|point| frame.place(*point)).collect();
        let mut canvas = Canvas::default();
        let zero = frame.place(Point::ORIGIN).y;
        if let (Some(_), Some(first), Some(last)) = (&self.area, curve.first(), curve.last()) {
            let mut points = curve.clone();
            points.extend([Point::new(last.x, zero), Point::new(first.x, zero)]);
            canvas.draw(Shape::Area { points, role: Role::Impulse });
        }
        self.draw_axes(&mut canvas, &frame, zero);
        self.draw_guides(&mut canvas, &frame, &points);
        if curve.len() > 1 {
            canvas.draw(Shape::Line { points: curve.clone(), role: Role::Curve, dashed: false });
        }
        for (points, role) in others {
            let points = finite(points).into_iter().map(|point| frame.place(point)).collect();
            canvas.draw(Shape::Line { points, role: *role, dashed: true });
        }
        self.draw_marks(&mut canvas, &frame, &points, zero);
        if let Some(label) = &self.area {
            let at = middle_of_area(&curve, zero);
            canvas.label(label, Role::Impulse, Anchor::Around { at, radius: -8.0, prefer: 0.0 });
        }
        self.wording.drawing(canvas)
    }

    /// Ticks stand at the left and at the bottom of the plot, clear of a curve that goes below zero.
    fn draw_axes(&self, canvas: &mut Canvas, frame: &Frame, zero: f64) {
        let (times, forces) = (Ticks::between(frame.low.x, frame.high.x), Ticks::between(frame.low.y, frame.high.y));
        let (right, top) = (Point::new(SIZE.x + AXIS_OVERHANG, zero), Point::new(0.0, SIZE.y + AXIS_OVERHANG));
        canvas.arrow(Point::new(0.0, zero), right, Role::Axis);
        canvas.arrow(Point::ORIGIN, top, Role::Axis);
        if zero > 0.0 {
            canvas.line([Point::ORIGIN, Point::new(SIZE.x, 0.0)], Role::Guide, false);
        }
        let mut rows = Rows::default();
        for (value, text) in self.time.marked(&times) {
            let foot = Point::new(frame.place(Point::new(value, 0.0)).x, 0.0);
            canvas.line([foot, foot - Point::new(0.0, TICK)], Role::Axis, false);
            let Measure { width, above, below } = Measure::of(&text);
            let row = rows.free(foot.x, width) * (above + below + TICK_GAP);
            canvas.fixed_label(on_baseline(foot.x, foot.y - TICK - TICK_GAP - above - row, &text), &text, Role::Axis);
        }
        let marked = self.force.marked(&forces);
        let widest = marked.iter().map(|(_, text)| Measure::of(text).width).fold(0.0, f64::max);
        let mut columns = Rows::default();
        for (value, text) in marked {
            let side = Point::new(0.0, frame.place(Point::new(0.0, value)).y);
            canvas.line([side, side - Point::new(TICK, 0.0)], Role::Axis, false);
            let Measure { width, above, below } = Measure::of(&text);
            let column = columns.free(side.y, above + below) * (widest + TICK_GAP);
            let shift = TICK + TICK_GAP + width / 2.0 + column;
            canvas.fixed_label(side - Point::new(shift, 0.0), &text, Role::Axis);
        }
        let (time, force) = (self.time.title(&times), self.force.title(&forces));
        let shift = Measure::of(&time).width / 2.0 + TICK_GAP;
        canvas.fixed_label(right + Point::new(shift, 0.0), &time, Role::Axis);
        canvas.label(&force, Role::Axis, Anchor::Around { at: top, radius: 0.0, prefer: std::f64::consts::FRAC_PI_2 });
    }

    /// From each point whose coordinates are written at the axes to these.
    fn draw_guides(&self, canvas: &mut Canvas, frame: &Frame, points: &[Point]) {
        for (time, _) in self.time.told.iter().filter(|(time, _)| *time != 0.0) {
            let heights = points.iter().filter(|point| is_same(point.x, *time)).map(|point| frame.place(*point).y);
            let Some(highest) = heights.reduce(f64::max) else { continue };
            let foot = frame.place(Point::new(*time, 0.0)).x;
            canvas.line([Point::new(foot, 0.0), Point::new(foot, highest)], Role::Guide, true);
        }
        for (force, _) in self.force.told.iter().filter(|(force, _)| *force != 0.0) {
            let Some(first) = points.iter().find(|point| is_same(point.y, *force)) else { continue };
            let first = frame.place(*first);
            canvas.line([Point::new(0.0, first.y), first], Role::Guide, true);
        }
    }

    fn draw_marks(&self, canvas: &mut Canvas, frame: &Frame, points: &[Point], zero: f64) {
        for (time, label) in self.marks.iter().filter(|(time, _)| time.is_finite()) {
            let height = frame.place(Point::new(*time, height_at(points, *time).unwrap_or(0.0))).y;
            let foot = Point::new(frame.place(Point::new(*time, 0.0)).x, zero);
            canvas.line([foot, Point::new(foot.x, height)], Role::Guide, true);
            let top = Point::new(foot.x, height.max(zero));
            let anchor = Anchor::Around { at: top, radius: 1.0, prefer: std::f64::consts::FRAC_PI_2 };
            canvas.label(label, Role::Axis, anchor);
        }
    }
}

/// Whether two coordinates come from the same data: then they are the same to the last digit.
fn is_same(one: f64, other: f64) -> bool {
    one - other == 0.0
}

/// Rows of labels beside an axis, the nearest first: how far each is taken.
#[derive(Default)]
struct Rows(Vec<f64>);

impl Rows {
    /// The first row in which there is room for a label at a place; labels come in rising order.
    fn free(&mut self, at: f64, size: f64) -> f64 {
        let (low, high) = (at - size / 2.0, at + size / 2.0 + TICK_GAP);
        let mut number = 0.0;
        for end in &mut self.0 {
            if *end <= low {
                *end = high;
                return number;
            }
            number += 1.0;
        }
        self.0.push(high);
        number
    }
}

impl PlotAxis {
    /// The labels at the axis, in rising order.
    fn marked(&self, ticks: &Ticks) -> Vec<(f64, Math)> {
        if self.told.is_empty() {
            return ticks.values.iter().map(|value| (*value, Math::Number(ticks.text(*value)))).collect();
        }
        let zero = (0.0, Math::Number("0".to_owned()));
        let mut marked: Vec<(f64, Math)> = self.told.iter().filter(|(value, _)| value.is_finite()).cloned().collect();
        marked.push(zero);
        marked.sort_by(|one, other| one.0.total_cmp(&other.0));
        marked.dedup_by(|one, other| is_same(one.0, other.0));
        marked
    }

    /// `F in N`, or `F in 10^3 N` where the ticks have a power taken out; `F` alone without a unit.
    fn title(&self, ticks: &Ticks) -> Math {
        if self.unit.is_empty() {
            return self.symbol.clone();
        }
        let power = if self.told.is_empty() { ticks.power } else { 0 };
        let mut parts = vec![self.symbol.clone(), Math::Text("in".to_owned())];
        if power != 0 {
            let (ten, power) = (Math::Number("10".to_owned()), Math::Number(power.to_string()));
            parts.extend([Math::Sup(Arc::new(ten), Arc::new(power)), Math::Operator(Operator::Juxtapose)]);
        }
        parts.push(Math::Text(self.unit.clone()));
        Math::Row(parts)
    }
}

/// The height of a line through points at a place, by straight pieces; none outside them.
fn height_at(points: &[Point], x: f64) -> Option<f64> {
    points.windows(2).find_map(|pair| match pair {
        [start, end] if start.x <= x && x <= end.x => {
            let part = if end.x > start.x { (x - start.x) / (end.x - start.x) } else { 0.0 };
            Some(start.towards(*end, part).y)
        }
        _ => None,
    })
}

/// The centroid of the larger of the areas above and below the time axis: where a label sits well.
fn middle_of_area(curve: &[Point], zero: f64) -> Point {
    let lobes = [1.0, -1.0].map(|side| lobe(curve, zero, side));
    let [(above, _), (below, _)] = lobes;
    let (area, moment) = if above >= below { lobes[0] } else { lobes[1] };
    if area > 0.0 { moment * (1.0 / area) } else { Point::new(SIZE.x / 2.0, zero) }
}

/// Area and first moment of what lies on one side (1: above, -1: below) of the time axis, by thin upright strips.
fn lobe(curve: &[Point], zero: f64, side: f64) -> (f64, Point) {
    const STRIPS: u32 = 120;
    let width = SIZE.x / f64::from(STRIPS);
    let strips = (0..STRIPS).map(|strip| (f64::from(strip) + 0.5) * width);
    strips.fold((0.0, Point::ORIGIN), |(area, moment), x| {
        let height = (side * (height_at(curve, x).unwrap_or(zero) - zero)).max(0.0);
        let piece = height * width;
        (area + piece, moment + Point::new(x, zero + side * height / 2.0) * piece)
    })
}
