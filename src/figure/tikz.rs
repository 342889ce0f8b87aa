//! A drawing as `TikZ`: plain paths and nodes, so that LaTeX needs the package `tikz` and nothing else.

use std::fmt::Write;

use super::extent::Measure;
use super::geometry::{arc_points, arrow_head, coordinate, corners};
use super::style::{Style, style};
use super::{Drawing, Point, Role, Shape};

/// The drawing as a `tikzpicture` environment, one point to a unit.
///
/// ```
/// use momentous_figure::{Drawing, Point, tikz};
///
/// let (low, high) = (Point { x: 0.0, y: 0.0 }, Point { x: 40.0, y: 20.0 });
/// let words = String::new;
/// let text = tikz(&Drawing { title: words(), description: words(), caption: words(), low, high, shapes: Vec::new() });
/// assert!(text.starts_with("\\begin{tikzpicture}") && text.ends_with("\\end{tikzpicture}\n"));
/// ```
#[must_use]
pub fn tikz(drawing: &Drawing) -> String {
    let mut out = String::from(
        "\\begin{tikzpicture}[x=1bp,y=1bp,line join=round,line cap=round,\
         every node/.style={inner sep=0pt,outer sep=0pt,anchor=base,font=\\small}]\n",
    );
    let (low, high) = (pair(drawing.low), pair(drawing.high));
    put(&mut out, format_args!("\\useasboundingbox {low} rectangle {high};\n"));
    for shape in &drawing.shapes {
        write_shape(&mut out, shape);
    }
    out.push_str("\\end{tikzpicture}\n");
    out
}

fn put(out: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = out.write_fmt(text);
}

fn pair(point: Point) -> String {
    format!("({},{})", coordinate(point.x), coordinate(point.y))
}

fn path(points: &[Point]) -> String {
    points.iter().map(|point| pair(*point)).collect::<Vec<_>>().join(" -- ")
}

fn pen(style: &Style) -> String {
    format!("{},line width={}bp", style.mix, coordinate(style.width))
}

fn write_shape(out: &mut String, shape: &Shape) {
    match shape {
        Shape::Line { points, role, dashed } => write_line(out, points, *role, *dashed),
        Shape::Arrow { from, to, role } => {
            let (head, base) = arrow_head(*from, *to);
            write_line(out, &[*from, base], *role, false);
            write_filled(out, &head, style(*role).mix);
        }
        Shape::Circle { centre, radius, role } => {
            let (centre, radius, options) = (pair(*centre), coordinate(*radius), closed(&style(*role)));
            put(out, format_args!("\\filldraw[{options}] {centre} circle[radius={radius}];\n"));
        }
        Shape::Rectangle { centre, size, angle, role } => {
            let (path, options) = (path(&corners(*centre, *size, *angle)), closed(&style(*role)));
            put(out, format_args!("\\filldraw[{options}] {path} -- cycle;\n"));
        }
        Shape::Arc { centre, radius, from, to, arrow, role } => {
            let points = arc_points(*centre, *radius, *from, *to);
            write_arc(out, &points, *arrow, *role);
        }
        Shape::Area { points, role } => {
            let style = style(*role);
            write_filled(out, points, &tint(&style));
        }
        Shape::Label { at, text, role } => {
            let baseline = Point::new(at.x, at.y - Measure::of(text).drop());
            let (mix, at, text) = (style(*role).mix, pair(baseline), text.latex());
            put(out, format_args!("\\node[{mix}] at {at} {{${text}$}};\n"));
        }
    }
}

fn write_line(out: &mut String, points: &[Point], role: Role, dashed: bool) {
    let (pen, path) = (pen(&style(role)), path(points));
    let pattern = if dashed { ",dash pattern=on 5bp off 3bp" } else { "" };
    put(out, format_args!("\\draw[{pen}{pattern}] {path};\n"));
}

fn write_filled(out: &mut String, points: &[Point], mix: &str) {
    put(out, format_args!("\\fill[{mix}] {} -- cycle;\n", path(points)));
}

fn write_arc(out: &mut String, points: &[Point], arrow: bool, role: Role) {
    let [line @ .., before, last] = points else { return };
    if !arrow {
        return write_line(out, points, role, false);
    }
    // The line stops short of the tip, which it would blunt; the head follows the tangent.
    write_line(out, line, role, false);
    let tangent = *last - *before;
    let back = *last - tangent * (12.0 / tangent.length().max(1e-9));
    write_filled(out, &arrow_head(back, *last).0, style(role).mix);
}

fn closed(style: &Style) -> String {
    let pen = pen(style);
    if style.fill > 0.0 { format!("{pen},fill={}", tint(style)) } else { format!("{pen},fill=none") }
}

/// The colour thinned with white as SVG thins it with opacity.
fn tint(style: &Style) -> String {
    format!("{}!{}!white", style.mix, coordinate(style.fill * 100.0))
}
