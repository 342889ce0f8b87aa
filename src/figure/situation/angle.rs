//! Angles: a dashed reference, an arc from it to a direction, a label.

use std::f64::consts::{PI, TAU};

use crate::extent::{Contact, Extent, Measure};
use crate::geometry::arc_points;
use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

const REFERENCE: f64 = 34.0;
const ARC_RADIUS: f64 = 22.0;
/// Between two arcs about one point, which would read as one angle if they had one radius.
const ARC_GAP: f64 = 7.0;
/// Parts of a short arrow that they take at most.
const REFERENCE_SHARE: f64 = 0.6;
const ARC_SHARE: f64 = 0.4;
/// An arc shorter than this (radians) cannot be seen, and one this close to a half turn has no short way.
const SMALLEST_ANGLE: f64 = 0.02;
/// How high the wedge of a slope must be for a label, and how far from its foot it may be so.
const WEDGE_HEIGHT: f64 = 15.0;
const WEDGE: (f64, f64) = (30.0, 92.0);
/// The room that a label takes up between the sides of an angle, beside its height, and how far the sides go on beyond it.
const LABEL_ROOM: f64 = 4.0;
const BEYOND_LABEL: f64 = 8.0;
/// Farther away than this a label stands beside its angle rather than in it.
const FARTHEST_LABEL: f64 = 80.0;
/// Strokes keep this far from bodies.
const CLEARANCE: f64 = 1.0;

/// An angle with its label, from a dashed reference direction to a vector or a line.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleMark {
    /// The reference direction, in radians.
    pub from: f64,
    /// The label at the arc.
    pub label: Math,
}

/// A place where an angle may be marked.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    pub at: Point,
    /// From the vertex to where the reference starts.
    pub inner: f64,
    /// How far away the next body is.
    pub room: f64,
    /// By how much a smaller angle takes up the opening, in radians.
    pub taken: f64,
}

impl Vertex {
    /// A vertex with nothing near it but what lies within `inner`.
    pub(super) fn open(at: Point, inner: f64) -> Self {
        Self { at, inner, room: f64::INFINITY, taken: 0.0 }
    }

    /// The same vertex, where a smaller angle has its place within the opening.
    pub(super) fn beyond(mut self, taken: f64) -> Self {
        self.taken = taken;
        self
    }

    fn reference(self, angle: f64) -> [Point; 2] {
        self.line(angle, [self.inner, self.inner + REFERENCE.min(REFERENCE_SHARE * self.room)])
    }

    fn line(self, angle: f64, distances: [f64; 2]) -> [Point; 2] {
        distances.map(|distance| self.at + Point::polar(distance, angle))
    }

    fn radius(self) -> f64 {
        self.inner + ARC_RADIUS.min(ARC_SHARE * self.room)
    }

    /// Whether its strokes keep clear of all bodies; the reference may start at one.
    fn is_clear(self, canvas: &Canvas, from: f64, turn: f64) -> bool {
        let [start, end] = self.reference(from);
        let reference = (2..=10).map(|tenth| start.towards(end, f64::from(tenth) / 10.0));
        let strokes = reference.chain(arc_points(self.at, self.radius(), from, from + turn));
        let mut boxes = strokes.map(|point| Extent::around([point]).grown(CLEARANCE));
        let bodies: Vec<&Shape> = canvas.shapes().iter().filter(|shape| shape.is_body()).collect();
        boxes.all(|extent| bodies.iter().all(|body| extent.contact(body) == Contact::Clear))
    }
}

/// Marks the angle at the first vertex where its strokes keep clear of all bodies, or else at the last one.
///
/// The arc goes the short way; a vertex that is not the first one needs the direction continued, dashed.
pub(super) fn draw_angle(canvas: &mut Canvas, vertices: &[Vertex], direction: Point, mark: &AngleMark) {
    let turn = signed_turn(mark.from, direction.angle());
    if !turn.is_finite() || turn.abs() < SMALLEST_ANGLE || turn.abs() > PI - SMALLEST_ANGLE {
        return;
    }
    let chosen = vertices.iter().position(|vertex| vertex.is_clear(canvas, mark.from, turn));
    let chosen = chosen.unwrap_or(vertices.len().saturating_sub(1));
    let Some(vertex) = vertices.get(chosen) else { return };
    let reference = vertex.reference(mark.from);
    if !canvas.shapes().iter().any(|shape| covers(shape, reference)) {
        canvas.line(reference, Role::Guide, true);
    }
    if chosen > 0 {
        canvas.line(vertex.reference(direction.angle()), Role::Guide, true);
    }
    let (centre, radius) = (vertex.at, free_radius(canvas, *vertex));
    let (from, to) = if turn > 0.0 { (mark.from, mark.from + turn) } else { (mark.from + turn, mark.from) };
    canvas.draw(Shape::Arc { centre, radius, from, to, arrow: false, role: Role::Guide });
    let is_long = draw_sides(canvas, *vertex, [mark.from, direction.angle()], &mark.label);
    let prefer = mark.from + f64::midpoint(turn, vertex.taken.copysign(turn));
    canvas.label(
        &mark.label,
        Role::Body,
        Anchor::Opening { at: centre, radius, prefer, sides: [mark.from, mark.from + turn], is_long },
    );
}

/// Goes on with both sides of a small angle, dashed, as far as to the place where there is room for its label between them;
/// whether it does.
fn draw_sides(canvas: &mut Canvas, vertex: Vertex, sides: [f64; 2], label: &Math) -> bool {
    let size = Measure::of(label);
    let opening = signed_turn(sides[0], sides[1]).abs() - vertex.taken;
    let end = (size.above + size.below + LABEL_ROOM) / (2.0 * libm::tan(opening / 2.0)) + BEYOND_LABEL;
    let [_, drawn] = vertex.reference(sides[0]);
    let reference = (drawn - vertex.at).length();
    if !(end > reference && end <= FARTHEST_LABEL && end + size.width <= vertex.room) {
        return false;
    }
    for (angle, start) in [(sides[0], reference), (sides[1], farthest(canvas, vertex, sides[1]))] {
        if start < end + size.width {
            canvas.line(vertex.line(angle, [start, end + size.width]), Role::Guide, true);
        }
    }
    true
}

/// How far an arrow from the vertex, or towards it, goes in that direction.
fn farthest(canvas: &Canvas, vertex: Vertex, angle: f64) -> f64 {
    let unit = Point::polar(1.0, angle);
    let ends = canvas.shapes().iter().filter_map(|shape| match shape {
        Shape::Arrow { from, to, .. } => Some([*from, *to]),
        _ => None,
    });
    let along = ends.flatten().map(|end| end - vertex.at).filter(|way| (*way - unit * way.dot(unit)).length() < 1.0);
    along.map(|way| way.dot(unit)).fold(vertex.inner, f64::max)
}

/// The radius of the next arc about a vertex: outside the arcs that are there.
fn free_radius(canvas: &Canvas, vertex: Vertex) -> f64 {
    let radius_here = |shape: &Shape| match shape {
        Shape::Arc { centre, radius, arrow: false, .. } if (*centre - vertex.at).length() < ARC_GAP => Some(*radius),
        _ => None,
    };
    let widest = canvas.shapes().iter().filter_map(radius_here).fold(0.0, f64::max);
    if widest > 0.0 { vertex.radius().max(widest + ARC_GAP) } else { vertex.radius() }
}

/// Marks the angle of a slope at its foot, over a level line.
pub(super) fn draw_incline(canvas: &mut Canvas, [foot, head]: [Point; 2], label: &Math) {
    canvas.line([foot, Point::new(head.x, foot.y)], Role::Guide, false);
    let from = if head.x < foot.x { PI } else { 0.0 };
    let along = head - foot;
    draw_angle(canvas, &[Vertex::open(foot, wedge(along.angle()))], along, &AngleMark { from, label: label.clone() });
}

/// From the foot of a slope to the arc of its angle, far enough for a label between slope and level.
pub(super) fn wedge(angle: f64) -> f64 {
    (WEDGE_HEIGHT / libm::sin(angle).abs().max(1e-3)).clamp(WEDGE.0, WEDGE.1)
}

/// Whether an arrow lies where the reference would.
fn covers(shape: &Shape, [start, end]: [Point; 2]) -> bool {
    let Shape::Arrow { from, to, .. } = shape else { return false };
    let along = *to - *from;
    let unit = along * (1.0 / along.length().max(1e-9));
    [start, end].into_iter().all(|point| {
        let apart_from = point - *from;
        let part = apart_from.dot(unit);
        (apart_from - unit * part).length() < 1.0 && part > -REFERENCE && part < along.length() + REFERENCE
    })
}

/// The turn from one angle to another, between -pi and pi.
fn signed_turn(from: f64, to: f64) -> f64 {
    let turn = libm::fmod(to - from, TAU);
    if turn > PI {
        turn - TAU
    } else if turn <= -PI {
        turn + TAU
    } else {
        turn
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arc_goes_the_short_way() {
        let cases = [(0.0, PI / 6.0, PI / 6.0), (3.0, -3.0, TAU - 6.0), (-3.0, 3.0, 6.0 - TAU)];
        for (from, to, turn) in cases {
            assert!((signed_turn(from, to) - turn).abs() < 1e-12);
        }
    }

    #[test]
    fn an_angle_moves_away_from_a_body_in_its_way() {
        let mut canvas = Canvas::default();
        canvas.draw(Shape::Circle { centre: Point::new(25.0, 0.0), radius: 10.0, role: Role::Body });
        let mark = AngleMark { from: 0.0, label: Math::Identifier("b".into()) };
        let vertices = [Vertex::open(Point::ORIGIN, 0.0), Vertex::open(Point::new(0.0, 60.0), 0.0)];
        draw_angle(&mut canvas, &vertices, Point::new(0.0, 1.0), &mark);
        assert!(canvas.shapes().iter().any(|shape| matches!(shape, Shape::Arc { centre, .. } if centre.y > 50.0)));
    }
}
