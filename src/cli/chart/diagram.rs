//! Work-precision diagrams: error against time per solve, both on logarithmic axes, one line a method.

use super::super::plot::Axis;
use super::super::plot::Curve;
use super::super::plot::Mark;
use super::super::plot::Page;
use super::super::plot::Panel;
use super::super::plot::Spot;
use super::points::Row;
use super::tasks::asks;

/// The height of one task's panel, in pixels.
const HEIGHT: f64 = 440.0;

/// Each method with the shape of its points, in the order of the legend and of the colours.
const LOOKS: &[(&str, Mark)] = &[
    ("closed form", Mark::Star),
    ("linear solve", Mark::Square),
    ("event driven", Mark::Diamond),
    ("Runge-Kutta 5(4)", Mark::Disc),
    ("explicit Euler", Mark::Triangle),
    ("symplectic Euler", Mark::Square),
    ("Moreau-Jean", Mark::Disc),
    ("penalty", Mark::Diamond),
    ("sequential impulses", Mark::Triangle),
    ("Rapier", Mark::Cross),
];

/// The diagrams of all tasks in the rows, one below the other.
pub(super) fn page(rows: &[Row]) -> Page {
    let mut tasks: Vec<&str> = Vec::new();
    for row in rows {
        if !tasks.contains(&row.task.as_str()) {
            tasks.push(&row.task);
        }
    }
    let title = format!("Error against time per solve: {}", tasks.join(", "));
    Page { title, rows: tasks.into_iter().map(|task| vec![panel(task, rows).into()]).collect() }
}

fn panel(task: &str, rows: &[Row]) -> Panel {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.task == task).collect();
    let what = asks(task).map(|asks| format!(": {asks}")).unwrap_or_default();
    let curves = LOOKS.iter().enumerate().filter_map(|(colour, (name, mark))| curve(&rows, name, *mark, colour));
    Panel {
        title: format!("{task}{what}"),
        height: HEIGHT,
        across: Axis::times("time per solve", rows.iter().map(|row| row.seconds)),
        up: Axis::errors("relative error"),
        curves: curves.collect(),
        failures: true,
    }
}

/// The points of a method on a task, from its coarsest setting to its finest; the note says why it failed where it did.
fn curve(rows: &[&Row], method: &str, mark: Mark, colour: usize) -> Option<Curve> {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.method == method).copied().collect();
    let failed = rows.iter().filter(|row| row.failures > 0).count();
    let why = rows.iter().rev().find_map(|row| row.refusal.as_deref()).unwrap_or("no answer");
    let note = match failed {
        0 => None,
        _ if failed == rows.len() => Some(format!("\u{d7} {why}")),
        _ => Some(format!("\u{d7} {failed} of {}, {why}", rows.len())),
    };
    let spot = |row: &&Row| Spot {
        across: row.seconds,
        up: row.median_error,
        spread: row.greatest_error.filter(|greatest| row.median_error.is_some_and(|median| *greatest > median)),
        failed: row.failures > 0,
    };
    let spots: Vec<Spot> = rows.iter().map(spot).collect();
    let (name, mark) = (method.to_owned(), Some(mark));
    (!spots.is_empty()).then_some(Curve { name, note, colour, mark, joined: true, dashed: false, spots })
}
