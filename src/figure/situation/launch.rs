//! A body that begins a free flight, and what the flight leads to. The path is a sketch: how far it leads is asked.

use crate::body::{Attach, Body};
use crate::place::Canvas;
use crate::surface::draw_surface;
use crate::{Point, Role};
use momentous_expr::Math;

use super::angle::draw_incline;
use super::dimension::draw_dimension;
use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 44.0;
/// How far a path leads, and how high it rises at most.
const REACH: f64 = 170.0;
const PEAK: f64 = 96.0;
/// The length drawn for a height that lies below the start.
const DROP: f64 = 78.0;
/// How far a path in its true proportions leads down at most.
const LOWEST: f64 = 120.0;
/// The least width of a path in its true proportions: a narrower one comes down on its start.
const NARROWEST: f64 = 64.0;
/// By how much a path is shortened that would rise too high, and how often.
const SHORTER: f64 = 0.85;
const ATTEMPTS: i32 = 7;
/// A direction closer to the vertical has no path to the side.
const UPRIGHT: f64 = 0.05;
/// The height at which a path meets a wall, as a share of that without weight; and its bounds.
const MET: f64 = 0.35;
const MET_HIGHEST: f64 = 60.0;
const PARTS: u32 = 32;
const OVERHANG: f64 = 26.0;
const GAP: f64 = 16.0;

/// The start of a free flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Launch {
    /// The body where it starts, with its given velocity.
    pub body: MovingBody,
    /// The direction in which it starts, in radians; none where it is not given, and no path is drawn.
    pub direction: Option<f64>,
    /// The target of the flight.
    pub target: Target,
    /// A resistance in proportion to the speed.
    pub resisted: Option<Resisted>,
}

/// A flight against a resistance in proportion to the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resisted {
    /// The resistance divided by the speed, times the duration, divided by the mass.
    pub fading: f64,
    /// Its end, seen from its start; none in a sketch.
    pub end: Option<[f64; 2]>,
}

impl Resisted {
    /// How far it has come after a part of its time: without weight, and by its weight, each as a share of all.
    fn shares(self, part: f64) -> [f64; 2] {
        let faded = |time: f64| libm::expm1(-self.fading * time);
        [faded(part) / faded(1.0), (self.fading * part + faded(part)) / (self.fading + faded(1.0))]
    }

    /// How far the line in which it starts rises above a path that is level at its end, as a share of how far the line rises.
    fn above_top(self) -> f64 {
        let faded = libm::expm1(-self.fading);
        (self.fading + faded) * (1.0 + faded) / (faded * faded)
    }
}

/// The target of a flight.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// The top of its path.
    Top,
    /// Level ground.
    Ground(Depth),
    /// The slope on which it starts: the angle in radians at which it rises to the right, and what is written at it.
    Slope(f64, Option<Math>),
    /// An upright wall: what is written at its distance, and the ground before it.
    Wall(Option<Math>, Option<Depth>),
}

/// How far below the start the ground is.
#[derive(Clone, Debug, PartialEq)]
pub enum Depth {
    /// It starts on the ground.
    Nothing,
    /// Below it, with what is written at the height.
    Below(Option<Math>),
}

impl Depth {
    fn drawn(&self) -> f64 {
        if *self == Self::Nothing { 0.0 } else { DROP }
    }
}

impl Launch {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let mut body = self.body.outline();
        let path = self
            .direction
            .filter(|angle| angle.is_finite())
            .map_or_else(Vec::new, |angle| self.to_scale(angle).unwrap_or_else(|| self.path(angle)));
        let clear = path.iter().position(|point| point.length() > body.reach(*point)).unwrap_or(path.len());
        body.draw(canvas);
        canvas.line(path.iter().skip(clear).copied(), Role::Path, true);
        let end = path.last().copied().unwrap_or(Point::new(REACH / 2.0, 0.0));
        let radius = body.support(Point::new(0.0, -1.0));
        match &self.target {
            Target::Top => {}
            Target::Ground(depth) => {
                let is_true = self.resisted.is_some_and(|resisted| resisted.end.is_some());
                let drawn = if is_true { -end.y } else { depth.drawn() };
                draw_ground(canvas, (depth, drawn), radius, [0.0, end.x]);
            }
            Target::Slope(rise, label) => draw_slope(canvas, &body, (*rise, label.as_ref()), end),
            Target::Wall(distance, depth) => draw_wall(canvas, &body, (distance.as_ref(), depth.as_ref()), end),
        }
        let scales = Scales::of([&self.body], LONGEST);
        for moving in &self.body.vectors {
            draw_vector(canvas, &mut body, moving, &scales, Attach::Leaving);
        }
    }

    /// The path of the centre, from the origin, for a start in that direction.
    fn path(&self, angle: f64) -> Vec<Point> {
        let direction = Point::polar(1.0, angle);
        let side = if direction.x < 0.0 { -1.0 } else { 1.0 };
        if direction.x.abs() < UPRIGHT {
            let end = match &self.target {
                Target::Ground(_) | Target::Top if direction.y > 0.0 => PEAK * 0.7,
                Target::Ground(depth) => -depth.drawn(),
                Target::Top | Target::Slope(..) | Target::Wall(..) => return Vec::new(),
            };
            return along(|part| Point::new(0.0, end * part));
        }
        let steep = direction.y / direction.x.abs();
        // Over a reach of 1 it falls by `fall` below the line in which it starts.
        let fitting = |reach: &f64| {
            let fall = match &self.target {
                Target::Top => reach * steep * self.resisted.map_or(0.5, Resisted::above_top),
                Target::Ground(depth) => reach * steep + depth.drawn(),
                Target::Slope(rise, _) => reach * (steep - side * libm::tan(*rise)),
                Target::Wall(_, depth) => {
                    let lowest = -0.6 * depth.as_ref().map_or(DROP, Depth::drawn);
                    reach * steep - (MET * reach * steep).clamp(lowest, MET_HIGHEST)
                }
            };
            let rises = steep.max(0.0) * reach;
            let fits = match self.resisted {
                None => rises * rises <= 4.0 * PEAK * fall,
                Some(_) => self.curve(side, *reach, [steep, fall]).iter().all(|point| point.y <= PEAK),
            };
            (fall > 0.0 && fits).then_some((*reach, fall))
        };
        let reaches = (0..ATTEMPTS).map(|attempt| REACH * SHORTER.powi(attempt));
        let Some((reach, fall)) = reaches.into_iter().find_map(|reach| fitting(&reach)) else { return Vec::new() };
        self.curve(side, reach, [steep, fall])
    }

    /// The path over a reach, which falls below the line in which it starts.
    fn curve(&self, side: f64, reach: f64, [steep, fall]: [f64; 2]) -> Vec<Point> {
        along(|part| match self.resisted {
            None => Point::new(side * reach * part, reach * steep * part - fall * part * part),
            Some(resisted) => {
                let [gone, fallen] = resisted.shares(part);
                Point::new(side * reach * gone, reach * steep * gone - fall * fallen)
            }
        })
    }

    /// The path to where it ends, in its true proportions.
    fn to_scale(&self, angle: f64) -> Option<Vec<Point>> {
        let [x, y] = self.resisted?.end?;
        let (reach, steep) = (x.abs(), libm::tan(angle) * x.signum());
        let path = self.curve(x.signum(), reach, [steep, reach * steep - y]);
        let least = |size: fn(&Point) -> f64| path.iter().map(size).fold(0.0, f64::max);
        let scale = [REACH / reach, PEAK / least(|point| point.y), LOWEST / least(|point| -point.y)];
        let scale = scale.into_iter().fold(f64::INFINITY, f64::min);
        let is_drawn = scale.is_finite()
            && reach * scale >= NARROWEST
            && path.iter().all(|point| point.x.is_finite() && point.y.is_finite());
        is_drawn.then(|| path.into_iter().map(|point| point * scale).collect())
    }
}

/// A curve from its part 0 to its part 1.
fn along(at: impl Fn(f64) -> Point) -> Vec<Point> {
    (0..=PARTS).map(|part| at(f64::from(part) / f64::from(PARTS))).collect()
}

/// Level ground under what reaches from one place to the other, with its depth under a body of that radius.
fn draw_ground(canvas: &mut Canvas, (depth, drawn): (&Depth, f64), radius: f64, [from, to]: [f64; 2]) {
    let level = -radius - drawn;
    let (left, right) = (from.min(to) - OVERHANG, from.max(to) + OVERHANG);
    draw_surface(canvas, Point::new(left, level), Point::new(right, level));
    if let Depth::Below(Some(label)) = depth {
        // On the side to which the body does not fly.
        let away = if to < from { 1.0 } else { -1.0 };
        let x = from + away * GAP;
        canvas.line([Point::new(x + away * 4.0, -radius), Point::new(from, -radius)], Role::Guide, false);
        draw_dimension(canvas, Point::new(x, level), Point::new(x, -radius), label);
    }
}

fn draw_slope(canvas: &mut Canvas, body: &Body, (rise, label): (f64, Option<&Math>), end: Point) {
    let along = Point::polar(1.0, rise);
    let foot = along.turned() * -body.support(-along.turned());
    let reach = end.dot(along);
    let [left, right] = [reach.min(0.0) - OVERHANG, reach.max(0.0) + OVERHANG].map(|distance| foot + along * distance);
    draw_surface(canvas, left, right);
    if let Some(label) = label {
        let [low, high] = if along.y < 0.0 { [right, left] } else { [left, right] };
        draw_incline(canvas, [low, high], label);
    }
}

fn draw_wall(canvas: &mut Canvas, body: &Body, (distance, depth): (Option<&Math>, Option<&Depth>), end: Point) {
    let side = if end.x < 0.0 { -1.0 } else { 1.0 };
    let radius = body.support(Point::new(0.0, -1.0));
    let wall = end.x + side * body.support(Point::new(side, 0.0));
    let level = -radius - depth.map_or(DROP / 2.0, Depth::drawn);
    let mut ends = [Point::new(wall, level), Point::new(wall, end.y + OVERHANG)];
    if side < 0.0 {
        ends.reverse();
    }
    draw_surface(canvas, ends[0], ends[1]);
    if let Some(depth) = depth {
        // The wall ends the ground on its side.
        let beyond = wall - side * OVERHANG;
        draw_ground(canvas, (depth, depth.drawn()), radius, [0.0, beyond]);
    }
    if let Some(distance) = distance {
        let y = level - GAP;
        canvas.line([Point::new(0.0, -radius), Point::new(0.0, y - 4.0)], Role::Guide, true);
        draw_dimension(canvas, Point::new(0.0, y), Point::new(wall, y), distance);
    }
}
