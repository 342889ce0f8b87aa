//! A body at a place in space, seen from a fixed point: the way there along the axes, in projection.

use crate::extent::Extent;
use crate::input::LabelledVector;
use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::central::draw_centre;
use super::moving::{MovingBody, Scales, draw_vector};
use crate::body::Attach;

/// The room in which the places are spread out.
const ROOM: Point = Point::new(210.0, 200.0);
const LONGEST: f64 = 62.0;
const DOT: f64 = 1.8;

/// A body in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Space {
    /// The name of the fixed point.
    pub centre: Math,
    /// The way from there to the body, along one axis after another, as it lies on the drawing.
    pub legs: Vec<LabelledVector>,
    /// Other fixed points, each with its place on the drawing.
    pub points: Vec<LabelledVector>,
    /// The body.
    pub body: MovingBody,
}

impl Space {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let step = |at: &mut Point, leg: &LabelledVector| {
            *at = *at + leg.vector().unwrap_or_default();
            Some(*at)
        };
        let corners: Vec<Point> = self.legs.iter().scan(Point::ORIGIN, step).collect();
        let points: Vec<Point> = self.points.iter().filter_map(LabelledVector::vector).collect();
        let spread = Extent::around(corners.iter().chain(&points).copied().chain([Point::ORIGIN])).size();
        let factor = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::INFINITY };
        let factor = factor(ROOM.x, spread.x).min(factor(ROOM.y, spread.y));
        let factor = if factor.is_finite() { factor } else { 1.0 };
        let place = corners.last().copied().unwrap_or_default() * factor;
        let scales = Scales::of([&self.body], LONGEST);
        let mut body = self.body.outline().moved(place);
        body.draw(canvas);
        draw_centre(canvas, Point::ORIGIN, &self.centre, place.angle());
        let inward = place * (-1.0 / place.length().max(f64::MIN_POSITIVE));
        canvas.line([Point::ORIGIN, place + inward * body.reach(inward)], Role::Length, false);
        let mut from = Point::ORIGIN;
        for (leg, corner) in self.legs.iter().zip(&corners) {
            let to = *corner * factor;
            let back = from - to;
            let end = if (to - place).length() < 1e-9 && back.length() > 0.0 {
                to + back * (body.reach(back * (1.0 / back.length())) / back.length()).min(1.0)
            } else {
                to
            };
            if back.length() > 1e-9 {
                canvas.line([from, end], Role::Guide, true);
                canvas.label(&leg.label, Role::Length, Anchor::Along { from, to: end });
            }
            from = to;
        }
        for point in &self.points {
            let Some(at) = point.vector().map(|at| at * factor) else { continue };
            canvas.draw(Shape::Circle { centre: at, radius: DOT, role: Role::Axis });
            canvas.label(&point.label, Role::Body, Anchor::Around { at, radius: DOT, prefer: 2.0 });
        }
        for moving in &self.body.vectors {
            draw_vector(canvas, &mut body, moving, &scales, Attach::Leaving);
        }
    }
}
