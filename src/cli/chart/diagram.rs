//! Work-precision diagrams: error against time per solve and against evaluations, on logarithmic axes, one line a method.

use super::super::plot::Axis;
use super::super::plot::Curve;
use super::super::plot::Mark;
use super::super::plot::Page;
use super::super::plot::Panel;
use super::super::plot::Spot;
use super::points::Row;
use super::tasks::about;

/// The height of one task's panel, in pixels.
const HEIGHT: f64 = 440.0;

/// Each method with the shape of its points, in the order of the legend and of the colours.
pub(super) const LOOKS: &[(&str, Mark)] = &[
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
    let title = format!("Error against time and evaluations: {}", tasks.join(", "));
    let row = |task| WORKS.iter().map(|work| panel(task, rows, work).into()).collect();
    Page { title, rows: tasks.into_iter().map(row).collect() }
}

/// A measure of work: what it is called, its axis, and its value in a row.
struct Work {
    label: &'static str,
    axis: fn(&str, Vec<f64>) -> Axis,
    of: fn(&Row) -> f64,
}

const WORKS: [Work; 2] = [
    Work {
        label: "time per solve",
        axis: |label, values| Axis::times(label, values.into_iter()),
        of: |row| row.seconds,
    },
    Work {
        label: "evaluations of forces, or predictions of impacts",
        axis: |label, values| Axis::counts(label, values.into_iter()),
        of: |row| row.evaluations,
    },
];

fn panel(task: &str, rows: &[Row], work: &Work) -> Panel {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.task == task).collect();
    let what = about(task).map(|about| format!(": {about}")).unwrap_or_default();
    let curves = LOOKS.iter().enumerate();
    let curves = curves.filter_map(|(colour, (name, mark))| curve(&rows, name, *mark, colour, work.of));
    Panel {
        title: format!("{task}{what}"),
        height: HEIGHT,
        across: (work.axis)(work.label, rows.iter().map(|row| (work.of)(row)).collect()),
        up: Axis::errors("error of the whole state"),
        curves: curves.collect(),
        failures: true,
    }
}

/// The points of a method on a task, from its coarsest setting to its finest; the note says why it failed where it did.
fn curve(rows: &[&Row], method: &str, mark: Mark, colour: usize, work: fn(&Row) -> f64) -> Option<Curve> {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.method == method).copied().collect();
    let failed = rows.iter().filter(|row| row.failures > 0).count();
    let why = rows.iter().rev().find_map(|row| row.refusal.as_deref()).unwrap_or("no answer");
    let note = match failed {
        0 => None,
        _ if failed == rows.len() => Some(format!("\u{d7} {why}")),
        _ => Some(format!("\u{d7} {failed} of {}, {why}", rows.len())),
    };
    let spot = |row: &&Row| Spot {
        across: work(row),
        up: row.median_error,
        spread: row.low_error.zip(row.high_error).filter(|(low, high)| high > low).map(|(low, high)| [low, high]),
        failed: row.failures > 0,
    };
    let spots: Vec<Spot> = rows.iter().map(spot).collect();
    let (name, mark) = (method.to_owned(), Some(mark));
    (!spots.is_empty()).then_some(Curve { name, note, colour, mark, joined: true, dashed: false, spots })
}
