//! Springs and cords: what joins bodies to each other and to fixed things.

use super::place::Canvas;
use super::surface::draw_surface;
use super::{Point, Role};

/// Number of turns, half the width of a turn, and the straight piece at either end.
const TURNS: u32 = 7;
const HALF_WIDTH: f64 = 5.0;
const LEAD: f64 = 6.0;
/// How far a slack cord hangs through, as a part of its length.
const SAG: f64 = 0.16;
const SLACK_PARTS: u32 = 16;

/// A spring as a zigzag between two points.
pub(super) fn draw_coil(canvas: &mut Canvas, from: Point, to: Point) {
    let along = to - from;
    let length = along.length();
    if length <= 2.0 * LEAD {
        return canvas.line([from, to], Role::Path, false);
    }
    let unit = along * (1.0 / length);
    let (start, end) = (from + unit * LEAD, to - unit * LEAD);
    let corner = |number: u32| {
        let side = if number.is_multiple_of(2) { HALF_WIDTH } else { -HALF_WIDTH };
        start.towards(end, (f64::from(number) + 0.5) / f64::from(2 * TURNS)) + unit.turned() * side
    };
    let points = [from, start].into_iter().chain((0..2 * TURNS).map(corner)).chain([end, to]);
    canvas.line(points, Role::Path, false);
}

/// A cord with its straight way between two points.
pub(super) fn draw_cord(canvas: &mut Canvas, from: Point, to: Point) {
    canvas.line([from, to], Role::Path, false);
}

/// A slack cord between two points, seen from above or from the side.
pub(super) fn draw_slack(canvas: &mut Canvas, from: Point, to: Point) {
    let along = to - from;
    let side = if along.turned().y > 0.0 { along.turned() } else { -along.turned() };
    let bend = |part: u32| {
        let part = f64::from(part) / f64::from(SLACK_PARTS);
        from.towards(to, part) - side * (SAG * 4.0 * part * (1.0 - part))
    };
    canvas.line((0..=SLACK_PARTS).map(bend), Role::Path, false);
}

/// A short fixed surface that holds the end of a spring or a cord; `free` points from it to what it holds.
pub(super) fn draw_support(canvas: &mut Canvas, at: Point, free: Point, half: f64) {
    let side = free.turned() * half;
    draw_surface(canvas, at + side, at - side);
}
