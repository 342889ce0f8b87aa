//! Two bodies, or a body and a fixed surface, at the moment of contact.
//!
//! A velocity into the contact is drawn arriving, its tip at the body, and one out of it leaving:
//! so no arrow crosses the other body.

use std::f64::consts::PI;

use crate::body::{Attach, Body, label_arrow};
use crate::place::{Anchor, Canvas};
use crate::surface::draw_surface;
use crate::{Point, Role, Shape};

use super::angle::{AngleMark, Vertex, draw_angle};
use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 60.0;
const SURFACE_HALF: f64 = 62.0;
/// Half the length of a plate, its thickness, and the part of the half at which its arrow starts.
const PLATE_HALF: f64 = 36.0;
const PLATE: f64 = 5.0;
const PLATE_ARROW: f64 = 0.7;
/// The distance that the line of impact goes on beyond the bodies.
const OVERHANG: f64 = 40.0;
/// The length of the face of a wedge, and the part of it above the contact.
const FACE: f64 = 120.0;
const PLACE: f64 = 0.45;
/// Directions are at right angles where their cosine is less.
const PERPENDICULAR: f64 = 1e-6;

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
    /// The partner that it touches.
    pub second: Partner,
    /// Further walls, which the body strikes later: the direction into each, in radians. One at right angles to a surface that it
    /// touches now makes a corner with it.
    pub walls: Vec<f64>,
}

/// The partner that the first body touches.
#[derive(Clone, Debug, PartialEq)]
pub enum Partner {
    /// Another body.
    Body(MovingBody),
    /// A body with a slanting face, on a level floor on which it can slide.
    Wedge(MovingBody),
    /// A fixed plane surface.
    Surface,
    /// A plane surface that moves.
    Plate(MovingBody),
}

impl Contact {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angle = if self.line_of_impact.is_finite() { self.line_of_impact } else { 0.0 };
        let normal = Point::polar(1.0, angle);
        let partner = match &self.second {
            Partner::Body(body) | Partner::Wedge(body) | Partner::Plate(body) => Some(body),
            Partner::Surface => None,
        };
        let scales = Scales::of([&self.first].into_iter().chain(partner), LONGEST);
        let first = self.first.outline().turned(angle);
        let touch = first.support(normal);
        let mut near = touch;
        first.draw(canvas);
        let mut bodies = vec![(&self.first, first, normal)];
        if let Partner::Wedge(body) = &self.second {
            bodies.push((body, draw_wedge(canvas, body, normal * touch, normal), -normal));
        } else if let Partner::Plate(body) = &self.second {
            draw_plate(canvas, body, normal, touch, &scales);
        } else if let Some(body) = partner {
            let outline = body.outline().turned(angle);
            let reach = outline.support(normal);
            near += 2.0 * reach;
            let outline = outline.moved(normal * (touch + reach));
            outline.draw(canvas);
            bodies.push((body, outline, -normal));
        } else {
            let (foot, half) = (normal * touch, normal.turned() * SURFACE_HALF);
            draw_surface(canvas, foot - half, foot + half);
            for wall in self.walls.iter().map(|angle| Point::polar(1.0, *angle)) {
                // Ahead along the surface that is touched; others lie where nothing tells.
                if wall.dot(normal).abs() < PERPENDICULAR {
                    draw_corner(canvas, foot + wall * SURFACE_HALF, normal, wall);
                }
            }
        }
        // Angles look out for bodies, so all bodies come before the first vector.
        for (body, outline, into) in bodies {
            draw_vectors(canvas, body, outline, into, &scales);
        }
        if self.show_line {
            canvas.line([-normal * touch, -normal * (touch + OVERHANG)], Role::Axis, true);
            if matches!(self.second, Partner::Body(_)) {
                canvas.line([normal * near, normal * (near + OVERHANG + 16.0)], Role::Axis, true);
            }
        }
        if let Some(mark) = &self.angle {
            // Beyond the partner; a surface has no far side, so on its normal, and a wedge stands on a floor.
            let (way, start) = match &self.second {
                Partner::Body(_) => (normal, near),
                Partner::Wedge(_) | Partner::Surface | Partner::Plate(_) => (-normal, touch),
            };
            let vertices = [8.0, 48.0, 80.0].map(|beyond| Vertex::open(way * (start + beyond), 0.0));
            let turned = AngleMark { from: mark.from + PI, label: mark.label.clone() };
            let mark = if matches!(self.second, Partner::Wedge(_)) { &turned } else { mark };
            draw_angle(canvas, &vertices, way, mark);
        }
    }
}

/// A wall that begins in the corner with another one, whose normal points into it.
fn draw_corner(canvas: &mut Canvas, corner: Point, normal: Point, wall: Point) {
    let end = corner - normal * (2.0 * SURFACE_HALF);
    let free_on_left = (end - corner).turned().dot(wall) < 0.0;
    if free_on_left { draw_surface(canvas, corner, end) } else { draw_surface(canvas, end, corner) }
}

/// A wedge on a floor whose face is touched at a point, with its normal into the wedge; the outline that its arrows start from.
fn draw_wedge(canvas: &mut Canvas, body: &MovingBody, touch: Point, normal: Point) -> Body {
    let down = if normal.turned().y < 0.0 { normal.turned() } else { -normal.turned() };
    let (foot, top) = (touch + down * (FACE * (1.0 - PLACE)), touch - down * (FACE * PLACE));
    let heel = Point::new(top.x, foot.y);
    canvas.draw(Shape::Area { points: vec![heel, foot, top], role: Role::Body });
    canvas.line([heel, foot, top, heel], Role::Body, false);
    let [left, right] = [foot.x.min(heel.x) - OVERHANG, foot.x.max(heel.x) + OVERHANG];
    draw_surface(canvas, Point::new(left, foot.y), Point::new(right, foot.y));
    let inside = Point::new((foot.x + 2.0 * top.x) / 3.0, (top.y + 2.0 * foot.y) / 3.0);
    canvas.fixed_label(inside, &body.name, Role::Body);
    body.outline().moved(inside)
}

/// A plate that moves along its normal, at a distance, with its name at one end and its velocities near the other.
fn draw_plate(canvas: &mut Canvas, body: &MovingBody, normal: Point, touch: f64, scales: &Scales) {
    let (centre, aside) = (normal * (touch + PLATE / 2.0), normal.turned());
    let size = Point::new(PLATE, 2.0 * PLATE_HALF);
    canvas.draw(Shape::Rectangle { centre, size, angle: normal.angle(), role: Role::Body });
    let end = centre - aside * PLATE_HALF;
    canvas.label(&body.name, Role::Body, Anchor::Around { at: end, radius: 0.0, prefer: (-aside).angle() });
    for moving in &body.vectors {
        let Some(arrow) = scales.arrow(moving) else { continue };
        let face = normal * (PLATE / 2.0).copysign(arrow.dot(normal));
        let from = centre + aside * (PLATE_ARROW * PLATE_HALF) + face;
        canvas.arrow(from, from + arrow, moving.role);
        label_arrow(canvas, [from, from + arrow], Attach::Leaving, &moving.vector.label, moving.role);
    }
}

fn draw_vectors(canvas: &mut Canvas, body: &MovingBody, mut outline: Body, into: Point, scales: &Scales) {
    for moving in &body.vectors {
        let arrives = scales.arrow(moving).is_some_and(|arrow| arrow.dot(into) > 1e-9 * arrow.length());
        let attach = if arrives { Attach::Arriving } else { Attach::Leaving };
        draw_vector(canvas, &mut outline, moving, scales, attach);
    }
}
