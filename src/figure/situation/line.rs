//! Bodies apart from each other along a straight line: a track, a slope, a vertical.

use std::f64::consts::PI;

use crate::body::{Attach, Body};
use crate::coil::{draw_coil, draw_cord, draw_slack, draw_support};
use crate::extent::Measure;
use crate::place::{Anchor, Canvas};
use crate::surface::draw_surface;
use crate::{Point, Role};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle, wedge};
use super::moving::{Moving, MovingBody, Scales, draw_vector};

const LONGEST: f64 = 58.0;
const GAP: f64 = 22.0;
const OVERHANG: f64 = 18.0;
/// Bodies on a slope leave room for its angle.
const SLOPE_OVERHANG: f64 = 34.0;
const SPRING: f64 = 62.0;
/// Half the height of the wall that holds a spring, and its height above a floor.
const WALL_HALF: f64 = 22.0;
/// From the last body to a wall, and between bodies on a slack cord.
const WALL_GAP: f64 = 46.0;
const TIED_GAP: f64 = 44.0;
const CORD: f64 = 64.0;
const CEILING_HALF: f64 = 26.0;
/// How far grains fall, how many rows and columns are drawn of them, and how far apart these are.
const GRAINS: f64 = 30.0;
const ROWS: u32 = 4;
const COLUMNS: [f64; 3] = [-5.0, 0.0, 5.0];
/// Throat and mouth of a nozzle: how far from the body, and half its width there; and how far its jet is drawn.
const NOZZLE: [Point; 2] = [Point { x: 0.0, y: 2.5 }, Point { x: 7.0, y: 5.5 }];
const JET: f64 = 36.0;

/// Bodies along a line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// Its angle in radians, from which the bodies follow each other: 0 from left to right.
    pub angle: f64,
    /// The bodies in their order.
    pub bodies: Vec<MovingBody>,
    /// Whether they rest on a hatched floor parallel to the line.
    pub floor: bool,
    /// The slope's angle against the level, marked at its foot.
    pub slope: Option<Math>,
    /// A spring along the line, and what is written at it.
    pub spring: Option<(LineSpring, Option<Math>)>,
    /// Which of the bodies hangs on a cord from above.
    pub hung: Option<usize>,
    /// The ties of bodies to the next one, by the position of the one behind.
    pub tied: Vec<(usize, Tie)>,
    /// A fixed wall beyond the last body.
    pub wall: bool,
    /// Mass that falls onto a body, or out of it.
    pub grains: Option<Grains>,
    /// The jet that drives the first body.
    pub exhaust: Option<Exhaust>,
}

/// Matter that a body throws out through a nozzle.
#[derive(Clone, Debug, PartialEq)]
pub struct Exhaust {
    /// Whether it leaves along the line rather than against it.
    pub ahead: bool,
    /// Its label.
    pub label: Option<Math>,
}

/// Mass that falls onto a body from above, or out of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Grains {
    /// Which body, by its position.
    pub body: usize,
    /// Whether they join it.
    pub join: bool,
    /// Their label.
    pub label: Option<Math>,
}

/// The ties between bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tie {
    /// A cord that is still slack.
    Slack,
    /// A coupling, or a cord that is taut.
    Firm,
}

/// The place of a spring along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineSpring {
    /// From the last body to a wall.
    Ahead,
    /// From a wall to the first body.
    Behind,
    /// Between the first body and the next.
    Between,
}

/// How a line lies on the drawing.
struct Frame {
    along: Point,
    up: Point,
}

impl Line {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let angle = if self.angle.is_finite() { self.angle } else { 0.0 };
        let along = Point::polar(1.0, angle);
        let up = if along.turned().y < -1e-9 { -along.turned() } else { along.turned() };
        let frame = Frame { along, up };
        let scales = Scales::of(&self.bodies, LONGEST);
        let outlines: Vec<Body> = self.bodies.iter().map(|body| body.outline().turned(angle)).collect();
        let floor = outlines.iter().map(|body| body.support(up)).fold(0.0, f64::max);
        let mut end = 0.0;
        let mut placed: Vec<(usize, Body)> = Vec::new();
        for (number, (body, outline)) in self.bodies.iter().zip(outlines).enumerate() {
            let (low, high) = self.reach_along(number, body, &outline, &scales, &frame);
            // On a floor all stand on it; else their centres are in line.
            let height = if self.floor { outline.support(up) - floor } else { 0.0 };
            let outline = outline.moved(along * (end - low) + up * height);
            outline.draw(canvas);
            placed.push((number, outline));
            let between = number == 0 && self.lies(LineSpring::Between);
            end += high - low
                + match between {
                    true => SPRING,
                    false if self.tied.iter().any(|(behind, _)| *behind == number) => TIED_GAP,
                    false => GAP,
                };
        }
        let mut ends = [-OVERHANG, end - GAP + if self.wall { WALL_GAP } else { OVERHANG }];
        if let (Some((_, first)), Some((_, last))) = (placed.first(), placed.last()) {
            self.draw_spring(canvas, &placed, &frame, floor);
            let reach = |body: &Body, side: f64| body.centre().dot(along) + side * (body.support(along) + SPRING);
            ends[0] = if self.lies(LineSpring::Behind) { reach(first, -1.0) } else { ends[0] };
            ends[1] = if self.lies(LineSpring::Ahead) { reach(last, 1.0) } else { ends[1] };
        }
        if self.slope.is_some() {
            let lower = usize::from(along.y < 0.0);
            ends[lower] += if lower == 0 { -SLOPE_OVERHANG } else { SLOPE_OVERHANG };
        }
        self.draw_cords(canvas, &placed, &frame);
        self.draw_grains(canvas, &placed, &frame);
        if let (Some(exhaust), Some((_, first))) = (&self.exhaust, placed.first_mut()) {
            exhaust.draw(canvas, first, &frame);
        }
        // Angles look out for bodies, so all bodies come before the first vector.
        for (number, mut outline) in placed {
            for moving in self.bodies.get(number).map_or(&[][..], |body| &body.vectors) {
                let attach = self.attach(number, &scales, moving, &frame);
                draw_vector(canvas, &mut outline, moving, &scales, attach);
            }
        }
        if self.wall && !self.lies(LineSpring::Ahead) {
            let foot = if self.floor { -up * floor } else { -up * WALL_HALF };
            frame.draw_wall(canvas, along * ends[1] + foot, up * (2.0 * WALL_HALF), 1.0);
        }
        if self.floor {
            let [start, end] = ends.map(|end| along * end - up * floor);
            let ends = if along.turned().dot(up) > 0.0 { (start, end) } else { (end, start) };
            draw_surface(canvas, ends.0, ends.1);
            if let Some(label) = &self.slope {
                Self::draw_slope(canvas, start, end, label);
            }
        }
    }

    fn lies(&self, place: LineSpring) -> bool {
        self.spring.as_ref().is_some_and(|(stretched, _)| *stretched == place)
    }

    fn draw_spring(&self, canvas: &mut Canvas, placed: &[(usize, Body)], frame: &Frame, floor: f64) {
        let (Some((place, label)), along) = (&self.spring, frame.along) else { return };
        let face = |body: &Body, side: f64| body.centre() + along * (side * body.support(along));
        let ends = match (place, placed) {
            (LineSpring::Between, [(_, first), (_, second), ..]) => Some([face(first, 1.0), face(second, -1.0)]),
            (LineSpring::Ahead, [.., (_, last)]) => Some([face(last, 1.0), face(last, 1.0) + along * SPRING]),
            (LineSpring::Behind, [(_, first), ..]) => Some([face(first, -1.0), face(first, -1.0) - along * SPRING]),
            _ => None,
        };
        let Some([from, to]) = ends else { return };
        draw_coil(canvas, from, to);
        if let Some(label) = label {
            // Beside the turns, which are wider than a line.
            let aside = frame.up * 5.0;
            canvas.label(label, Role::Body, Anchor::Along { from: from + aside, to: to + aside });
        }
        if *place != LineSpring::Between {
            let foot = if self.floor { to.dot(frame.up) + floor } else { WALL_HALF };
            let side = if *place == LineSpring::Ahead { 1.0 } else { -1.0 };
            frame.draw_wall(canvas, to - frame.up * foot, frame.up * (foot + WALL_HALF), side);
        }
    }

    /// The cord on which a body hangs, and slack cords between bodies.
    fn draw_cords(&self, canvas: &mut Canvas, placed: &[(usize, Body)], frame: &Frame) {
        if let Some((_, body)) = self.hung.and_then(|number| placed.get(number)) {
            let up = Point::new(0.0, 1.0);
            let (top, hook) = (body.centre() + up * body.support(up), body.centre() + up * (body.support(up) + CORD));
            draw_cord(canvas, top, hook);
            draw_support(canvas, hook, -up, CEILING_HALF);
        }
        for (behind, tie) in &self.tied {
            let Some([(_, first), (_, second)]) = placed.get(*behind..behind.saturating_add(2)) else { continue };
            let face = |body: &Body, side: f64| body.centre() + frame.along * (side * body.support(frame.along));
            let [from, to] = [face(first, 1.0), face(second, -1.0)];
            match tie {
                Tie::Slack => draw_slack(canvas, from, to),
                Tie::Firm => draw_cord(canvas, from, to),
            }
        }
    }

    /// Short strokes in columns, every other column half a row lower; none where the line is seen from above.
    fn draw_grains(&self, canvas: &mut Canvas, placed: &[(usize, Body)], frame: &Frame) {
        let Some(grains) = self.grains.as_ref().filter(|_| frame.up.y > 1.0 - 1e-9) else { return };
        let Some((_, body)) = placed.get(grains.body) else { return };
        let half = body.support(frame.up);
        let top = body.centre() + frame.up * if grains.join { half + GRAINS } else { -half };
        let row = GRAINS / f64::from(ROWS);
        for (column, aside) in COLUMNS.into_iter().enumerate() {
            let lower = if column % 2 == 0 { 0.1 } else { 0.5 };
            for number in 0..ROWS {
                let from = top + frame.along * aside - frame.up * (row * (f64::from(number) + lower));
                canvas.line([from, from - frame.up * (0.4 * row)], Role::Path, false);
            }
        }
        if let Some(label) = &grains.label {
            let beside = top + frame.along * (COLUMNS[2] + 3.0);
            canvas.label(label, Role::Path, Anchor::Along { from: beside, to: beside - frame.up * GRAINS });
        }
    }

    /// The level line at the lower end of the slope, and the angle between them.
    fn draw_slope(canvas: &mut Canvas, start: Point, end: Point, label: &Math) {
        let (foot, top) = if start.y <= end.y { (start, end) } else { (end, start) };
        let level = if (top - foot).x < 0.0 { PI } else { 0.0 };
        let (width, height) = ((top - foot).x.abs(), (top - foot).y);
        canvas.line([foot, foot + Point::polar(width, level)], Role::Guide, false);
        let room = wedge(libm::atan2(height, width));
        let mark = AngleMark { from: level, label: label.clone() };
        draw_angle(canvas, &[Vertex::open(foot, room)], top - foot, &mark);
    }

    /// Forces that push a body down to its floor are drawn from above, and those that move it into a spring from behind.
    fn attach(&self, number: usize, scales: &Scales, moving: &Moving, frame: &Frame) -> Attach {
        let into = |side: Point| scales.arrow(moving).is_some_and(|arrow| arrow.dot(side) > 0.1 * arrow.length());
        let last = self.bodies.len().saturating_sub(1);
        let meets_spring = self.spring.as_ref().is_some_and(|(place, _)| match place {
            LineSpring::Ahead => number == last && into(frame.along),
            LineSpring::Behind => number == 0 && into(-frame.along),
            LineSpring::Between => number == 0 && into(frame.along) || number == 1 && into(-frame.along),
        });
        if meets_spring || self.floor && into(-frame.up) { Attach::Arriving } else { moving.attach }
    }

    /// How far the body and its arrows reach back and forth along the line.
    fn reach_along(
        &self,
        number: usize,
        body: &MovingBody,
        outline: &Body,
        scales: &Scales,
        frame: &Frame,
    ) -> (f64, f64) {
        let along = frame.along;
        let mut trial = outline.clone();
        let (mut low, mut high) = (-outline.support(along), outline.support(along));
        match self.exhaust.as_ref().filter(|_| number == 0).map(|exhaust| exhaust.ahead) {
            Some(true) => high += JET,
            Some(false) => low -= JET,
            None => {}
        }
        for moving in &body.vectors {
            if let Some(arrow) = scales.arrow(moving) {
                let (from, to) = trial.attach(arrow, self.attach(number, scales, moving, frame));
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

impl Exhaust {
    /// A nozzle at the face of the body, and strokes of gas that spread behind it; arrows on that side get a lane beside.
    fn draw(&self, canvas: &mut Canvas, body: &mut Body, frame: &Frame) {
        let out = if self.ahead { frame.along } else { -frame.along };
        let face = body.centre() + out * body.support(out);
        let at = |far: f64, aside: f64| face + out * far + frame.up * aside;
        let [throat, mouth] = NOZZLE;
        let rim = [at(0.0, throat.y), at(mouth.x, mouth.y), at(mouth.x, -mouth.y), at(0.0, -throat.y)];
        canvas.line(rim, Role::Body, false);
        for (number, aside) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
            for row in 0..ROWS {
                let near = mouth.x + 3.0 + 6.0 * (f64::from(row) + if number == 1 { 0.5 } else { 0.0 });
                let spread = |far: f64| aside * (mouth.y - 2.0) * (1.0 + far / JET);
                canvas.line([at(near, spread(near)), at(near + 3.0, spread(near + 3.0))], Role::Path, false);
            }
        }
        if let Some(label) = &self.label {
            let below = -2.0 * mouth.y;
            canvas.label(label, Role::Path, Anchor::Along { from: at(mouth.x, below), to: at(JET, below) });
        }
        body.occupy(out);
    }
}

impl Frame {
    /// A wall from its foot, with its free side back along the line (`side` 1) or forwards (-1).
    fn draw_wall(&self, canvas: &mut Canvas, foot: Point, height: Point, side: f64) {
        let upright = height.dot(self.along.turned()) * side > 0.0;
        let ends = if upright { [foot, foot + height] } else { [foot + height, foot] };
        draw_surface(canvas, ends[0], ends[1]);
    }
}
