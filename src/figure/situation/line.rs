//! Bodies apart from each other along a straight line: a track, a slope, a vertical.

use std::f64::consts::PI;

use crate::figure::body::{Attach, Body};
use crate::figure::extent::Measure;
use crate::figure::place::Canvas;
use crate::figure::surface::draw_surface;
use crate::figure::{Point, Role};

use super::angle::{AngleMark, Vertex, draw_angle};
use super::moving::{Moving, MovingBody, Scales, draw_vector};

const LONGEST: f64 = 58.0;
const GAP: f64 = 22.0;
const OVERHANG: f64 = 18.0;
/// From the foot of a slope to the arc of its angle, far enough for a label in the wedge.
const WEDGE: f64 = 44.0;

/// Bodies along a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its angle in radians, from which the bodies follow each other: 0 from left to right.
    pub angle: f64,
    /// The bodies in their order.
    pub bodies: Vec<MovingBody>,
    /// Whether they rest on a hatched floor parallel to the line.
    pub floor: bool,
    /// The slope's angle against the level, marked at its foot.
    pub slope: Option<AngleMark>,
}

impl Line {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angle = if self.angle.is_finite() { self.angle } else { 0.0 };
        let along = Point::polar(1.0, angle);
        let up = if along.turned().y < -1e-9 { -along.turned() } else { along.turned() };
        let scales = Scales::of(&self.bodies, LONGEST);
        let outlines: Vec<Body> = self.bodies.iter().map(|body| body.outline().turned(angle)).collect();
        let floor = outlines.iter().map(|body| body.support(up)).fold(0.0, f64::max);
        let mut end = 0.0;
        let mut placed = Vec::new();
        for (body, outline) in self.bodies.iter().zip(outlines) {
            let (low, high) = self.reach_along(body, &outline, &scales, along, up);
            // On a floor all stand on it; else their centres are in line.
            let height = if self.floor { outline.support(up) - floor } else { 0.0 };
            let outline = outline.moved(along * (end - low) + up * height);
            outline.draw(canvas);
            placed.push((body, outline));
            end += high - low + GAP;
        }
        // Angles look out for bodies, so all bodies come before the first vector.
        for (body, mut outline) in placed {
            for moving in &body.vectors {
                let attach = self.attach(&scales, moving, up);
                draw_vector(canvas, &mut outline, moving, &scales, attach);
            }
        }
        if self.floor {
            let foot = -up * floor;
            let (start, end) = (foot - along * OVERHANG, foot + along * (end - GAP + OVERHANG));
            let ends = if along.turned().dot(up) > 0.0 { (start, end) } else { (end, start) };
            draw_surface(canvas, ends.0, ends.1);
            if let Some(mark) = &self.slope {
                Self::draw_slope(canvas, start, end, mark);
            }
        }
    }

    /// The level line at the lower end of the slope, and the angle between them.
    fn draw_slope(canvas: &mut Canvas, start: Point, end: Point, mark: &AngleMark) {
        let (foot, top) = if start.y <= end.y { (start, end) } else { (end, start) };
        let level = if (top - foot).x < 0.0 { PI } else { 0.0 };
        let width = (top - foot).x.abs();
        canvas.line([foot, foot + Point::polar(width, level)], Role::Guide, false);
        draw_angle(
            canvas,
            &[Vertex::open(foot, WEDGE)],
            top - foot,
            &AngleMark { from: level, label: mark.label.clone() },
        );
    }

    /// What pushes a body down to its floor is drawn from above.
    fn attach(&self, scales: &Scales, moving: &Moving, up: Point) -> Attach {
        let into_floor = scales.arrow(moving).is_some_and(|arrow| arrow.dot(up) < -0.1 * arrow.length());
        if self.floor && into_floor { Attach::Arriving } else { moving.attach }
    }

    /// How far the body and its arrows reach back and forth along the line.
    fn reach_along(&self, body: &MovingBody, outline: &Body, scales: &Scales, along: Point, up: Point) -> (f64, f64) {
        let mut trial = outline.clone();
        let (mut low, mut high) = (-outline.support(along), outline.support(along));
        for moving in &body.vectors {
            if let Some(arrow) = scales.arrow(moving) {
                let (from, to) = trial.attach(arrow, self.attach(scales, moving, up));
                for point in [from, to] {
                    low = low.min(point.dot(along));
                    high = high.max(point.dot(along));
                }
            }
            // Room for the label beside or above the body, so that neighbours' labels do not run together.
            let needed = Measure::of(&moving.vector.label).width * along.x.abs();
            let lack = (needed - (high - low)).max(0.0) / 2.0;
            (low, high) = (low - lack, high + lack);
        }
        (low, high)
    }
}
