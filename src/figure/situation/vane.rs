//! A jet that a curved vane turns: its edges before and after, and the vane along the bend.

use std::f64::consts::PI;

use crate::body::{Attach, label_arrow};
use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::moving::{Moving, MovingBody, Scales};

const LONGEST: f64 = 52.0;
/// The straight pieces of the jet before and after the bend, and the radius of the bend.
const STRAIGHT: f64 = 84.0;
const RADIUS: f64 = 26.0;
/// From the middle of the jet to its edges, from there to the vane, and its thickness.
const HALF: f64 = 6.0;
const GAP: f64 = 1.2;
const THICKNESS: f64 = 5.0;
const PARTS: u8 = 24;
/// Between arrows that start at the vane side by side.
const LANE: f64 = 9.0;
/// From the end of the bend to the vertex of its angle.
const VERTEX: f64 = 8.0;
/// From there to the velocity after the bend.
const BEYOND: f64 = 30.0;

/// A jet and its vane.
#[derive(Clone, Debug, PartialEq)]
pub struct Vane {
    /// The name of the vane.
    pub name: Math,
    /// The directions of the jet before and after it, in radians.
    pub directions: [f64; 2],
    /// The velocities of the jet before and after, as far as they are given.
    pub jet: [Option<Moving>; 2],
    /// The given vectors of the vane itself: its velocity, the force on it.
    pub vectors: Vec<Moving>,
    /// The angle that gives the second direction.
    pub angle: Option<AngleMark>,
}

impl Vane {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let [first, second] = self.directions.map(|angle| if angle.is_finite() { angle } else { 0.0 });
        let turn = {
            let turn = (second - first).rem_euclid(2.0 * PI);
            if turn > PI { turn - 2.0 * PI } else { turn }
        };
        let (into, out) = (Point::polar(1.0, first), Point::polar(1.0, first + turn));
        let side = if turn < 0.0 { -1.0 } else { 1.0 };
        let centre = into.turned() * (side * RADIUS);
        let bend = |beyond: f64| {
            let from = -centre * ((RADIUS + beyond) / RADIUS);
            (0..=PARTS).map(move |part| centre + from.rotated(turn * f64::from(part) / f64::from(PARTS)))
        };
        let end = centre + (-centre).rotated(turn);
        for beyond in [-HALF, HALF] {
            let start = -into * STRAIGHT - into.turned() * (side * beyond);
            let last = end + out * STRAIGHT - out.turned() * (side * beyond);
            canvas.line([start].into_iter().chain(bend(beyond)).chain([last]), Role::Path, false);
        }
        let (inner, outer) = (HALF + GAP, HALF + GAP + THICKNESS);
        let outline: Vec<Point> = bend(inner).chain(bend(outer).collect::<Vec<_>>().into_iter().rev()).collect();
        canvas.draw(Shape::Area { points: outline.clone(), role: Role::Body });
        let closed = outline.first().copied();
        canvas.line(outline.into_iter().chain(closed), Role::Body, false);
        if let Some(mark) = &self.angle {
            let vertices = [VERTEX, STRAIGHT].map(|beyond| Vertex::open(end + out * beyond, 0.0));
            draw_angle(canvas, &vertices, out, mark);
        }
        self.draw_jet(canvas, [(-into * STRAIGHT, into), (end + out * BEYOND, out)]);
        let back = (-centre).rotated(turn / 2.0) * (1.0 / RADIUS);
        self.draw_vectors(canvas, centre + back * (RADIUS + outer), back);
    }

    /// The velocities in the middle of the jet.
    fn draw_jet(&self, canvas: &mut Canvas, starts: [(Point, Point); 2]) {
        let scales = self.scales();
        for (moving, (start, unit)) in self.jet.iter().zip(starts) {
            let Some(arrow) = moving.as_ref().and_then(|moving| Some((moving, scales.arrow(moving)?))) else {
                continue;
            };
            let (moving, length) = (arrow.0, arrow.1.length());
            let ends = [start, start + unit * length];
            canvas.arrow(ends[0], ends[1], moving.role);
            label_arrow(canvas, ends, Attach::Leaving, &moving.vector.label, moving.role);
        }
    }

    /// The vectors of the vane start at its back.
    fn draw_vectors(&self, canvas: &mut Canvas, at: Point, back: Point) {
        let scales = self.scales();
        canvas.label(&self.name, Role::Body, Anchor::Around { at, radius: 2.0, prefer: back.angle() + PI / 3.0 });
        for (number, moving) in (0_u8..).zip(&self.vectors) {
            let Some(arrow) = scales.arrow(moving) else { continue };
            let place = at + back * 2.0 - back.turned() * (LANE * f64::from(number));
            // An arrow into the jet ends at the vane instead.
            let (ends, attach) = if arrow.dot(back) < 0.0 {
                ([place - arrow, place], Attach::Arriving)
            } else {
                ([place, place + arrow], Attach::Leaving)
            };
            canvas.arrow(ends[0], ends[1], moving.role);
            label_arrow(canvas, ends, attach, &moving.vector.label, moving.role);
        }
    }

    fn scales(&self) -> Scales {
        let all = self.jet.iter().flatten().chain(&self.vectors).cloned().collect();
        Scales::of([&MovingBody { vectors: all, ..MovingBody::new(self.name.clone()) }], LONGEST)
    }
}
