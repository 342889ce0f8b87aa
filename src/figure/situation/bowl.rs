//! A body inside a cone or a bowl, cut through the axis.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::place::{Anchor, Canvas};
use crate::{Point, Role};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::conical::Across;
use super::dimension::draw_dimension;
use super::moving::MovingBody;

const WIDTH: f64 = 96.0;
const HEIGHT: f64 = 130.0;
const PARTS: u32 = 48;
const ARC_ROOM: f64 = 34.0;
/// The distance that the axis goes beyond the wall.
const BEYOND: f64 = 12.0;
/// From the wall to the dimension of a height.
const ASIDE: f64 = 16.0;
const MARK_GAP: f64 = 9.0;
/// Half the angle of a cone is drawn between these.
const ANGLES: [f64; 2] = [0.35, 1.1];
/// The direction in which the radius of a sphere is drawn.
const RADIUS: f64 = 1.22 * PI;
/// The least distance between two levels that can be distinguished, and the least depth of a place in a cone.
const APART: f64 = 26.0;

/// The wall round a vertical axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Wall {
    /// The lower half of a sphere; what is written at its radius.
    Sphere(Option<Math>),
    /// A cone: the angle between axis and wall, and what is written there.
    Cone(f64, Option<Math>),
}

/// A body inside a bowl.
#[derive(Clone, Debug, PartialEq)]
pub struct Bowl {
    /// The body.
    pub body: MovingBody,
    /// The wall.
    pub wall: Wall,
    /// The distance of the body from the axis as a part of the sphere's radius; of a cone it has no scale.
    pub share: f64,
    /// The label at that distance.
    pub distance: Option<Math>,
    /// How far the body rises (or sinks, where it is negative) to the other level, as a part of the sphere's radius or of the
    /// height over the tip, and what is written there.
    pub rise: Option<(f64, Math)>,
    /// The velocity along the circle, where it may be shown.
    pub velocity: Option<Across>,
}

impl Bowl {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        match &self.wall {
            Wall::Sphere(label) => self.draw_sphere(canvas, label.as_ref()),
            Wall::Cone(angle, label) => self.draw_cone(canvas, *angle, label.as_ref()),
        }
    }

    fn draw_sphere(&self, canvas: &mut Canvas, label: Option<&Math>) {
        let parts = (0..=PARTS).map(|part| PI + PI * f64::from(part) / f64::from(PARTS));
        canvas.line(parts.map(|turn| Point::polar(WIDTH, turn)), Role::Surface, false);
        canvas.line([Point::ORIGIN, Point::new(0.0, -WIDTH - BEYOND)], Role::Axis, true);
        let share = if self.share.is_finite() { self.share.clamp(0.25, 1.0) } else { 1.0 };
        let depth = |share: f64| libm::sqrt(1.0 - share * share);
        let on_wall = Point::new(share, -depth(share)) * WIDTH;
        let level = self.rise.as_ref().map(|(rise, _)| (on_wall.y + rise * WIDTH).clamp(4.0 - WIDTH, 0.0));
        let inwards = on_wall * (-1.0 / WIDTH);
        self.draw_levels(canvas, [on_wall, inwards], level, &|y| libm::sqrt((WIDTH * WIDTH - y * y).max(0.0)));
        if let Some(label) = label {
            let end = Point::polar(WIDTH, RADIUS);
            canvas.line([Point::ORIGIN, end], Role::Length, false);
            canvas.label(label, Role::Length, Anchor::Along { from: Point::ORIGIN, to: end });
        }
    }

    fn draw_cone(&self, canvas: &mut Canvas, angle: f64, label: Option<&Math>) {
        let angle = if angle.is_finite() { angle.clamp(ANGLES[0], ANGLES[1]) } else { ANGLES[0] };
        let tangent = libm::tan(angle);
        let height = HEIGHT.min(WIDTH / tangent);
        for side in [1.0, -1.0] {
            canvas.line([Point::ORIGIN, Point::new(side * height * tangent, height)], Role::Surface, false);
        }
        canvas.line([Point::new(0.0, -BEYOND), Point::new(0.0, height + BEYOND)], Role::Axis, true);
        // The higher of the two levels lies a little below the edge.
        let rise = self.rise.as_ref().map_or(0.0, |(rise, _)| *rise);
        let top = 0.86 * height;
        // In a flat cone both levels lie within little height.
        let apart = APART.min(top / 2.0);
        let depth = if rise > 0.0 { (top / (1.0 + rise)).clamp(apart, top - apart) } else { top };
        let other = if rise > 0.0 { top } else { (depth * (1.0 + rise)).clamp(apart, top - apart) };
        let level = self.rise.as_ref().map(|_| other);
        let inwards = Point::polar(1.0, PI - angle);
        self.draw_levels(canvas, [Point::new(depth * tangent, depth), inwards], level, &|y| y * tangent);
        if let Some(label) = label {
            let mark = AngleMark { from: FRAC_PI_2, label: label.clone() };
            draw_angle(canvas, &[Vertex::open(Point::ORIGIN, ARC_ROOM)], Point::polar(1.0, FRAC_PI_2 + angle), &mark);
        }
    }

    /// The body inside the wall at a place of it, the other level, and the height between them.
    fn draw_levels(
        &self,
        canvas: &mut Canvas,
        [on_wall, inwards]: [Point; 2],
        level: Option<f64>,
        half_width: &dyn Fn(f64) -> f64,
    ) {
        let outline = self.body.outline();
        let reach = outline.reach(Point::new(1.0, 0.0));
        let inside = on_wall + inwards * (outline.reach(inwards) + 1.0);
        let body = outline.moved(inside);
        body.draw(canvas);
        let right = half_width(inside.y.max(level.unwrap_or(inside.y))) + ASIDE;
        let left = Point::new(0.0, inside.y);
        canvas.line([left, Point::new(inside.x - reach, inside.y)], Role::Guide, true);
        if let Some(distance) = &self.distance {
            canvas.label(distance, Role::Length, Anchor::Along { from: left, to: inside });
        }
        if let (Some(level), Some((_, label))) = (level, &self.rise) {
            let half = half_width(level);
            canvas.line([Point::new(-half, level), Point::new(right + 4.0, level)], Role::Guide, true);
            canvas.line([inside + Point::new(reach, 0.0), Point::new(right + 4.0, inside.y)], Role::Guide, true);
            draw_dimension(canvas, Point::new(right, inside.y), Point::new(right, level), label);
        }
        if let Some(velocity) = &self.velocity {
            velocity.draw(canvas, inside + Point::new(0.0, reach + MARK_GAP));
        }
    }
}
