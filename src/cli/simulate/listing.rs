//! The table of impacts as text and as comma-separated values.

use std::fmt::Write;

use crate::witness::{AT_ITS_TIME, IMPACTS, Shot};

use super::super::failure::Failure;

/// For people.
pub(super) fn text(title: &str, shot: &Shot) -> String {
    let mut out = format!("{title}\n");
    for film in &shot.films {
        let axes: Vec<&str> = film.axes.iter().map(|axis| axis.letter).collect();
        let bodies: Vec<&str> = film.record.bodies.iter().map(|body| body.name.as_str()).collect();
        let _ = writeln!(out, "\nstage {}: {} along {}", film.stage, bodies.join(", "), axes.join(", "));
        let _ = writeln!(out, "  {}", film.why());
        for caution in film.cautions() {
            let _ = writeln!(out, "  {caution}");
        }
        if film.ending != AT_ITS_TIME {
            let _ = writeln!(out, "  it ends {}", film.ending);
        }
        let rows = film.impacts();
        if rows.is_empty() {
            let _ = writeln!(out, "  no impact");
            continue;
        }
        let all: Vec<Vec<String>> = std::iter::once(IMPACTS.map(str::to_owned).to_vec()).chain(rows).collect();
        let width = |column: usize| all.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..IMPACTS.len()).map(width).collect();
        for row in &all {
            let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}")).collect();
            let _ = writeln!(out, "  {}", cells.join("  ").trim_end());
        }
        if let Some(more) = film.weak_impacts() {
            let _ = writeln!(out, "  {more}");
        }
    }
    for (stage, reason) in &shot.nothing {
        let _ = writeln!(out, "\nstage {stage}: {reason}");
    }
    out
}

/// The impacts of all stages, one a row, with all figures.
pub(super) fn csv(shot: &Shot) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let unwritten = |error: csv::Error| Failure::unusable(format!("the table cannot be written: {error}"));
    let mut table = csv::Writer::from_writer(&mut bytes);
    let headings = ["stage", "time", "between", "impulse_1", "impulse_2", "energy_before", "energy_after"];
    table.write_record(headings).map_err(unwritten)?;
    for film in &shot.films {
        for impact in &film.record.impacts {
            let part = |place: usize| impact.impulse.get(place).map(f64::to_string).unwrap_or_default();
            let [time, before, after] =
                [impact.time, impact.energy_before, impact.energy_after].map(|number| number.to_string());
            let row = [film.stage.to_string(), time, impact.contact.clone(), part(0), part(1), before, after];
            table.write_record(row).map_err(unwritten)?;
        }
    }
    table.flush()?;
    drop(table);
    Ok(bytes)
}
