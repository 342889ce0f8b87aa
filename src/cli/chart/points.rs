//! The points of work-precision diagrams as a table of comma-separated values, written and read.

use std::path::Path;

use serde::Deserialize;
use serde::Serialize;

use crate::simulate::Errors;
use crate::simulate::Point;

use super::super::failure::Failure;
use super::super::table;

/// One row: a method at one setting on one task.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(super) struct Row {
    pub task: String,
    pub method: String,
    pub setting: Option<f64>,
    pub seconds: f64,
    pub evaluations: f64,
    pub low_error: Option<f64>,
    pub median_error: Option<f64>,
    pub high_error: Option<f64>,
    pub greatest_error: Option<f64>,
    pub failures: usize,
    pub refusal: Option<String>,
}

impl From<Point> for Row {
    fn from(point: Point) -> Self {
        let error = |part: fn(&Errors) -> f64| point.errors.as_ref().map(part).map(rounded);
        Self {
            task: point.task.to_owned(),
            method: point.method.to_owned(),
            setting: point.setting,
            seconds: rounded(point.seconds),
            evaluations: rounded(point.evaluations),
            low_error: error(|errors| errors.low),
            median_error: error(|errors| errors.median),
            high_error: error(|errors| errors.high),
            greatest_error: error(|errors| errors.greatest),
            failures: point.failures,
            refusal: point.refusal,
        }
    }
}

/// Four figures: a measured time has no more, and no error needs them.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// The table with a line of headings.
pub(super) fn write(rows: &[impl Serialize], out: impl std::io::Write) -> Result<(), Failure> {
    let mut table = csv::Writer::from_writer(out);
    for row in rows {
        table.serialize(row).map_err(|error| Failure::unusable(format!("the table cannot be written: {error}")))?;
    }
    Ok(table.flush()?)
}

/// Reads what [`write`] wrote.
pub(super) fn read(path: &Path) -> Result<Vec<Row>, Failure> {
    let said = |error: csv::Error| Failure::unusable(format!("{} cannot be read as points: {error}", path.display()));
    let rows: Vec<Row> = table::typed(path).map_err(said)?;
    if rows.is_empty() {
        return Err(Failure::unusable(format!("{} holds no points", path.display())));
    }
    match rows.iter().find(|row| !(row.seconds.is_finite() && row.seconds > 0.0)) {
        Some(row) => Err(Failure::unusable(format!(
            "{}: `{}` on `{}` takes {} s, which no logarithmic axis can show",
            path.display(),
            row.method,
            row.task,
            row.seconds
        ))),
        None => Ok(rows),
    }
}
