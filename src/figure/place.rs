//! Placing labels: each tries the places that a draughtsman would try, in that order, then ever wider rings.

use std::f64::consts::TAU;

use momentous_expr::Math;

use super::extent::{Contact, Extent, Measure, extent, label_extent};
use super::scale::Scale;
use super::{Drawing, Point, Role, Shape};

/// The sentence about arrows that are not to scale.
const LENGTHENED: &str = "The shortest arrows are drawn longer than to scale.";
/// Clear space between a label and what it belongs to.
const GAP: f64 = 3.0;
/// Labels beside arrows keep clear of the head, which is wider than the shaft.
const HEAD_ROOM: f64 = 2.0;
/// Room for the rest of the head of an arrow whose label lies beyond its end.
const HEAD_LENGTH: f64 = 5.0;
/// Clear space between a label and everything else.
const CLEARANCE: f64 = 1.2;
/// Clear space between the label of one arrow and another arrow: as much as there is room for.
const DISTANCES: [f64; 2] = [11.0, 6.0];
/// How near another arrow must be for labels to be mixed up.
const NEARBY: f64 = 18.0;
/// Below this part of a label's width a line is short; above this part of its length its lesser side makes it slant.
const SHORT: f64 = 0.5;
const SLANTING: f64 = 0.12;
/// The parts of a line at which its label is tried, first on the one side and then on the other.
const PARTS: [f64; 5] = [0.5, 0.7, 0.35, 0.9, 0.15];
/// The directions around a point in which its label is tried, in eighths of a turn from the preferred one.
const EIGHTHS: [f64; 8] = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0];
/// How far beyond the arc of an angle its label is tried.
const OPENINGS: [f64; 6] = [0.0, 6.0, 12.0, 18.0, 24.0, 30.0];
/// The number of those where the sides are short.
const NEAR_OPENINGS: usize = 3;
/// Step from ring to ring, number of rings, places on a ring.
const RING_STEP: f64 = 5.0;
const RINGS: u32 = 80;
const RING_PLACES: u32 = 16;

/// The owner of a label.
#[derive(Clone, Copy, Debug)]
pub(super) enum Anchor {
    /// A line or an arrow: beside its middle, then beside other parts of it, then beyond its end.
    Along { from: Point, to: Point },
    /// A point with a radius about it: in the preferred direction (radians), then in others.
    Around { at: Point, radius: f64, prefer: f64 },
    /// The opening of an angle between two directions: beyond its arc, far beyond it only where its sides are long, then
    /// beside the arc on either side, then as around its vertex.
    Opening { at: Point, radius: f64, prefer: f64, sides: [f64; 2], is_long: bool },
}

/// A drawing in the making: shapes that are fixed, and labels that still look for their places.
#[derive(Clone, Debug, Default)]
pub(super) struct Canvas {
    shapes: Vec<Shape>,
    /// The box of each shape, which is compared with many places: measuring is dear.
    frames: Vec<Extent>,
    wishes: Vec<(Math, Role, Anchor)>,
    /// The remarks of the caption on how things are drawn.
    notes: Vec<&'static str>,
}

impl Canvas {
    pub(super) fn draw(&mut self, shape: Shape) {
        self.frames.push(extent(&shape));
        self.shapes.push(shape);
    }

    /// The arrows have these lengths, which the caption has to tell where they are not true.
    pub(super) fn tell_scale(&mut self, scale: Scale) {
        if scale.lengthens {
            self.tell(LENGTHENED);
        }
    }

    /// The caption has to say this.
    pub(super) fn tell(&mut self, note: &'static str) {
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    pub(super) fn notes(&self) -> &[&'static str] {
        &self.notes
    }

    /// The shapes of another canvas, moved.
    pub(super) fn draw_moved(&mut self, other: Self, by: Point) {
        other.notes.iter().for_each(|note| self.tell(note));
        for shape in other.shapes {
            self.draw(shape.moved(by));
        }
    }

    pub(super) fn line(&mut self, points: impl IntoIterator<Item = Point>, role: Role, dashed: bool) {
        self.draw(Shape::Line { points: points.into_iter().collect(), role, dashed });
    }

    pub(super) fn arrow(&mut self, from: Point, to: Point, role: Role) {
        self.draw(Shape::Arrow { from, to, role });
    }

    /// A label whose place is known: the name in a body, a tick's number.
    pub(super) fn fixed_label(&mut self, at: Point, text: &Math, role: Role) {
        self.draw(Shape::Label { at, text: text.clone(), role });
    }

    /// A label that looks for its place when all shapes are there.
    pub(super) fn label(&mut self, text: &Math, role: Role, anchor: Anchor) {
        self.wishes.push((text.clone(), role, anchor));
    }

    /// The shapes so far, without the labels that still look for their places.
    pub(super) fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// The box around all shapes.
    pub(super) fn frame(&self) -> Extent {
        self.frames.iter().copied().reduce(Extent::joined).unwrap_or_default()
    }

    /// The same with every label at its place.
    pub(super) fn settled(mut self) -> Self {
        for (text, role, anchor) in std::mem::take(&mut self.wishes) {
            let at = self.place(label_extent(Point::ORIGIN, &text), anchor);
            self.draw(Shape::Label { at, text, role });
        }
        self
    }

    /// All shapes that have their places.
    pub(super) fn into_shapes(self) -> Vec<Shape> {
        self.shapes
    }

    /// The first place for a label of that size that is free, or else the first of all.
    fn place(&self, label: Extent, anchor: Anchor) -> Point {
        let near = || (0..).map_while(|index| near_place(anchor, label.size(), index));
        let start = near().next().unwrap_or_default();
        let rings = (1..=RINGS).flat_map(|ring| {
            let radius = RING_STEP * f64::from(ring);
            (0..RING_PLACES).map(move |turn| {
                let angle = TAU * (f64::from(turn) / f64::from(RING_PLACES) + 0.25);
                start + Point::polar(radius, angle)
            })
        });
        let is_free = |at: &Point| {
            let extent = label.moved(*at).grown(CLEARANCE);
            !self.near(extent).any(|shape| is_blocked(extent, shape))
        };
        let foreign = self.foreign(anchor);
        let is_clear = |at: &Point, distance: f64| {
            let extent = label.moved(*at).grown(distance);
            is_free(at) && foreign.iter().all(|shape| extent.contact(shape) == Contact::Clear)
        };
        // Beside a short slanting arrow a wide label lies far off; about its end it does not.
        let short = is_short(anchor, label.size());
        let ends = if short || !foreign.is_empty() { end_places(anchor, label.size()) } else { Vec::new() };
        let (first, second) = if short { (&ends[..], None) } else { (&[][..], ends.first()) };
        let near_and_end = || first.iter().copied().chain(near()).chain(second.copied());
        let clear = |distance: f64| near_and_end().find(|at| is_clear(at, distance));
        // Where no other arrow is near, any place beside its own will do.
        let best = if foreign.is_empty() { None } else { DISTANCES.into_iter().find_map(clear) };
        best.or_else(|| first.iter().copied().chain(near()).chain(rings).find(is_free)).unwrap_or(start)
    }

    /// The shapes whose boxes meet this one: no other can touch what lies in it.
    fn near(&self, extent: Extent) -> impl Iterator<Item = &Shape> {
        let both = self.shapes.iter().zip(&self.frames);
        both.filter(move |(_, frame)| extent.meets(**frame)).map(|(shape, _)| shape)
    }

    /// Other arrows so near to an arrow that its label could be taken for theirs.
    fn foreign(&self, anchor: Anchor) -> Vec<&Shape> {
        // An arrow's label lies along it from its tail, or towards its tail.
        let Anchor::Along { from: start, to: end } = anchor else { return Vec::new() };
        let room = Extent::around([start, end]).grown(NEARBY);
        let is_other = |shape: &&Shape| match shape {
            Shape::Arrow { from, role, .. } => *role != Role::Guide && *from != start && *from != end,
            _ => false,
        };
        self.near(room).filter(is_other).filter(|shape| room.contact(shape) != Contact::Clear).collect()
    }
}

fn is_blocked(extent: Extent, shape: &Shape) -> bool {
    match extent.contact(shape) {
        Contact::Clear => false,
        Contact::Inside => shape.is_body(),
        Contact::Crosses => true,
    }
}

/// Beyond the end of an arrow or a line, then to the sides of that; the anchor of an arrow ends amid its head.
fn end_places(anchor: Anchor, size: Point) -> Vec<Point> {
    let Anchor::Along { from, to } = anchor else { return Vec::new() };
    let along = (to - from).angle();
    let place = |eighths: f64| clear_of(to, Point::polar(1.0, along + eighths * TAU / 8.0), GAP + HEAD_LENGTH, size);
    if from == to { Vec::new() } else { [0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5].map(place).to_vec() }
}

/// Whether a label is much longer than the slanting line that it belongs to.
fn is_short(anchor: Anchor, size: Point) -> bool {
    let Anchor::Along { from, to } = anchor else { return false };
    let along = to - from;
    let slants = along.x.abs().min(along.y.abs()) > SLANTING * along.length();
    slants && along.length() < SHORT * size.x
}

/// The place of that index beside what a label belongs to; none behind the last.
fn near_place(anchor: Anchor, size: Point, index: usize) -> Option<Point> {
    match anchor {
        Anchor::Along { from, to } => {
            let along = to - from;
            let unit = if along.length() > 0.0 { along * (1.0 / along.length()) } else { Point::new(1.0, 0.0) };
            let normal = if unit.turned().y < -1e-9 { -unit.turned() } else { unit.turned() };
            // Beside a steep line the label starts at the point, beside a level one it is centred on it. What that
            // leaves of the label beyond the line is made up for by distance.
            let beside = |part: f64, side: Point| {
                let share = |component: f64| (2.0 * component).clamp(-1.0, 1.0) / 2.0;
                let shift = Point::new(size.x * share(side.x), size.y * share(side.y));
                let lack = Point::new(side.x.abs(), side.y.abs()).dot(size * 0.5) - shift.dot(side);
                from.towards(to, part) + shift + side * (GAP + HEAD_ROOM + lack)
            };
            match PARTS.get(index / 2) {
                Some(part) => Some(beside(*part, if index.is_multiple_of(2) { normal } else { -normal })),
                None => (index == 2 * PARTS.len()).then(|| clear_of(to, unit, GAP, size)),
            }
        }
        Anchor::Around { at, radius, prefer } => {
            let eighths = EIGHTHS.get(index)?;
            Some(clear_of(at, Point::polar(1.0, prefer + eighths * TAU / 8.0), radius + GAP, size))
        }
        Anchor::Opening { at, radius, prefer, sides, is_long } => {
            let openings = if is_long { &OPENINGS[..] } else { &OPENINGS[..NEAR_OPENINGS] };
            let beside = |angle: f64| {
                let side = Point::polar(1.0, angle);
                let inwards = side.turned().dot(Point::polar(1.0, prefer)) > 0.0;
                clear_of(at + side * radius, if inwards { -side.turned() } else { side.turned() }, GAP, size)
            };
            match (openings.get(index), index.wrapping_sub(openings.len())) {
                (Some(more), _) => Some(clear_of(at, Point::polar(1.0, prefer), radius + GAP + more, size)),
                (None, side @ (0 | 1)) => Some(beside(sides[side])),
                (None, around) => near_place(Anchor::Around { at, radius, prefer }, size, around - 2),
            }
        }
    }
}

/// The nearest centre in that direction for a box that keeps `distance` from the point.
fn clear_of(at: Point, direction: Point, distance: f64, size: Point) -> Point {
    let half = size * 0.5;
    let reach = |half: f64, part: f64| if part.abs() > 1e-9 { half / part.abs() } else { f64::INFINITY };
    at + direction * (distance + reach(half.x, direction.x).min(reach(half.y, direction.y)))
}

/// The centre that a label must have for its baseline to be at `height`.
pub(super) fn on_baseline(x: f64, height: f64, text: &Math) -> Point {
    Point::new(x, height + Measure::of(text).drop())
}

/// A label that touches something it must not.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap {
    /// The label.
    pub label: Shape,
    /// The shape that it touches.
    pub other: Shape,
}

/// Every pair of a label and a line, an arrow, an outline or another label that share room, by their estimated boxes.
///
/// A label wholly inside an outline (the name of a body) is as it should be, and so is one on a shaded area.
///
/// ```
/// use momentous_expr::Math;
/// use momentous_figure::{Drawing, Point, Role, Shape, overlaps};
///
/// let text = Math::Identifier("v".into());
/// let label = |x| Shape::Label { at: Point { x, y: 0.0 }, text: text.clone(), role: Role::Velocity };
/// let (low, high) = (Point { x: -9.0, y: -9.0 }, Point { x: 99.0, y: 9.0 });
/// let words = String::new;
/// let drawing = |shapes| Drawing { title: words(), description: words(), caption: words(), low, high, shapes };
/// assert_eq!(overlaps(&drawing(vec![label(0.0), label(40.0)])).len(), 0);
/// assert_eq!(overlaps(&drawing(vec![label(0.0), label(1.0)])).len(), 1);
/// ```
#[must_use]
pub fn overlaps(drawing: &Drawing) -> Vec<Overlap> {
    let is_label = |shape: &Shape| matches!(shape, Shape::Label { .. });
    let mut overlaps = Vec::new();
    for (index, label) in drawing.shapes.iter().enumerate() {
        let Shape::Label { at, text, .. } = label else { continue };
        let extent = label_extent(*at, text);
        // Two labels meet once, not twice.
        let others = drawing.shapes.iter().enumerate().filter(|(other, shape)| !is_label(shape) || *other > index);
        for (_, other) in others {
            if extent.contact(other) == Contact::Crosses {
                overlaps.push(Overlap { label: label.clone(), other: other.clone() });
            }
        }
    }
    overlaps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_goes_to_the_other_side_when_the_first_is_taken() {
        let mut canvas = Canvas::default();
        let (from, to) = (Point::ORIGIN, Point::new(60.0, 0.0));
        canvas.arrow(from, to, Role::Velocity);
        canvas.line([Point::new(0.0, 8.0), Point::new(60.0, 8.0)], Role::Surface, false);
        canvas.label(&Math::Identifier("v".into()), Role::Velocity, Anchor::Along { from, to });
        let shapes = canvas.settled().into_shapes();
        assert!(matches!(shapes.last(), Some(Shape::Label { at, .. }) if at.y < 0.0));
    }
}
