//! A body about a fixed centre: a satellite, a ball on a cord, a collar on an arm.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 58.0;
const RADIUS: f64 = 92.0;
const CENTRE_DOT: f64 = 1.8;
/// The arc that stands for a moment, and how far it turns.
const MOMENT_RADIUS: f64 = 24.0;
const MOMENT_TURN: f64 = 1.2 * PI;
/// How far the dashed path goes on either side of the body, in radians.
const PATH: f64 = 0.9;
/// The sketch of an orbit: its eccentricity, which is nobody's, and how far it goes on either side of its nearest point.
const ECCENTRICITY: f64 = 0.45;
const ORBIT: f64 = 1.9;
/// How much smaller a whole orbit is drawn, and its parts.
const WHOLE: f64 = 0.62;
const PARTS: u8 = 60;

/// A body about a fixed centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Central {
    /// The name of the centre.
    pub centre: Math,
    /// The body's direction from the centre, in radians.
    pub angle: f64,
    /// The label of its distance from the centre.
    pub radius: Option<Math>,
    /// The labels of the horizontal and the vertical part of that distance, drawn dashed.
    pub legs: Option<[Math; 2]>,
    /// The body with its given velocities, along x and y.
    pub body: MovingBody,
    /// The path through the body, dashed.
    pub path: Option<CentralPath>,
    /// The label of the distance of the other end of a closed orbit, of which the whole is drawn then.
    pub other_end: Option<Math>,
    /// A moment about the centre.
    pub moment: Option<Moment>,
}

/// The path of a body about a centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CentralPath {
    /// A circle.
    Circle,
    /// An orbit, of which the body is at the point nearest to the centre.
    Nearest,
    /// An orbit, of which the body is at the point farthest from the centre.
    Farthest,
}

impl CentralPath {
    /// How far it goes on either side of the body, in radians.
    fn reach(self) -> f64 {
        match self {
            Self::Circle => PATH,
            Self::Nearest | Self::Farthest => ORBIT,
        }
    }

    /// The distance from the centre at an angle from the radius of the body.
    fn radius(self, angle: f64) -> f64 {
        let eccentricity = match self {
            Self::Circle => 0.0,
            Self::Nearest => ECCENTRICITY,
            Self::Farthest => -ECCENTRICITY,
        };
        RADIUS * (1.0 + eccentricity) / (1.0 + eccentricity * libm::cos(angle))
    }
}

/// A moment about a centre, drawn as an arc around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The label at its arc.
    pub label: Math,
    /// Positive counter-clockwise; only the sign is drawn.
    pub value: f64,
}

impl Central {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angle = if self.angle.is_finite() { self.angle } else { 0.0 };
        let outward = Point::polar(1.0, angle);
        let scales = Scales::of([&self.body], LONGEST);
        let size = if self.other_end.is_some() && self.path == Some(CentralPath::Nearest) { WHOLE } else { 1.0 };
        let distance = size * RADIUS;
        let mut body = self.body.outline().moved(outward * distance);
        body.draw(canvas);
        // Where the line to the other end of the orbit leaves on the far side, the name stands below.
        let free = if self.other_end.is_some() { FRAC_PI_2 } else { angle };
        draw_centre(canvas, Point::ORIGIN, &self.centre, free);
        let end = outward * (distance - body.reach(-outward));
        canvas.line([outward * CENTRE_DOT, end], Role::Length, false);
        if let Some(label) = &self.radius {
            canvas.label(label, Role::Length, Anchor::Along { from: Point::ORIGIN, to: end });
        }
        if let Some([horizontal, vertical]) = &self.legs {
            let corner = Point::new(outward.x * distance, 0.0);
            let upright = Point::new(0.0, if outward.y < 0.0 { -1.0 } else { 1.0 });
            let height = (outward.y * distance).abs() - body.reach(-upright);
            for (from, to, label) in
                [(Point::ORIGIN, corner, horizontal), (corner, corner + upright * height.max(0.0), vertical)]
            {
                canvas.line([from, to], Role::Guide, true);
                canvas.label(label, Role::Length, Anchor::Along { from, to });
            }
        }
        if let Some(path) = self.path {
            let hidden = 1.1 * body.support(outward.turned()) / distance;
            let at = |part: f64| Point::polar(size * path.radius(part), angle + part);
            let parts = |from: f64, to: f64, parts: u8| {
                (0..=parts).map(move |part| at(from + (to - from) * f64::from(part) / f64::from(parts)))
            };
            if let Some(label) = &self.other_end {
                canvas.line(parts(hidden, TAU - hidden, PARTS), Role::Path, true);
                canvas.line([-outward * CENTRE_DOT, at(PI)], Role::Length, false);
                canvas.label(label, Role::Length, Anchor::Along { from: Point::ORIGIN, to: at(PI) });
            } else {
                for [from, to] in [[-path.reach(), -hidden], [hidden, path.reach()]] {
                    canvas.line(parts(from, to, 12), Role::Path, true);
                }
            }
        }
        for moving in &self.body.vectors {
            draw_vector(canvas, &mut body, moving, &scales, moving.attach);
        }
        if let Some(moment) = &self.moment {
            moment.draw(canvas, angle);
        }
    }
}

impl Moment {
    /// On the far side of the centre, clear of the radius.
    fn draw(&self, canvas: &mut Canvas, outward: f64) {
        let turn = if self.value < 0.0 { -MOMENT_TURN } else { MOMENT_TURN };
        let (centre, radius, role) = (Point::ORIGIN, MOMENT_RADIUS, Role::Force);
        let from = outward + PI - turn / 2.0;
        canvas.draw(Shape::Arc { centre, radius, from, to: from + turn, arrow: true, role });
        canvas.label(&self.label, role, Anchor::Around { at: centre, radius, prefer: outward + PI });
    }
}

/// A small mark with a name: a fixed centre.
pub(crate) fn draw_centre(canvas: &mut Canvas, at: Point, name: &Math, away_from: f64) {
    canvas.draw(Shape::Circle { centre: at, radius: CENTRE_DOT, role: Role::Axis });
    let anchor = Anchor::Around { at, radius: CENTRE_DOT, prefer: away_from + std::f64::consts::PI };
    canvas.label(name, Role::Body, anchor);
}
