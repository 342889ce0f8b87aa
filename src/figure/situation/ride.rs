//! A body on another one that can give way: a walker on a boat, a block on a wedge with wheels.

use std::f64::consts::PI;

use crate::body::Body;
use crate::place::{Anchor, Canvas};
use crate::surface::draw_surface;
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle, wedge};
use super::dimension::draw_dimension;
use super::moving::{Moving, MovingBody, Scales, draw_vector};

const DECK: Point = Point::new(150.0, 18.0);
/// The length of a slope, seen from above.
const WEDGE_WIDTH: f64 = 150.0;
const FLATTEST: f64 = 0.2;
const STEEPEST: f64 = 0.9;
/// Which part of its slope a body lies above, from the foot.
const PLACE: f64 = 0.74;
const LONGEST: f64 = 46.0;
const OVERHANG: f64 = 34.0;
const GAP: f64 = 9.0;

/// A body on another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Ride {
    /// The body on top.
    pub rider: MovingBody,
    /// The carrier on which it moves.
    pub carrier: MovingBody,
    /// The face along which it moves.
    pub face: Face,
}

/// The face of another body along which a body moves.
#[derive(Clone, Debug, PartialEq)]
pub enum Face {
    /// A level deck.
    Deck {
        /// The label at the way.
        way: Option<Math>,
        /// Whether the way leads to the right.
        rightwards: bool,
        /// Whether it stands on a floor, and not on water.
        floor: bool,
    },
    /// A slope.
    Slope {
        /// Its angle in radians, positive.
        angle: f64,
        /// The label at that angle.
        label: Option<Math>,
        /// Whether it falls to the right.
        rightwards: bool,
        /// The label at the height of the body above the end of the face.
        height: Option<Math>,
    },
}

impl Ride {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let scales = Scales::of([&self.rider, &self.carrier], LONGEST);
        match &self.face {
            Face::Deck { way, rightwards, floor } => {
                self.draw_deck(canvas, way.as_ref(), [*rightwards, *floor], &scales);
            }
            Face::Slope { angle, label, rightwards, height } => {
                let angle = if angle.is_finite() { angle.clamp(FLATTEST, STEEPEST) } else { FLATTEST };
                self.draw_slope(canvas, angle, [label.as_ref(), height.as_ref()], *rightwards, &scales);
            }
        }
    }

    fn draw_deck(&self, canvas: &mut Canvas, way: Option<&Math>, [rightwards, floor]: [bool; 2], scales: &Scales) {
        let deck = Body::deck(&self.carrier.name, DECK);
        deck.draw(canvas);
        let up = Point::new(0.0, 1.0);
        let rider = self.rider.outline();
        let side = if rightwards { 1.0 } else { -1.0 };
        let end = DECK.x / 2.0 - rider.support(Point::new(1.0, 0.0)) - 2.0;
        let half = if floor { deck.support(up) } else { DECK.y / 2.0 };
        let level = half + rider.support(up);
        let rider = rider.moved(Point::new(-side * end, level));
        rider.draw(canvas);
        // The water: what carries the deck does not hold it.
        let water = Point::new(DECK.x / 2.0 + OVERHANG, -DECK.y / 4.0);
        if floor {
            let [left, right] = [-1.0, 1.0].map(|side| Point::new(side * water.x, -half));
            draw_surface(canvas, left, right);
        }
        for side in [-1.0, 1.0].into_iter().filter(|_| !floor) {
            let shore = Point::new(side * water.x, water.y);
            canvas.line([Point::new(side * DECK.x / 2.0, water.y), shore], Role::Guide, false);
        }
        if let Some(label) = way {
            let height = DECK.y / 2.0 + GAP;
            let from = Point::new(rider.centre().x + side * (rider.support(Point::new(1.0, 0.0)) + 3.0), height);
            canvas.arrow(from, Point::new(side * end, height), Role::Length);
            canvas.label(label, Role::Length, Anchor::Along { from, to: Point::new(side * end, height) });
        }
        draw_vectors(canvas, rider, &self.rider.vectors, scales);
        draw_vectors(canvas, deck, &self.carrier.vectors, scales);
    }

    fn draw_slope(
        &self,
        canvas: &mut Canvas,
        angle: f64,
        [label, height]: [Option<&Math>; 2],
        rightwards: bool,
        scales: &Scales,
    ) {
        let side = if rightwards { 1.0 } else { -1.0 };
        let top = Point::new(0.0, WEDGE_WIDTH * libm::tan(angle));
        let (heel, foot) = (Point::ORIGIN, Point::new(side * WEDGE_WIDTH, 0.0));
        canvas.draw(Shape::Area { points: vec![heel, foot, top], role: Role::Body });
        canvas.line([heel, foot, top, heel], Role::Body, false);
        let floor = [foot.x.min(0.0) - OVERHANG, foot.x.max(0.0) + OVERHANG].map(|x| Point::new(x, 0.0));
        draw_surface(canvas, floor[0], floor[1]);
        let normal = Point::new(side * libm::sin(angle), libm::cos(angle));
        let rider = self.rider.outline().turned(-side * angle);
        let base = foot.towards(top, PLACE);
        let rider = rider.clone().moved(base + normal * rider.support(normal));
        rider.draw(canvas);
        let name = Point::new(side * WEDGE_WIDTH * 0.24, top.y * 0.28);
        canvas.fixed_label(name, &self.carrier.name, Role::Body);
        if let Some(label) = label {
            let mark = AngleMark { from: if rightwards { PI } else { 0.0 }, label: label.clone() };
            draw_angle(canvas, &[Vertex::open(foot, wedge(angle))], top - foot, &mark);
        }
        if let Some(height) = height {
            let x = -side * (OVERHANG / 2.0);
            canvas.line([Point::new(x - side * 4.0, base.y), base], Role::Guide, false);
            draw_dimension(canvas, Point::new(x, 0.0), Point::new(x, base.y), height);
        }
        draw_vectors(canvas, rider, &self.rider.vectors, scales);
    }
}

fn draw_vectors(canvas: &mut Canvas, mut outline: Body, vectors: &[Moving], scales: &Scales) {
    for moving in vectors {
        draw_vector(canvas, &mut outline, moving, scales, moving.attach);
    }
}
