//! Two bodies, or a body and a fixed surface, at the moment of contact.
//!
//! A velocity into the contact is drawn arriving, its tip at the body, and one out of it leaving:
//! so no arrow crosses the other body.

use crate::figure::body::{Attach, Body};
use crate::figure::place::Canvas;
use crate::figure::surface::draw_surface;
use crate::figure::{Point, Role};

use super::angle::{AngleMark, Vertex, draw_angle};
use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 60.0;
const SURFACE_HALF: f64 = 62.0;
/// How far the line of impact goes on beyond the bodies.
const OVERHANG: f64 = 40.0;

/// A contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// The direction from the first body to its partner, in radians.
    pub line_of_impact: f64,
    /// Whether that line is drawn, dashed.
    pub show_line: bool,
    /// The angle that gives the direction of the line, or of a surface's normal: marked beyond the partner, or on the normal.
    pub angle: Option<AngleMark>,
    /// The first body.
    pub first: MovingBody,
    /// What it touches.
    pub second: Partner,
}

/// What the first body touches.
#[derive(Clone, Debug, PartialEq)]
pub enum Partner {
    /// Another body.
    Body(MovingBody),
    /// A fixed plane surface.
    Surface,
}

impl Contact {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angle = if self.line_of_impact.is_finite() { self.line_of_impact } else { 0.0 };
        let normal = Point::polar(1.0, angle);
        let partner = match &self.second {
            Partner::Body(body) => Some(body),
            Partner::Surface => None,
        };
        let scales = Scales::of([&self.first].into_iter().chain(partner), LONGEST);
        let first = self.first.outline().turned(angle);
        let touch = first.support(normal);
        let mut near = touch;
        first.draw(canvas);
        let mut bodies = vec![(&self.first, first, normal)];
        if let Some(body) = partner {
            let outline = body.outline().turned(angle);
            let reach = outline.support(normal);
            near += 2.0 * reach;
            let outline = outline.moved(normal * (touch + reach));
            outline.draw(canvas);
            bodies.push((body, outline, -normal));
        } else {
            let (foot, half) = (normal * touch, normal.turned() * SURFACE_HALF);
            draw_surface(canvas, foot - half, foot + half);
        }
        // Angles look out for bodies, so all bodies come before the first vector.
        for (body, outline, into) in bodies {
            draw_vectors(canvas, body, outline, into, &scales);
        }
        if self.show_line {
            canvas.line([-normal * touch, -normal * (touch + OVERHANG)], Role::Axis, true);
            if partner.is_some() {
                canvas.line([normal * near, normal * (near + OVERHANG + 16.0)], Role::Axis, true);
            }
        }
        if let Some(mark) = &self.angle {
            // Beyond the partner; a surface has no far side, so on its normal.
            let (way, start) = if partner.is_some() { (normal, near) } else { (-normal, touch) };
            let vertices = [8.0, 48.0, 80.0].map(|beyond| Vertex::open(way * (start + beyond), 0.0));
            draw_angle(canvas, &vertices, way, mark);
        }
    }
}

fn draw_vectors(canvas: &mut Canvas, body: &MovingBody, mut outline: Body, into: Point, scales: &Scales) {
    for moving in &body.vectors {
        let arrives = scales.arrow(moving).is_some_and(|arrow| arrow.dot(into) > 1e-9 * arrow.length());
        let attach = if arrives { Attach::Arriving } else { Attach::Leaving };
        draw_vector(canvas, &mut outline, moving, scales, attach);
    }
}
