//! Fixed surfaces: a line with hatching on the side that cannot be entered.

use super::place::Canvas;
use super::{Point, Role};

const HATCH_STEP: f64 = 6.0;
const HATCH_DEPTH: f64 = 5.0;
/// More strokes than this are not drawn, however long the surface.
const MOST_STROKES: u32 = 200;

/// Draws the surface from `start` to `end`, the free side to the left of that way.
pub(super) fn draw_surface(canvas: &mut Canvas, start: Point, end: Point) {
    canvas.line([start, end], Role::Surface, false);
    let way = end - start;
    let length = way.length();
    if length <= 0.0 {
        return;
    }
    let unit = way * (1.0 / length);
    let stroke = (unit + unit.turned()) * -HATCH_DEPTH;
    for number in 1..=MOST_STROKES {
        let along = HATCH_STEP * f64::from(number);
        if along > length {
            break;
        }
        let top = start + unit * along;
        canvas.line([top, top + stroke], Role::Guide, false);
    }
}
