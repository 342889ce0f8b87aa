//! Dimension lines: a double arrow with a label beside it.

use std::f64::consts::FRAC_PI_2;

use crate::place::{Anchor, Canvas};
use crate::{Point, Role};
use momentous_expr::Math;

/// The least length that a dimension line fits into.
const SHORTEST: f64 = 16.0;
/// The length of an arrow from outside.
const OUTSIDE: f64 = 12.0;

/// A double arrow between two points; where they are too close for one, two arrows from outside.
pub(super) fn draw_dimension(canvas: &mut Canvas, from: Point, to: Point, label: &Math) {
    let (along, length) = (to - from, (to - from).length());
    if length < SHORTEST {
        let beyond = if length > 0.0 { along * (OUTSIDE / length) } else { Point::new(0.0, OUTSIDE) };
        canvas.arrow(to + beyond, to, Role::Guide);
        canvas.arrow(from - beyond, from, Role::Guide);
        let aside = if beyond.x.abs() > beyond.y.abs() { FRAC_PI_2 } else { 0.0 };
        return canvas.label(label, Role::Body, Anchor::Around { at: to + beyond * 0.5, radius: 2.0, prefer: aside });
    }
    let middle = from + along * 0.5;
    canvas.arrow(middle, to, Role::Guide);
    canvas.arrow(middle, from, Role::Guide);
    canvas.label(label, Role::Body, Anchor::Along { from, to });
}
