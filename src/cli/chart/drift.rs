//! Drift of energy and momentum over many bounces and periods: a table of comma-separated values, and its chart.

use std::path::Path;

use serde::Deserialize;
use serde::Serialize;

use crate::simulate::Drift;
use crate::simulate::LASTING_MOTIONS;
use crate::simulate::LastingMotion;
use crate::simulate::drifts;
use crate::simulate::drifts_of;

use super::super::failure::Failure;
use super::super::plot::Axis;
use super::super::plot::Curve;
use super::super::plot::Page;
use super::super::plot::Panel;
use super::super::plot::Spot;
use super::super::progress;
use super::super::table;
use super::diagram::LOOKS;
use super::points::rounded;

/// One row: a method after so many periods of a motion.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(super) struct Row {
    motion: String,
    method: String,
    setting: Option<f64>,
    periods: u32,
    seconds: f64,
    energy: Option<f64>,
    momentum: Option<f64>,
    refusal: Option<String>,
}

impl From<Drift> for Row {
    fn from(drift: Drift) -> Self {
        Self {
            motion: drift.motion.to_owned(),
            method: drift.method.to_owned(),
            setting: drift.setting.map(rounded),
            periods: drift.periods,
            seconds: rounded(drift.seconds),
            energy: drift.energy.map(rounded),
            momentum: drift.momentum.map(rounded),
            refusal: drift.refusal,
        }
    }
}

/// Runs every method for up to so many periods, with a bar that shows how far it is.
pub(super) fn measure(most_periods: u32) -> Vec<Row> {
    let bar = progress::bar(drifts_of(most_periods) as u64, false);
    drifts(most_periods, &mut || bar.inc(1)).into_iter().map(Row::from).collect()
}

/// Reads a table that was measured before.
pub(super) fn read(path: &Path) -> Result<Vec<Row>, Failure> {
    let said = |error: csv::Error| Failure::unusable(format!("{} cannot be read as drifts: {error}", path.display()));
    let rows: Vec<Row> = table::typed(path).map_err(said)?;
    if rows.is_empty() {
        return Err(Failure::unusable(format!("{} holds no drifts", path.display())));
    }
    Ok(rows)
}

/// The height of a panel, in pixels.
const HEIGHT: f64 = 400.0;

/// The drift of the energy of each motion, and beside it that of the momentum where it keeps one.
pub(super) fn page(rows: &[Row]) -> Page {
    let row = |motion: &LastingMotion| {
        let energy = panel(rows, motion.name, "energy", |row| row.energy);
        let momentum = motion.momentum.map(|name| panel(rows, motion.name, name, |row| row.momentum));
        std::iter::once(energy).chain(momentum).map(Into::into).collect()
    };
    let title = "Drift of energy and momentum over bounces and periods".to_owned();
    Page { title, rows: LASTING_MOTIONS.iter().map(row).collect() }
}

fn panel(rows: &[Row], motion: &str, measure: &str, drift: fn(&Row) -> Option<f64>) -> Panel {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.motion == motion).collect();
    let looks = LOOKS.iter().enumerate();
    let curves = looks.filter_map(|(colour, (method, mark))| {
        let rows: Vec<&&Row> = rows.iter().filter(|row| row.method == *method).collect();
        let refusal = rows.iter().find_map(|row| row.refusal.as_deref());
        let spot = |row: &&&Row| Spot {
            across: f64::from(row.periods),
            up: drift(row),
            spread: None,
            failed: row.refusal.is_some(),
        };
        let spots: Vec<Spot> = rows.iter().map(spot).collect();
        let (name, note) = ((*method).to_owned(), refusal.map(|refusal| format!("\u{d7} {refusal}")));
        let curve = Curve { name, note, colour, mark: Some(*mark), joined: true, dashed: false, spots };
        (!rows.is_empty()).then_some(curve)
    });
    Panel {
        title: format!("{motion}: {measure}"),
        height: HEIGHT,
        across: Axis::counts("periods", rows.iter().map(|row| f64::from(row.periods))),
        up: Axis::errors(&format!("change of the {measure}, as a part of it")),
        curves: curves.collect(),
        failures: true,
    }
}
