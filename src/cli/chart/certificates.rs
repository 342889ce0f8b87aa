//! Certificates against errors: what the program promises of its answers, and how far they were from the truth.

use std::path::Path;

use serde::Deserialize;

use super::super::failure::Failure;
use super::super::plot::Axis;
use super::super::plot::Curve;
use super::super::plot::Mark;
use super::super::plot::Page;
use super::super::plot::Panel;
use super::super::plot::Spot;
use super::super::table;

/// A quantity that a problem asks for, over many seeds; all relative to its value.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Row {
    typical_error: f64,
    greatest_error: f64,
    greatest_certificate: f64,
}

/// Reads the table that `cargo test --test solver near` writes.
pub(super) fn read(path: &Path) -> Result<Vec<Row>, Failure> {
    let said = |error: csv::Error| Failure::unusable(format!("{} cannot be read: {error}", path.display()));
    let rows: Vec<Row> = table::typed(path).map_err(said)?;
    if rows.is_empty() {
        return Err(Failure::unusable(format!("{} holds no quantities", path.display())));
    }
    Ok(rows)
}

/// A mark for each quantity, between the line on which a certificate would be the error itself and a thousand times that.
pub(super) fn page(rows: &[Row]) -> Page {
    let cloud = |name: &str, colour, mark, error: fn(&Row) -> f64| Curve {
        name: name.to_owned(),
        note: None,
        colour,
        mark: Some(mark),
        joined: false,
        dashed: false,
        spots: rows
            .iter()
            .map(|row| Spot { across: error(row), up: Some(row.greatest_certificate), spread: None, failed: false })
            .collect(),
    };

    let curves = vec![
        cloud("typical error", 3, Mark::Disc, |row| row.typical_error),
        cloud("greatest error", 4, Mark::Cross, |row| row.greatest_error.max(LOW)),
        Curve::line("the error itself", 0, [(LOW, LOW), (HIGH, HIGH)].into_iter()),
        Curve::line("1000 times the error", 0, [(LOW, 1000.0 * LOW), (HIGH / 1000.0, HIGH)].into_iter()).dashed(),
    ];
    let panel = Panel {
        title: "greatest certificate of each answer, against its error".to_owned(),
        height: 520.0,
        across: Axis::decades("relative error", LOW, HIGH),
        up: Axis::decades("relative certificate", LOW, HIGH),
        curves,
        failures: false,
    };
    Page { title: "Certificates against errors".to_owned(), rows: vec![vec![panel.into()]] }
}

/// The decades that the chart shows.
const LOW: f64 = 1e-18;
const HIGH: f64 = 1e-10;
