//! A body that falls to the floor, and perhaps bounces: heights with dimension lines, the path dashed.

use crate::body::Attach;
use crate::coil::{draw_coil, draw_support};
use crate::place::Canvas;
use crate::surface::draw_surface;
use crate::{Point, Role};
use momentous_expr::Math;

use super::angle::draw_incline;
use super::dimension::draw_dimension;
use super::moving::{Moving, MovingBody, Scales, draw_vector};

/// The greatest height, and the least that can be seen.
const HIGHEST: f64 = 120.0;
const LOWEST: f64 = 3.0;
/// Width of a bounce as high as the fall.
const BOUNCE_WIDTH: f64 = 84.0;
const DIMENSION_GAP: f64 = 26.0;
const OVERHANG: f64 = 24.0;
const ARC_PARTS: u32 = 24;
/// Length of the spring under a body.
const SPRING: f64 = 44.0;
/// Half the length of the ground under a body.
const GROUND_HALF: f64 = 40.0;
/// Half the length of a slope.
const SLOPE_HALF: f64 = 70.0;

/// A fall.
#[derive(Clone, Debug, PartialEq)]
pub struct Fall {
    /// The body where it is let go, with its given velocity.
    pub body: MovingBody,
    /// The height of the fall, and then of each bounce that is to be shown.
    pub heights: Vec<Height>,
    /// The ground under the fall.
    pub ground: Ground,
    /// Its vectors where it arrives; none where it is not shown there.
    pub end: Option<Vec<Moving>>,
}

/// The ground under a fall.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Ground {
    /// A level floor.
    #[default]
    Level,
    /// A slope that rises to the right at an angle in radians, with what is written at that angle.
    Slope(f64, Option<Math>),
    /// Another body.
    Body(MovingBody),
    /// Another body, which a spring carries.
    Sprung(MovingBody),
    /// Nothing: something else ends the fall in the air.
    Air,
}

/// A height above the floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Height {
    /// The label at its dimension line; without it the height is not dimensioned.
    pub label: Option<Math>,
    /// Its value, in any one unit for all heights of the figure.
    pub value: f64,
}

impl Fall {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let mut body = self.body.outline();
        let down = Point::new(0.0, -1.0);
        let radius = body.support(down);
        let largest =
            self.heights.iter().map(|height| height.value).filter(|value| value.is_finite()).fold(0.0, f64::max);
        let drawn_height = |height: &Height| {
            let part = if largest > 0.0 { height.value / largest } else { 1.0 };
            if part.is_finite() { (part * HIGHEST).clamp(LOWEST, HIGHEST) } else { LOWEST }
        };
        let mut heights = self.heights.iter().map(|height| (drawn_height(height), height.label.as_ref()));
        let (fall, label) = heights.next().unwrap_or((HIGHEST, None));
        // Heights are those of the lowest point of the body.
        body = body.moved(Point::new(0.0, fall + radius));
        body.draw(canvas);
        let arriving = MovingBody { vectors: self.end.iter().flatten().cloned().collect(), ..self.body.clone() };
        let scales = Scales::of([&self.body, &arriving], HIGHEST / 3.0);
        for moving in &self.body.vectors {
            draw_vector(canvas, &mut body, moving, &scales, Attach::Leaving);
        }
        let mut foot = Point::ORIGIN;
        if self.end.is_some() {
            let mut end = arriving.outline().moved(Point::new(0.0, radius));
            end.draw(canvas);
            foot.y += 2.0 * radius;
            for moving in &arriving.vectors {
                draw_vector(canvas, &mut end, moving, &scales, Attach::Arriving);
            }
        }
        canvas.line([Point::new(0.0, fall), foot], Role::Path, true);
        dimension(canvas, Point::new(-radius - DIMENSION_GAP, fall), Some(-4.0), label);
        let mut x = 0.0;
        for (height, label) in heights {
            let width = BOUNCE_WIDTH * (height / HIGHEST).sqrt();
            canvas.line(parabola(x, width, height), Role::Path, true);
            let apex = Point::new(x + width / 2.0, height);
            dimension(canvas, apex, None, label);
            x += width;
        }
        let left = -radius - DIMENSION_GAP;
        self.ground.draw(canvas, [left, x.max(radius)]);
    }
}

impl Ground {
    /// Under what reaches from the dimension line at `left` to `right`; the fall ends at the origin.
    fn draw(&self, canvas: &mut Canvas, [left, right]: [f64; 2]) {
        match self {
            Self::Level => {
                draw_surface(canvas, Point::new(left - OVERHANG, 0.0), Point::new(right + OVERHANG, 0.0));
            }
            Self::Slope(angle, label) => {
                let along = Point::polar(SLOPE_HALF, if angle.is_finite() { *angle } else { 0.0 });
                draw_surface(canvas, -along, along);
                // The foot of the height's dimension line hangs in the air beside the slope.
                draw_level(canvas, left, -4.0);
                if let Some(label) = label {
                    let foot = if along.y < 0.0 { along } else { -along };
                    draw_incline(canvas, [foot, -foot], label);
                }
            }
            Self::Air => draw_level(canvas, left, 4.0),
            Self::Body(body) | Self::Sprung(body) => {
                let outline = body.outline();
                let mut outline = outline.clone().moved(Point::new(0.0, -outline.support(Point::new(0.0, 1.0))));
                outline.draw(canvas);
                for moving in &body.vectors {
                    draw_vector(canvas, &mut outline, moving, &Scales::of([body], HIGHEST / 3.0), Attach::Leaving);
                }
                let up = Point::new(0.0, 1.0);
                let foot = outline.centre() - up * outline.support(up);
                if matches!(self, Self::Sprung(_)) {
                    draw_coil(canvas, foot, foot - up * SPRING);
                    draw_support(canvas, foot - up * SPRING, up, OVERHANG);
                } else if body.vectors.iter().all(|moving| moving.vector.vector() == Some(Point::ORIGIN)) {
                    // What nothing holds stands on the ground.
                    draw_support(canvas, foot, up, GROUND_HALF);
                }
                let edge = outline.reach(Point::new(1.0, 0.0));
                draw_level(canvas, left, -edge);
            }
        }
    }
}

fn parabola(start: f64, width: f64, height: f64) -> impl Iterator<Item = Point> {
    (0..=ARC_PARTS).map(move |part| {
        let part = f64::from(part) / f64::from(ARC_PARTS);
        Point::new(start + width * part, 4.0 * height * part * (1.0 - part))
    })
}

/// A guide at the level where the fall ends, from the dimension line at `left`.
fn draw_level(canvas: &mut Canvas, left: f64, to: f64) {
    canvas.line([Point::new(left - 4.0, 0.0), Point::new(to, 0.0)], Role::Guide, false);
}

/// The height of `top` above the floor, and a guide from it to what is that high.
fn dimension(canvas: &mut Canvas, top: Point, guide_to: Option<f64>, label: Option<&Math>) {
    let Some(label) = label else { return };
    if let Some(end) = guide_to {
        canvas.line([Point::new(top.x - 4.0, top.y), Point::new(end, top.y)], Role::Guide, false);
    }
    draw_dimension(canvas, Point::new(top.x, 0.0), top, label);
}
