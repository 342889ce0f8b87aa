//! The plots of a simulation: place, velocity and momentum along each axis, and the energies, against the time.

use crate::simulate::Moment;
use crate::simulate::Record;
use crate::simulate::scene::Component;
use crate::witness::{Film, IMPACTS};

use super::super::plot::Axis;
use super::super::plot::Curve;
use super::super::plot::Page;
use super::super::plot::Panel;
use super::super::plot::Table;

/// The height of a panel, in pixels.
const HEIGHT: f64 = 270.0;

/// The colour of what belongs to all bodies together, and those of single bodies.
const ALL: usize = 0;
const BODIES: [usize; 6] = [3, 4, 2, 8, 6, 5];

/// The rows of a table of impacts that a page has room for.
const MOST_ROWS: usize = 12;

/// A panel of a film along one of its axes.
type Along = fn(&Film, usize, &Component, &dyn Fn(&str) -> String) -> Panel;

/// The most panels of a row.
const COLUMNS: usize = 3;

/// All films, one below the other: a row for each kind of quantity, with the axes of a stage side by side.
pub(super) fn page(title: &str, films: &[Film]) -> Page {
    let mut page = Page { title: format!("Simulation of {title}"), rows: Vec::new() };
    // Of a stage that was simulated axis by axis, each film has one.
    let together = |one: &Film, next: &Film| one.stage == next.stage && one.axes.len() + next.axes.len() == 2;
    for films in films.chunk_by(together).flat_map(|films| films.chunks(COLUMNS)) {
        let named = |what: &str| format!("stage {}: {what}", films[0].stage);
        for along in [places, velocities, momenta] as [Along; 3] {
            let axes = films.iter().flat_map(|film| film.axes.iter().enumerate().map(move |axis| (film, axis)));
            let row = axes.map(|(film, (component, axis))| along(film, component, axis, &named).into());
            page.rows.push(row.collect());
        }
        let energies = films.iter().map(|film| energies(&film.record, &named).into()).collect::<Vec<_>>();
        let impacts = films.iter().map(|film| impacts(film, &named).into()).collect::<Vec<_>>();
        if films[0].axes.len() > 1 {
            page.rows.push(energies.into_iter().chain(impacts).collect());
        } else {
            page.rows.extend([energies, impacts]);
        }
    }
    page
}

fn panel(title: String, up: &str, curves: Vec<Curve>) -> Panel {
    let across = Axis::linear("time in s", curves.iter().flat_map(|curve| curve.spots.iter().map(|spot| spot.across)));
    let up = Axis::linear(up, curves.iter().flat_map(|curve| curve.spots.iter().filter_map(|spot| spot.up)));
    Panel { title, height: HEIGHT, across, up, curves, failures: false }
}

fn over_time(name: &str, colour: usize, record: &Record, value: impl Fn(&Moment) -> f64) -> Curve {
    Curve::line(name, colour, record.moments.iter().map(|moment| (moment.time, value(moment))))
}

/// A curve for each body.
fn each(record: &Record, value: impl Fn(&Moment, usize) -> f64) -> Vec<Curve> {
    let named = record.bodies.iter().enumerate();
    named
        .map(|(place, body)| over_time(&body.name, BODIES[place % BODIES.len()], record, |moment| value(moment, place)))
        .collect()
}

fn places(film: &Film, component: usize, axis: &Component, named: &dyn Fn(&str) -> String) -> Panel {
    let (letter, record) = (axis.letter, &film.record);
    let mut curves = each(record, |moment, body| moment.positions[body][component]);
    if record.bodies.len() > 1 {
        curves.push(over_time("centre of mass", ALL, record, |moment| moment.centre[component]).dashed());
    }
    let what = if axis.vertical { "height" } else { "place" };
    panel(named(&format!("{what} {letter}")), &format!("{letter} in m"), curves)
}

fn velocities(film: &Film, component: usize, axis: &Component, named: &dyn Fn(&str) -> String) -> Panel {
    let curves = each(&film.record, |moment, body| moment.velocities[body][component]);
    let letter = axis.letter;
    panel(named(&format!("velocity along {letter}")), &format!("v along {letter} in m/s"), curves)
}

fn momenta(film: &Film, component: usize, axis: &Component, named: &dyn Fn(&str) -> String) -> Panel {
    let record = &film.record;
    let mut curves = each(record, |moment, body| moment.masses[body] * moment.velocities[body][component]);
    if record.bodies.len() > 1 {
        curves.push(over_time("all together", ALL, record, |moment| moment.momentum[component]));
    }
    let outside = |moment: &Moment| moment.outside[component];
    // Without it the balance is the momentum itself.
    if record.moments.iter().any(|moment| outside(moment) != 0.0) {
        curves.push(over_time("impulse from outside", 1, record, outside).dashed());
        let kept = |moment: &Moment| moment.momentum[component] - outside(moment);
        curves.push(over_time("balance", ALL, record, kept).dashed());
    }
    let letter = axis.letter;
    panel(named(&format!("momentum along {letter}")), &format!("p along {letter} in N s"), curves)
}

/// One of the energies of a moment, in J.
type Energy = fn(&Moment) -> f64;

fn energies(record: &Record, named: &dyn Fn(&str) -> String) -> Panel {
    let kinds: [(&str, usize, Energy); 4] = [
        ("kinetic", 3, |moment| moment.kinetic),
        ("potential", 2, |moment| moment.potential),
        ("lost in impacts", 4, |moment| moment.lost),
        ("work of forces", 1, |moment| moment.work),
    ];
    let largest = record.moments.iter().map(|moment| moment.kinetic.abs() + moment.potential.abs()).fold(0.0, f64::max);
    // A sum that is nothing but rounding is no energy.
    let matters = |value: Energy| record.moments.iter().any(|moment| value(moment).abs() > 1e-9 * largest);
    let mut curves = Vec::new();
    for (name, colour, value) in kinds {
        if name == "kinetic" || matters(value) {
            curves.push(over_time(name, colour, record, value));
        }
    }
    curves.push(over_time("balance", ALL, record, Moment::balance).dashed());
    panel(named("energy"), "E in J", curves)
}

fn impacts(film: &Film, named: &dyn Fn(&str) -> String) -> Table {
    let mut rows = film.impacts();
    let more = rows.len().saturating_sub(MOST_ROWS);
    rows.truncate(MOST_ROWS);
    let mut notes = vec![film.why()];
    notes.extend(film.cautions());
    if rows.is_empty() {
        notes.push("There is no impact.".to_owned());
    }
    if more > 0 {
        notes.push(format!("{more} more follow."));
    }
    notes.extend(film.weak_impacts());
    Table { title: named("impacts"), headings: IMPACTS.to_vec(), rows, notes }
}
