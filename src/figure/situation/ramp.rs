//! A body on a smooth ramp of which only the height matters.

use std::f64::consts::PI;

use crate::body::{Attach, Body};
use crate::place::Canvas;
use crate::{Point, Role};
use momentous_expr::Math;

use super::dimension::draw_dimension;
use super::moving::{Moving, MovingBody, Scales, draw_vector};

const SIZE: Point = Point::new(120.0, 62.0);
/// The level pieces before and after the ramp.
const LEAD: f64 = 44.0;
const LONGEST: f64 = 46.0;
const PARTS: u32 = 24;
const HATCH: f64 = 5.0;
const DIMENSION_GAP: f64 = 12.0;

/// A ramp.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// The body; its vectors are those of the ends.
    pub body: MovingBody,
    /// The body's vectors at the top; none where it is not shown there.
    pub top: Option<Vec<Moving>>,
    /// The body's vectors at the foot; none where it is not shown there.
    pub foot: Option<Vec<Moving>>,
    /// Whether it falls to the right.
    pub rightwards: bool,
    /// The label at the height of the ramp.
    pub height: Option<Math>,
}

impl Ramp {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let side = if self.rightwards { 1.0 } else { -1.0 };
        let mirrored = |point: Point| Point::new(side * point.x, point.y);
        let surface = Self::surface();
        for place in &surface {
            canvas.line([*place, *place - Point::new(HATCH, HATCH)].map(mirrored), Role::Guide, false);
        }
        canvas.line(surface.into_iter().map(mirrored), Role::Surface, false);
        let up = Point::new(0.0, 1.0);
        let outline = self.body.outline();
        let places = [Point::new(-LEAD / 2.0, SIZE.y), Point::new(SIZE.x + LEAD / 2.0, 0.0)];
        let shown = [&self.top, &self.foot].map(Option::as_ref);
        let bodies: Vec<MovingBody> = shown
            .into_iter()
            .flatten()
            .map(|vectors| MovingBody { vectors: vectors.clone(), ..self.body.clone() })
            .collect();
        let scales = Scales::of(&bodies, LONGEST);
        let placed: Vec<(&Vec<Moving>, Body)> = shown
            .into_iter()
            .zip(places)
            .filter_map(|(vectors, place)| {
                Some((vectors?, outline.clone().moved(mirrored(place) + up * outline.support(up))))
            })
            .collect();
        for (_, outline) in &placed {
            outline.draw(canvas);
        }
        for (vectors, mut outline) in placed {
            let at_foot = outline.centre().y < SIZE.y;
            for moving in vectors {
                let uphill = scales.arrow(moving).is_some_and(|arrow| arrow.x * side < 0.0);
                let attach = if at_foot && uphill { Attach::Arriving } else { Attach::Leaving };
                draw_vector(canvas, &mut outline, moving, &scales, attach);
            }
        }
        if let Some(height) = &self.height {
            let x = -LEAD - DIMENSION_GAP;
            let level = [Point::new(x - 4.0, 0.0), Point::new(SIZE.x - 8.0, 0.0)];
            canvas.line(level.map(mirrored), Role::Guide, false);
            let brow = [Point::new(x - 4.0, SIZE.y), Point::new(-LEAD, SIZE.y)];
            canvas.line(brow.map(mirrored), Role::Guide, false);
            let [foot, top] = [Point::new(x, 0.0), Point::new(x, SIZE.y)].map(mirrored);
            draw_dimension(canvas, foot, top, height);
        }
    }

    /// Level, down along half a wave, level.
    fn surface() -> Vec<Point> {
        let wave = (0..=PARTS).map(|part| {
            let part = f64::from(part) / f64::from(PARTS);
            Point::new(SIZE.x * part, SIZE.y * (1.0 + libm::cos(PI * part)) / 2.0)
        });
        let level = |from: f64, y: f64| (0..=6).map(move |part| Point::new(from + LEAD * f64::from(part) / 6.0, y));
        level(-LEAD, SIZE.y).chain(wave).chain(level(SIZE.x, 0.0)).collect()
    }
}
