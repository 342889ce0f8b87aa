//! Bodies in a plane, joined by strings, seen from above.

use crate::Point;
use crate::body::Body;
use crate::coil::draw_cord;
use crate::place::Canvas;

use super::angle::{AngleMark, Vertex, draw_angle};
use super::moving::{MovingBody, Scales, draw_vector};

const LONGEST: f64 = 44.0;
/// The length of a string, from centre to centre.
const STRING: f64 = 92.0;

/// Bodies joined by strings.
#[derive(Clone, Debug, PartialEq)]
pub struct Strung {
    /// The bodies, each with its place where every string has the length one.
    pub bodies: Vec<(MovingBody, [f64; 2])>,
    /// The strings, each with the positions of its two bodies in the list, and the angle that gives its direction.
    pub strings: Vec<([usize; 2], Option<AngleMark>)>,
}

impl Strung {
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let scales = Scales::of(self.bodies.iter().map(|(body, _)| body), LONGEST);
        let mut outlines: Vec<Body> = Vec::new();
        for (body, [x, y]) in &self.bodies {
            let at = if x.is_finite() && y.is_finite() { Point::new(*x, *y) * STRING } else { Point::ORIGIN };
            let outline = body.outline().moved(at);
            outline.draw(canvas);
            outlines.push(outline);
        }
        for ([first, second], _) in &self.strings {
            let (Some(from), Some(to)) = (outlines.get(*first), outlines.get(*second)) else { continue };
            let Some(along) = unit(to.centre() - from.centre()) else { continue };
            draw_cord(canvas, from.centre() + along * from.reach(along), to.centre() - along * to.reach(-along));
        }
        // Angles look out for bodies and strings, so both come before them.
        for ([first, second], mark) in &self.strings {
            let (Some(from), Some(to), Some(mark)) = (outlines.get(*first), outlines.get(*second), mark) else {
                continue;
            };
            let Some(along) = unit(to.centre() - from.centre()) else { continue };
            draw_angle(canvas, &[Vertex::open(from.centre(), from.reach(along))], along, mark);
        }
        for ((body, _), outline) in self.bodies.iter().zip(&mut outlines) {
            for moving in &body.vectors {
                draw_vector(canvas, outline, moving, &scales, moving.attach);
            }
        }
    }
}

fn unit(vector: Point) -> Option<Point> {
    let length = vector.length();
    (length > 1e-9).then(|| vector * (1.0 / length))
}
