//! Panels in rows with signs between them: before + impulse = after.

use std::sync::LazyLock;

use momentous_expr::Math;
use momentous_expr::Operator;

use super::extent::{Extent, Measure};
use super::input::AxisMark;
use super::place::{Anchor, Canvas, on_baseline};
use super::{Point, Role};

/// Room for a sign between two panels.
const SIGN_ROOM: f64 = 24.0;
const ROW_GAP: f64 = 16.0;
const HEADING_GAP: f64 = 12.0;
/// Length of the axes that name the directions, and their distance from the panels.
const AXIS_LENGTH: f64 = 26.0;
const AXES_GAP: f64 = 14.0;

/// One equation of pictures: each panel drawn about its own origin.
pub(super) struct Row {
    pub panels: Vec<Canvas>,
}

/// The signs between the panels: before + impulse = after; between two of them the last one.
static SIGNS: LazyLock<[Math; 2]> = LazyLock::new(|| [Operator::Plus, Operator::Equals].map(Math::Operator));

/// Rows in columns: headings above, signs between, axes at the lower left.
pub(super) fn assemble(headings: &[Math], rows: Vec<Row>, axes: &[AxisMark]) -> Canvas {
    let frames: Vec<Vec<Extent>> = rows.iter().map(|row| row.panels.iter().map(Canvas::frame).collect()).collect();
    let widths = column_widths(headings, &frames);
    let centres = column_centres(&widths);
    let mut canvas = Canvas::default();
    for (heading, centre) in headings.iter().zip(&centres) {
        canvas.fixed_label(on_baseline(*centre, 0.0, heading), heading, Role::Body);
    }
    let mut top = if headings.is_empty() { 0.0 } else { -HEADING_GAP };
    for (row, frames) in rows.into_iter().zip(&frames) {
        let frame = frames.iter().copied().reduce(Extent::joined).unwrap_or_default();
        let level = top - frame.high.y;
        let signs = SIGNS.iter().skip((SIGNS.len() + 1).saturating_sub(centres.len()));
        for (index, sign) in signs.enumerate() {
            if let (Some(left), Some(right)) = (centres.get(index), centres.get(index + 1)) {
                let (left_width, right_width) = (widths[index], widths[index + 1]);
                let x = f64::midpoint(left + left_width / 2.0, right - right_width / 2.0);
                canvas.fixed_label(Point::new(x, level), sign, Role::Body);
            }
        }
        for ((panel, frame), centre) in row.panels.into_iter().zip(frames).zip(&centres) {
            let shift = Point::new(centre - frame.centre().x, level);
            canvas.draw_moved(panel, shift);
        }
        top = level + frame.low.y - ROW_GAP;
    }
    draw_axes(&mut canvas, axes);
    canvas
}

/// Axes below the left end of all that has its place.
pub(super) fn draw_axes(canvas: &mut Canvas, axes: &[AxisMark]) {
    if axes.is_empty() {
        return;
    }
    let mut inset = Canvas::default();
    for axis in axes.iter().filter(|axis| axis.angle.is_finite()) {
        let tip = Point::polar(AXIS_LENGTH * axis.length, axis.angle);
        inset.arrow(Point::ORIGIN, tip, Role::Axis);
        inset.label(&axis.name, Role::Axis, Anchor::Around { at: tip, radius: 0.0, prefer: axis.angle });
    }
    let inset = inset.settled();
    let (taken, frame) = (canvas.frame(), inset.frame());
    let shift = Point::new(taken.low.x - frame.low.x, taken.low.y - AXES_GAP - frame.high.y);
    canvas.draw_moved(inset, shift);
}

/// Widths that hold the headings, and in each row the panels with those frames.
fn column_widths(headings: &[Math], frames: &[Vec<Extent>]) -> Vec<f64> {
    let columns = frames.iter().map(Vec::len).max().unwrap_or(0).max(headings.len());
    let heading = |column: usize| headings.get(column).map_or(0.0, |heading| Measure::of(heading).width);
    let panel = |row: &[Extent], column: usize| row.get(column).map_or(0.0, |frame| frame.size().x);
    (0..columns).map(|column| frames.iter().map(|row| panel(row, column)).fold(heading(column), f64::max)).collect()
}

fn column_centres(widths: &[f64]) -> Vec<f64> {
    let mut left = 0.0;
    let mut centres = Vec::new();
    for width in widths {
        centres.push(left + width / 2.0);
        left += width + SIGN_ROOM;
    }
    centres
}
