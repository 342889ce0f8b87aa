//! A body on a cord, at the two ends of its swing.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::body::{Attach, Body};
use crate::coil::{draw_cord, draw_support};
use crate::place::{Anchor, Canvas};
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::dimension::draw_dimension;
use super::moving::{Moving, MovingBody, Scales, draw_vector};

pub(super) const CORD: f64 = 112.0;
const LONGEST: f64 = 52.0;
const CEILING_HALF: f64 = 26.0;
const PIVOT: f64 = 1.8;
/// Beyond this angle a ceiling would be in the way of the body.
const STEEPEST_UNDER_CEILING: f64 = 1.2;
/// Angles less far from the vertical, or from each other, are drawn so, to keep the places apart.
const SMALLEST: f64 = 0.4;
/// The largest angle that has a side on which its arc lies: a half turn but for what nobody sees.
const LARGEST: f64 = PI - 0.025;
/// From the pivot to the arc of the first angle; the second lies further out.
const ARC_ROOM: f64 = 12.0;
const NEXT_ARC: f64 = 18.0;
const DIMENSION_GAP: f64 = 24.0;
const PATH_PARTS: u32 = 24;
const TRACK_PARTS: u32 = 96;
/// The distance that a track goes on beyond the places that are shown.
const BEYOND: f64 = 0.2;
/// From a place on the level end of a track to what stands there, and to the end.
const LEVEL: f64 = 14.0;

/// A swing.
#[derive(Clone, Debug, PartialEq)]
pub struct Swing {
    /// The body; its vectors are those of the ends.
    pub body: MovingBody,
    /// The places that are shown.
    pub ends: Vec<SwingEnd>,
    /// The label at the cord.
    pub length: Option<Math>,
    /// The label at the height between the two places.
    pub height: Option<Math>,
    /// The hold on the body.
    pub by: SwingBy,
}

/// The hold on a body that swings.
#[derive(Clone, Debug, PartialEq)]
pub enum SwingBy {
    /// A cord.
    Cord,
    /// A cord, and another body that hangs on one as long beside the lowest place.
    CordBeside(MovingBody),
    /// A circular track.
    Track,
    /// A circular track that ends level at its lowest point, and a body that stands there.
    LevelTrack(Option<MovingBody>),
}

/// A place of a body on a cord.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingEnd {
    /// The angle of the cord from straight down, in radians, counter-clockwise.
    pub angle: f64,
    /// The label at that angle.
    pub label: Option<Math>,
    /// The body's vectors there.
    pub vectors: Vec<Moving>,
}

impl Swing {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angles = self.drawn_angles();
        let beside = self.beside(&angles);
        let shown: Vec<MovingBody> =
            self.ends.iter().map(|end| MovingBody { vectors: end.vectors.clone(), ..self.body.clone() }).collect();
        let scales = Scales::of(&shown, LONGEST);
        let mut outlines: Vec<Body> =
            angles.iter().map(|angle| self.outline(*angle).moved(Point::polar(CORD, *angle - FRAC_PI_2))).collect();
        if self.on_track() {
            // All stand on one track, however high they are.
            let outward = |body: &Body| Point::polar(1.0, body.centre().angle());
            let depth = outlines.iter().map(|body| body.support(outward(body))).fold(0.0, f64::max);
            let lowered = outlines.iter().map(|body| outward(body) * (CORD + depth - body.support(outward(body))));
            let lowered: Vec<Point> = lowered.collect();
            outlines = outlines.into_iter().zip(lowered).map(|(body, at)| body.moved(at)).collect();
            self.draw_track(canvas, &angles, &outlines, depth);
        } else {
            draw_pivot(canvas, &angles, beside.as_ref().map(|(_, outline)| outline.centre().x));
        }
        if let Some((_, outline)) = &beside {
            outline.draw(canvas);
            let up = Point::new(0.0, 1.0);
            draw_cord(canvas, outline.centre() + up * CORD, outline.centre() + up * outline.support(up));
        }
        for outline in &outlines {
            outline.draw(canvas);
            if self.on_track() {
                continue;
            }
            let inward = outline.centre() * (-1.0 / CORD);
            let end = outline.centre() + inward * outline.reach(inward);
            draw_cord(canvas, Point::ORIGIN, end);
        }
        if let ([one, other], [first, second]) = (&angles[..], &outlines[..]) {
            draw_path(canvas, [*one, *other], [first, second]);
        }
        self.mark_angles(canvas, &angles);
        for (number, (end, mut outline)) in shown.iter().zip(outlines.iter().cloned()).enumerate() {
            let other = outlines.get(1 - number.min(1)).map(|other| other.centre() - outline.centre());
            for moving in &end.vectors {
                // The place of the other end is in the way of an arrow towards it.
                let arrow = scales.arrow(moving).unwrap_or_default();
                let arrives = other.is_some_and(|other| other.dot(arrow) > 0.0);
                let attach = if arrives { Attach::Arriving } else { Attach::Leaving };
                draw_vector(canvas, &mut outline, moving, &scales, attach);
            }
        }
        if let Some((body, mut outline)) = beside {
            for moving in &body.vectors {
                draw_vector(canvas, &mut outline, moving, &scales, Attach::Leaving);
            }
        }
        if let (Some(length), Some(outline)) = (&self.length, outlines.first()) {
            canvas.label(length, Role::Length, Anchor::Along { from: Point::ORIGIN, to: outline.centre() * 0.9 });
        }
        if let (Some(height), [first, second]) = (&self.height, &outlines[..]) {
            let gap = if self.ends.iter().any(|end| !end.vectors.is_empty()) { LONGEST } else { 0.0 };
            // Beside the whole of a track, and of a path that leads round its side.
            let is_wide = self.on_track() || angles.iter().any(|angle| angle.abs() > FRAC_PI_2);
            let least = if is_wide { CORD + DIMENSION_GAP } else { 0.0 };
            draw_height(canvas, [first, second], [gap, least], height);
        }
    }

    /// The body, turned to stand on a track.
    fn outline(&self, angle: f64) -> Body {
        let outline = self.body.outline();
        if self.on_track() { outline.turned(angle) } else { outline }
    }

    /// The part of the circle on which the body slides, its centre, and the radius to each place that is told.
    fn draw_track(&self, canvas: &mut Canvas, angles: &[f64], outlines: &[Body], depth: f64) {
        let far = |pick: fn(f64, f64) -> f64| angles.iter().copied().fold(0.0, pick);
        let (low, high) = (far(f64::min) - BEYOND, far(f64::max) + BEYOND);
        let is_level = matches!(self.by, SwingBy::LevelTrack(_));
        let (low, high) = match (high.max(-low) > FRAC_PI_2 + 2.0 * BEYOND, is_level, -low > high) {
            (true, false, _) => (-PI, PI),
            (_, true, true) => (low, 0.0),
            (_, true, false) => (0.0, high),
            (false, false, _) => (low, high),
        };
        let part = |number: u32| low + (high - low) * f64::from(number) / f64::from(TRACK_PARTS);
        let track = (0..=TRACK_PARTS).map(|number| Point::polar(CORD + depth, part(number) - FRAC_PI_2));
        canvas.line(track, Role::Surface, false);
        if let SwingBy::LevelTrack(beyond) = &self.by {
            self.draw_level(canvas, if high > 0.0 { -1.0 } else { 1.0 }, CORD + depth, beyond.as_ref());
        }
        canvas.draw(Shape::Circle { centre: Point::ORIGIN, radius: PIVOT, role: Role::Axis });
        for (outline, end) in outlines.iter().zip(&self.ends) {
            if self.length.is_some() || end.label.is_some() {
                let inward = -Point::polar(1.0, outline.centre().angle());
                canvas.line([Point::ORIGIN, outline.centre() + inward * outline.reach(inward)], Role::Guide, true);
            }
        }
    }

    /// The level end of a track to one side of its lowest point, and what stands there beyond the place of the body.
    fn draw_level(&self, canvas: &mut Canvas, side: f64, depth: f64, beyond: Option<&MovingBody>) {
        let (across, foot) = (Point::new(side, 0.0), Point::new(0.0, -depth));
        let mut reach = self.outline(0.0).support(across) + LEVEL;
        if let Some(body) = beyond {
            let outline = body.outline();
            let half = outline.support(across);
            let up = Point::new(0.0, outline.support(Point::new(0.0, 1.0)));
            outline.moved(foot + across * (reach + half) + up).draw(canvas);
            reach += 2.0 * half + LEVEL;
        }
        canvas.line([foot, foot + across * reach], Role::Surface, false);
    }

    fn on_track(&self) -> bool {
        matches!(self.by, SwingBy::Track | SwingBy::LevelTrack(_))
    }

    /// The body that hangs beside the lowest place, touched by one that comes from the other side.
    fn beside(&self, angles: &[f64]) -> Option<(&MovingBody, Body)> {
        let SwingBy::CordBeside(body) = &self.by else { return None };
        let side = if angles.first().is_some_and(|angle| *angle > 0.0) { -1.0 } else { 1.0 };
        let across = Point::new(side, 0.0);
        let apart = self.body.outline().support(across) + body.outline().support(across);
        Some((body, body.outline().moved(across * apart + Point::new(0.0, -CORD))))
    }

    /// The angles, far enough apart to be distinguished.
    fn drawn_angles(&self) -> Vec<f64> {
        let mut drawn: Vec<f64> = Vec::new();
        let largest = if self.on_track() { PI } else { LARGEST };
        for end in &self.ends {
            let angle = if end.angle.is_finite() { end.angle.clamp(-largest, largest) } else { 0.0 };
            let angle = if angle == 0.0 { 0.0 } else { angle.abs().max(SMALLEST).copysign(angle) };
            let angle = match drawn.first() {
                Some(first) if (angle - first).abs() < SMALLEST => first + SMALLEST.copysign(angle - first),
                _ => angle,
            };
            drawn.push(angle);
        }
        drawn
    }

    fn mark_angles(&self, canvas: &mut Canvas, angles: &[f64]) {
        let mut inner = ARC_ROOM;
        let mut marked: Vec<(&SwingEnd, f64)> = self.ends.iter().zip(angles.iter().copied()).collect();
        marked.sort_by(|(_, one), (_, other)| one.abs().total_cmp(&other.abs()));
        let mut taken = 0.0;
        for (end, angle) in marked {
            let Some(label) = &end.label else { continue };
            let mark = AngleMark { from: -FRAC_PI_2, label: label.clone() };
            let direction = Point::polar(1.0, angle - FRAC_PI_2);
            draw_angle(canvas, &[Vertex::open(Point::ORIGIN, inner).beyond(taken)], direction, &mark);
            inner += NEXT_ARC;
            taken = angle.abs();
        }
    }
}

/// A ceiling, or a pin where the body goes up beside it; the same for a cord that far beside, where there is one.
fn draw_pivot(canvas: &mut Canvas, angles: &[f64], beside: Option<f64>) {
    if angles.iter().all(|angle| angle.abs() < STEEPEST_UNDER_CEILING) {
        let (middle, half) = beside.map_or((0.0, CEILING_HALF), |x| (x / 2.0, CEILING_HALF + x.abs() / 2.0));
        return draw_support(canvas, Point::new(middle, 0.0), Point::new(0.0, -1.0), half);
    }
    for x in [0.0].into_iter().chain(beside) {
        canvas.draw(Shape::Circle { centre: Point::new(x, 0.0), radius: PIVOT, role: Role::Axis });
    }
}

/// Dashed, from one body to the other.
pub(super) fn draw_path(canvas: &mut Canvas, [from, to]: [f64; 2], [first, second]: [&Body; 2]) {
    let hidden = |body: &Body, angle: f64| 1.15 * body.reach(Point::polar(1.0, angle)) / CORD;
    let way = (to - from).signum();
    let (start, end) = (from + way * hidden(first, from), to - way * hidden(second, to));
    if (end - start) * way > 0.0 {
        let part = |part: u32| start + (end - start) * f64::from(part) / f64::from(PATH_PARTS);
        canvas.line((0..=PATH_PARTS).map(|number| Point::polar(CORD, part(number) - FRAC_PI_2)), Role::Path, true);
    }
}

/// Between the levels of the two places, beside the outer one and its arrow, and at least so far from the middle.
pub(super) fn draw_height(canvas: &mut Canvas, bodies: [&Body; 2], [arrow, least]: [f64; 2], label: &Math) {
    let (down, half) = (Point::new(0.0, -1.0), bodies[0].support(Point::new(1.0, 0.0)));
    let places = bodies.map(|body| body.centre() + down * body.support(down));
    let [low, high] = if places[0].y <= places[1].y { places } else { [places[1], places[0]] };
    let side = if high.x < low.x { -1.0 } else { 1.0 };
    let gap = if arrow > 0.0 { arrow + DIMENSION_GAP / 2.0 } else { DIMENSION_GAP };
    let outer = ((high.x * side).max(low.x * side) + half + gap).max(least + half);
    let x = side * outer;
    for place in [low, high] {
        canvas.line(
            [Point::new(place.x + side * (half + 2.0), place.y), Point::new(x + side * 4.0, place.y)],
            Role::Guide,
            false,
        );
    }
    draw_dimension(canvas, Point::new(x, low.y), Point::new(x, high.y), label);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swing(angles: [f64; 2]) -> Swing {
        let end = |angle| SwingEnd { angle, label: None, vectors: Vec::new() };
        let body = MovingBody::new(Math::Identifier("A".into()));
        Swing { body, ends: angles.map(end).to_vec(), length: None, height: None, by: SwingBy::Cord }
    }

    #[test]
    fn small_angles_are_drawn_large_enough_to_be_seen() {
        assert_eq!(swing([0.0, 0.05]).drawn_angles(), [0.0, SMALLEST]);
        assert_eq!(swing([-0.6, -0.5]).drawn_angles(), [-0.6, -0.6 + SMALLEST]);
        assert_eq!(swing([PI / 4.0, 0.0]).drawn_angles(), [PI / 4.0, 0.0]);
    }
}
