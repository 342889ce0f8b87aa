//! Two bodies on the ends of a string over a pulley: hanging, on a table, on slopes.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::body::{Attach, Body};
use crate::coil::{draw_cord, draw_support};
use crate::place::Canvas;
use crate::surface::draw_surface;
use crate::{Point, Role, Shape};
use momentous_expr::Math;

use super::angle::{AngleMark, Vertex, draw_angle, wedge};
use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 46.0;
/// The wheel where both bodies hang, wide enough to keep them apart, and elsewhere.
const WIDE_WHEEL: f64 = 27.0;
const SMALL_WHEEL: f64 = 12.0;
const HUB: f64 = 1.8;
/// From the wheel to a body that hangs or slides; of two that hang, the first hangs lower.
const HANGING: f64 = 74.0;
const LOWER: f64 = 24.0;
const SLIDING: f64 = 76.0;
/// Between bodies that hang side by side.
const GAP: f64 = 8.0;
const CEILING: f64 = 20.0;
const CEILING_HALF: f64 = 24.0;
/// From the wheel to the edge of its table, and from a body to the far end of its floor.
const EDGE: f64 = 4.0;
const OVERHANG: f64 = 30.0;
/// From the foot of a slope to beyond the arc of its angle, with the label.
const ANGLE_ROOM: f64 = 50.0;
/// From the arc of an angle to the upright through the top of its slope, with the radius of the arc.
const STEEP_ROOM: f64 = 32.0;
/// The wheel of a movable pulley, and from its centre to the body.
const MOVABLE_WHEEL: f64 = 13.0;
const HOOK: f64 = 7.0;
const FIXED_END: f64 = 9.0;
/// The distance that the side of a table goes down.
const TABLE: f64 = 64.0;

/// Two bodies on a string over a pulley.
#[derive(Clone, Debug, PartialEq)]
pub struct Pulley {
    /// The body to the left and the one to the right.
    pub sides: [PulleySide; 2],
}

/// One end of the string.
#[derive(Clone, Debug, PartialEq)]
pub struct PulleySide {
    /// The body with its vectors.
    pub body: MovingBody,
    /// On what it lies.
    pub rest: Rest,
    /// On how many strands of the string it hangs.
    pub strands: u8,
}

/// On what a body on a string lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Rest {
    /// It hangs.
    Hanging,
    /// A level table.
    Level,
    /// A slope that rises to the pulley at an angle in radians, with what is written at that angle.
    Slope(f64, Option<Math>),
}

impl Rest {
    /// The direction from the pulley to the body, for the body on the right.
    #[must_use]
    pub fn angle(&self) -> f64 {
        match self {
            Self::Hanging => -FRAC_PI_2,
            Self::Level => 0.0,
            Self::Slope(angle, _) => -angle,
        }
    }
}

/// One side as it lies on the drawing.
struct Laid {
    /// From the pulley to the body.
    way: Point,
    /// Away from the floor; to the outer side, for a body that hangs.
    normal: Point,
    outline: Body,
    radius: f64,
    strands: u8,
}

impl Laid {
    /// A place on the floor at a distance from the wheel.
    fn floor(&self, distance: f64) -> Point {
        self.way * distance + self.normal * (self.radius - self.outline.support(self.normal))
    }
}

impl Pulley {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let hanging = self.sides.iter().all(|side| side.rest == Rest::Hanging);
        let radius = self.radius(hanging);
        let laid = [0, 1].map(|number| self.lay(number, radius, hanging));
        canvas.draw(Shape::Circle { centre: Point::ORIGIN, radius, role: Role::Length });
        canvas.draw(Shape::Circle { centre: Point::ORIGIN, radius: HUB, role: Role::Axis });
        let scales = Scales::of(self.sides.iter().map(|side| &side.body), LONGEST);
        for side in &laid {
            side.outline.draw(canvas);
            let end = side.outline.centre() - side.way * side.outline.reach(-side.way);
            match side.strands {
                0 | 1 => draw_cord(canvas, side.normal * radius, end),
                several => draw_tackle(canvas, side, several, end),
            }
        }
        self.draw_supports(canvas, &laid, radius, hanging);
        for (side, laid) in self.sides.iter().zip(&laid) {
            let mut outline = laid.outline.clone();
            for moving in &side.body.vectors {
                let to_pulley = scales.arrow(moving).is_some_and(|arrow| arrow.dot(laid.way) < 0.0);
                let attach = if to_pulley { Attach::Arriving } else { Attach::Leaving };
                draw_vector(canvas, &mut outline, moving, &scales, attach);
            }
        }
    }

    /// Large enough to keep what hangs apart from the other side.
    fn radius(&self, hanging: bool) -> f64 {
        let [left, right] = self.sides.each_ref().map(|side| {
            let half = side.body.outline().support(Point::new(1.0, 0.0));
            if side.rest == Rest::Hanging { half } else { 0.0 }
        });
        if hanging { WIDE_WHEEL.max(f64::midpoint(left, right) + GAP) } else { SMALL_WHEEL.max(left.max(right) - GAP) }
    }

    fn lay(&self, number: usize, radius: f64, hanging: bool) -> Laid {
        let side = &self.sides[number];
        let angle = if side.rest.angle().is_finite() { side.rest.angle() } else { 0.0 };
        // The left side is the mirror image of the right one.
        let mirror = if number == 0 { -1.0 } else { 1.0 };
        let mirrored = |point: Point| Point::new(mirror * point.x, point.y);
        let (way, normal) = (mirrored(Point::polar(1.0, angle)), mirrored(Point::polar(1.0, angle + FRAC_PI_2)));
        let turn = if side.rest == Rest::Hanging { 0.0 } else { mirror * angle };
        let outline = side.body.outline().turned(turn);
        let distance = match side.rest {
            Rest::Hanging if hanging && number == 0 => HANGING + LOWER,
            Rest::Hanging => HANGING,
            _ => SLIDING + radius - SMALL_WHEEL,
        };
        let movable = if side.strands < 2 { 0.0 } else { MOVABLE_WHEEL };
        let outline = outline.moved(normal * (radius + movable) + way * distance);
        Laid { way, normal, outline, radius, strands: side.strands }
    }

    /// The supports of the pulley: a ceiling, the edge of a table, the top of a slope.
    fn draw_supports(&self, canvas: &mut Canvas, laid: &[Laid; 2], radius: f64, hanging: bool) {
        if hanging {
            let top = Point::new(0.0, radius + CEILING);
            canvas.line([Point::ORIGIN, top], Role::Length, false);
            return draw_support(canvas, top, Point::new(0.0, -1.0), CEILING_HALF);
        }
        let mut edges = Vec::new();
        for (number, (side, laid)) in self.sides.iter().zip(laid).enumerate() {
            if side.rest == Rest::Hanging {
                continue;
            }
            let reach = SLIDING + radius - SMALL_WHEEL + laid.outline.support(laid.way) + OVERHANG;
            let reach = match &side.rest {
                Rest::Slope(angle, Some(_)) => reach.max(radius + EDGE + wedge(*angle) + ANGLE_ROOM),
                _ => reach,
            };
            let (edge, far) = (laid.floor(radius + EDGE), laid.floor(reach));
            let ends = if number == 0 { [far, edge] } else { [edge, far] };
            draw_surface(canvas, ends[0], ends[1]);
            canvas.line([Point::ORIGIN, edge], Role::Length, false);
            if let Rest::Slope(angle, Some(label)) = &side.rest {
                draw_slope(canvas, far, edge, *angle, label);
            }
            edges.push((number, edge));
        }
        // Beside a body that hangs, the table or the slope ends in an upright side.
        if let ([(number, edge)], Some(Rest::Level)) = (&edges[..], edges.first().map(|(at, _)| &self.sides[*at].rest))
        {
            let foot = *edge - Point::new(0.0, TABLE);
            let ends = if *number == 0 { [*edge, foot] } else { [foot, *edge] };
            draw_surface(canvas, ends[0], ends[1]);
        }
    }
}

/// A body on a movable pulley: one strand runs to the wheel above, the last to a fixed end, and any others between them.
fn draw_tackle(canvas: &mut Canvas, side: &Laid, strands: u8, hook: Point) {
    let centre = hook - side.way * (HOOK + MOVABLE_WHEEL);
    let top = side.radius + CEILING;
    canvas.draw(Shape::Circle { centre, radius: MOVABLE_WHEEL, role: Role::Length });
    canvas.draw(Shape::Circle { centre, radius: HUB, role: Role::Axis });
    canvas.line([centre, hook], Role::Length, false);
    draw_cord(canvas, side.normal * side.radius, centre - side.normal * MOVABLE_WHEEL);
    let foot = |strand: u8| {
        let share = 2.0 * f64::from(strand) / f64::from(strands - 1) - 1.0;
        centre + side.normal * (MOVABLE_WHEEL * share)
    };
    for foot in (1..strands).map(foot) {
        draw_cord(canvas, foot, Point::new(foot.x, top));
    }
    // All strands but the one from the wheel go up to one beam.
    let [nearest, fixed] = [1, strands - 1].map(|strand| foot(strand).x);
    let middle = Point::new(f64::midpoint(nearest, fixed), top);
    draw_support(canvas, middle, Point::new(0.0, -1.0), FIXED_END + (nearest - fixed).abs() / 2.0);
}

/// The level at the foot of a slope, and the angle between them.
fn draw_slope(canvas: &mut Canvas, foot: Point, top: Point, angle: f64, label: &Math) {
    let level = if top.x < foot.x { PI } else { 0.0 };
    let width = (top.x - foot.x).abs();
    let length = (wedge(angle) + ANGLE_ROOM).min(width);
    canvas.line([foot, foot + Point::polar(length, level)], Role::Guide, false);
    let mark = AngleMark { from: level, label: label.clone() };
    // On a steep slope the arc stays clear of what hangs behind it.
    let inner = wedge(angle).min((width - STEEP_ROOM).max(0.0));
    draw_angle(canvas, &[Vertex::open(foot, inner)], top - foot, &mark);
}
