//! A body on a cord that moves round a level circle, seen from the side.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::coil::draw_cord;
use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::central::draw_centre;
use super::moving::MovingBody;

const CORD: f64 = 118.0;
/// Angles beyond these are drawn so, to keep cord, vertical and circle apart.
const ANGLES: [f64; 2] = [0.3, 1.2];
const ARC_ROOM: f64 = 26.0;
/// A level circle seen a little from above.
const FLATTENED: f64 = 0.24;
const PARTS: u32 = 48;
/// The distance that the vertical goes beyond the circle.
const BEYOND: f64 = 14.0;
/// A velocity across the drawing: its mark, and how far it lies from the body.
const MARK: f64 = 4.5;
const DOT: f64 = 1.4;
const MARK_GAP: f64 = 9.0;

/// A conical pendulum.
#[derive(Clone, Debug, PartialEq)]
pub struct Conical {
    /// The name of the point from which the cord hangs.
    pub centre: Math,
    /// The body.
    pub body: MovingBody,
    /// The angle between the cord and the vertical, in radians, and what is written there.
    pub angle: (f64, Option<Math>),
    /// The label at the cord.
    pub length: Option<Math>,
    /// The velocity, where it may be shown.
    pub velocity: Option<Across>,
}

/// A vector at right angles to the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Across {
    /// Its label.
    pub label: Math,
    /// Whether it points away from the reader.
    pub away: bool,
}

impl Conical {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let (angle, label) = &self.angle;
        let angle = if angle.is_finite() { angle.clamp(ANGLES[0], ANGLES[1]) } else { ANGLES[0] };
        let at = Point::polar(CORD, angle - FRAC_PI_2);
        let body = self.body.outline().moved(at);
        body.draw(canvas);
        draw_centre(canvas, Point::ORIGIN, &self.centre, -FRAC_PI_2);
        draw_cord(canvas, Point::ORIGIN, at * (1.0 - body.reach(at * (1.0 / CORD)) / CORD));
        canvas.line([Point::ORIGIN, Point::new(0.0, at.y - BEYOND)], Role::Axis, true);
        let point = |part: u32| {
            let turn = TAU * f64::from(part) / f64::from(PARTS);
            Point::new(at.x * libm::cos(turn), at.y + FLATTENED * at.x * libm::sin(turn))
        };
        let clear = |point: &Point| (*point - at).length() > body.reach(Point::new(1.0, 0.0)) + 1.0;
        canvas.line((0..=PARTS).map(point).filter(clear), Role::Path, true);
        if let Some(label) = label {
            let mark = AngleMark { from: -FRAC_PI_2, label: label.clone() };
            draw_angle(canvas, &[Vertex::open(Point::ORIGIN, ARC_ROOM)], at * (1.0 / CORD), &mark);
        }
        if let Some(velocity) = &self.velocity {
            velocity.draw(canvas, at + Point::new(body.reach(Point::new(1.0, 0.0)) + MARK_GAP, 0.0));
        }
        if let Some(length) = &self.length {
            canvas.label(length, Role::Length, Anchor::Along { from: Point::ORIGIN, to: at * 0.9 });
        }
    }
}

impl Across {
    /// The feathers of an arrow that flies away, or the tip of one that comes.
    pub(super) fn draw(&self, canvas: &mut Canvas, at: Point) {
        let role = Role::Velocity;
        canvas.draw(Shape::Circle { centre: at, radius: MARK, role });
        if self.away {
            for side in [1.0, -1.0] {
                let arm = Point::new(1.0, side) * (MARK * std::f64::consts::FRAC_1_SQRT_2);
                canvas.line([at - arm, at + arm], role, false);
            }
        } else {
            canvas.draw(Shape::Circle { centre: at, radius: DOT, role });
        }
        canvas.label(&self.label, role, Anchor::Around { at, radius: MARK, prefer: 0.0 });
    }
}
