//! A body that rises or sinks on another one which gives way: a wedge on a floor, a cart from which it hangs.

use std::f64::consts::FRAC_PI_2;

use crate::body::{Attach, Body};
use crate::coil::draw_cord;
use crate::place::{Anchor, Canvas};
use crate::surface::draw_surface;
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::dimension::draw_dimension;
use super::moving::{MovingBody, Scales, draw_vector};
use super::swing::{CORD, draw_height, draw_path};

/// Between what is shown of the start and of the end.
const GAP: f64 = 30.0;
const LONGEST: f64 = 46.0;
/// The point at which the face of a wedge begins to rise, how high above the floor a body stands on it there, and the radius of
/// the face, smaller where the face bends back to a brow.
const FOOT: f64 = 46.0;
const STEP: f64 = 16.0;
const RADIUS: [f64; 2] = [110.0, 56.0];
/// The angle at which a face ends or bends back, that of the place of a body on it, and the length of a brow.
const STEEPEST: f64 = 1.05;
const PLACE: f64 = 0.72;
const BROW: f64 = 44.0;
const PARTS: u32 = 20;
const OVERHANG: f64 = 24.0;
const DIMENSION_GAP: f64 = 14.0;
/// A cart, its wheels, and half the track on which they roll.
const CART: Point = Point::new(64.0, 20.0);
const WHEEL: f64 = 4.0;
const TRACK: f64 = 46.0;
/// Angles of a cord less far from the vertical are drawn so.
const SMALLEST: f64 = 0.4;
const ARC_ROOM: f64 = 22.0;

/// A body on another one that gives way, at the start of its motion, at the end, or at both beside each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// The ends, from left to right.
    pub ends: Vec<CarriedEnd>,
    /// How the one holds the other.
    pub by: CarriedBy,
    /// The label at the height between the two ends.
    pub height: Option<Math>,
}

/// One end of the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct CarriedEnd {
    /// The body that rises or sinks.
    pub rider: MovingBody,
    /// The carrier.
    pub carrier: MovingBody,
    /// The angle of the cord from straight down, in radians, counter-clockwise; on a face, zero at its foot and only there.
    pub angle: f64,
    /// The label at that angle.
    pub label: Option<Math>,
}

/// How a body holds the one that it carries.
#[derive(Clone, Debug, PartialEq)]
pub enum CarriedBy {
    /// By its face, which is level at its foot.
    Face {
        /// Whether it rises to the right.
        rightwards: bool,
        /// Whether it ends level, too.
        brow: bool,
        /// Whether its foot is higher than the floor.
        step: bool,
    },
    /// By a cord, with what is written at it.
    Cord(Option<Math>),
}

impl Carried {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let scales = Scales::of(self.ends.iter().flat_map(|end| [&end.rider, &end.carrier]), LONGEST);
        let raised = self.ends.iter().position(|end| end.angle != 0.0);
        let mut left = 0.0;
        for (number, end) in self.ends.iter().enumerate() {
            let mut inset = Canvas::default();
            let height = self.height.as_ref().filter(|_| raised == Some(number));
            match &self.by {
                CarriedBy::Face { rightwards, brow, step } => {
                    draw_on_face(&mut inset, end, [*rightwards, *brow, *step], height, &scales);
                }
                CarriedBy::Cord(length) => draw_on_cord(&mut inset, end, length.as_ref(), height, &scales),
            }
            let inset = inset.settled();
            let frame = inset.frame();
            canvas.draw_moved(inset, Point::new(left - frame.low.x, 0.0));
            left += frame.size().x + GAP;
        }
    }
}

fn draw_on_face(
    canvas: &mut Canvas,
    end: &CarriedEnd,
    [rightwards, brow, step]: [bool; 3],
    height: Option<&Math>,
    scales: &Scales,
) {
    let side = if rightwards { 1.0 } else { -1.0 };
    let mirrored = |point: Point| Point::new(side * point.x, point.y);
    let foot = Point::new(FOOT, if step { STEP } else { 0.0 });
    let face = face(foot, brow);
    let top = face.last().copied().unwrap_or(foot);
    let start = if step { Point::ORIGIN } else { foot };
    let outline: Vec<Point> = [start, Point::new(start.x, foot.y)]
        .into_iter()
        .chain(face)
        .chain([Point::new(top.x, 0.0), start])
        .map(mirrored)
        .collect();
    canvas.draw(Shape::Area { points: outline.clone(), role: Role::Body });
    canvas.line(outline, Role::Body, false);
    let floor = [-OVERHANG, top.x + OVERHANG].map(|x| Point::new(side * x, 0.0));
    let [low, high] = if rightwards { floor } else { [floor[1], floor[0]] };
    draw_surface(canvas, low, high);
    let name = mirrored(Point::new(top.x - STEP, STEP * 0.8));
    canvas.fixed_label(name, &end.carrier.name, Role::Body);
    let raised = end.angle != 0.0;
    let (place, slope) = match (raised, brow) {
        (false, _) => (Point::new(FOOT / 2.0, foot.y), 0.0),
        (true, true) => (top - Point::new(BROW / 2.0, 0.0), 0.0),
        (true, false) => (on_arc(foot, RADIUS[0], PLACE), PLACE),
    };
    let normal = mirrored(Point::polar(1.0, slope + FRAC_PI_2));
    let rider = end.rider.outline().turned(side * slope);
    // Where the face is hollow, a block stands on its edges.
    let hollow =
        if slope > 0.0 { rider.support(mirrored(Point::polar(1.0, slope))).powi(2) / (2.0 * RADIUS[0]) } else { 0.0 };
    let mut rider = rider.clone().moved(mirrored(place) + normal * (rider.support(normal) + hollow));
    rider.draw(canvas);
    if let Some(height) = height.filter(|_| raised) {
        let x = -DIMENSION_GAP;
        for point in [Point::new(start.x, foot.y), place] {
            canvas.line([Point::new(x - 4.0, point.y), point].map(mirrored), Role::Guide, false);
        }
        let [low, high] = [Point::new(x, foot.y), Point::new(x, place.y)].map(mirrored);
        draw_dimension(canvas, low, high, height);
    }
    for moving in &end.rider.vectors {
        // The face is in the way of an arrow ahead of a body that moves up it.
        let uphill = scales.arrow(moving).is_some_and(|arrow| arrow.x * side > 0.0);
        let attach = if uphill && !(raised && brow) { Attach::Arriving } else { moving.attach };
        draw_vector(canvas, &mut rider, moving, scales, attach);
    }
    // Its arrows start where the wedge is so high.
    let left = if step { 0.0 } else { 2.0 * FOOT };
    let mut base = Body::plank(&end.carrier.name, Point::new(top.x - left, STEP));
    base = base.moved(mirrored(Point::new(left + top.x, STEP) * 0.5));
    for moving in &end.carrier.vectors {
        draw_vector(canvas, &mut base, moving, scales, moving.attach);
    }
}

/// The face of a wedge from its foot: level, up along an arc, and perhaps level again.
fn face(foot: Point, brow: bool) -> Vec<Point> {
    let radius = RADIUS[usize::from(brow)];
    let angle = |part: u32| STEEPEST * f64::from(part) / f64::from(PARTS);
    let mut face: Vec<Point> = (0..=PARTS).map(|part| on_arc(foot, radius, angle(part))).collect();
    if brow {
        let turn = on_arc(foot, radius, STEEPEST);
        let bent = face.iter().rev().map(|point| turn * 2.0 - *point).collect::<Vec<_>>();
        face.extend(bent);
        face.extend(face.last().map(|end| *end + Point::new(BROW, 0.0)));
    }
    face
}

fn on_arc(foot: Point, radius: f64, angle: f64) -> Point {
    foot + Point::new(libm::sin(angle), 1.0 - libm::cos(angle)) * radius
}

fn draw_on_cord(canvas: &mut Canvas, end: &CarriedEnd, length: Option<&Math>, height: Option<&Math>, scales: &Scales) {
    let angle = if end.angle.is_finite() { end.angle.clamp(-FRAC_PI_2, FRAC_PI_2) } else { 0.0 };
    let angle = if angle == 0.0 { 0.0 } else { angle.abs().max(SMALLEST).copysign(angle) };
    let cart = Body::plank(&end.carrier.name, CART);
    let mut cart = cart.clone().moved(Point::new(0.0, cart.support(Point::new(0.0, 1.0))));
    cart.draw(canvas);
    let axle = CART.x / 2.0 - 3.0 * WHEEL;
    for side in [-1.0, 1.0] {
        let centre = Point::new(side * axle, -WHEEL);
        canvas.draw(Shape::Circle { centre, radius: WHEEL, role: Role::Body });
    }
    canvas.line([-TRACK, TRACK].map(|x| Point::new(x, -2.0 * WHEEL)), Role::Surface, false);
    let at = |angle: f64| end.rider.outline().moved(Point::polar(CORD, angle - FRAC_PI_2));
    let (lowest, mut rider) = (at(0.0), at(angle));
    rider.draw(canvas);
    let inward = rider.centre() * (-1.0 / CORD);
    draw_cord(canvas, Point::ORIGIN, rider.centre() + inward * rider.reach(inward));
    if angle != 0.0 {
        draw_path(canvas, [0.0, angle], [&lowest, &rider]);
    }
    if let Some(label) = &end.label {
        let mark = AngleMark { from: -FRAC_PI_2, label: label.clone() };
        draw_angle(canvas, &[Vertex::open(Point::ORIGIN, ARC_ROOM)], Point::polar(1.0, angle - FRAC_PI_2), &mark);
    }
    for moving in &end.rider.vectors {
        draw_vector(canvas, &mut rider, moving, scales, moving.attach);
    }
    for moving in &end.carrier.vectors {
        draw_vector(canvas, &mut cart, moving, scales, moving.attach);
    }
    if let Some(length) = length {
        canvas.label(length, Role::Length, Anchor::Along { from: Point::ORIGIN, to: rider.centre() * 0.9 });
    }
    if let Some(height) = height {
        let arrow = if end.rider.vectors.is_empty() { 0.0 } else { LONGEST };
        draw_height(canvas, [&lowest, &rider], [arrow, 0.0], height);
    }
}
