//! Many submissions at once, on every core.

use std::collections::HashMap;

use momentous::exercise::SheetSeed;
use momentous::grade::{DecimalMark, Sitting};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use rayon::prelude::*;

use super::bank::Bank;
use super::error;
use super::problem::{Problem, Seed, compiled};
use super::variant::{decimal_mark, marked};

/// A submission: the problem by its identity, the seed and the form of the sheet, and the answers by part.
type Row = (String, Seed, Option<String>, Vec<(String, String)>, usize, bool);

/// Points, those that can be reached, and the report as JSON.
type Marks = (f64, u32, String);

/// Marks submissions, each as [`super::mark`] does, with the interpreter's lock released. A row that cannot be marked gets the reason.
#[pyfunction]
#[pyo3(signature = (rows, bank, *, decimal="point", secret=None))]
pub(super) fn mark_rows(
    py: Python<'_>,
    rows: Vec<Row>,
    bank: &Bank,
    decimal: &str,
    secret: Option<PyBackedBytes>,
) -> PyResult<Vec<(Option<Marks>, Option<String>)>> {
    let decimal = decimal_mark(decimal).map_err(|message| error::of_message(py, &message))?;
    Ok(py.detach(move || {
        let problems = problems(&rows, bank, secret.as_deref());
        let marks = rows.par_iter().map(|row| match mark_row(row, &problems, decimal) {
            Ok(marks) => (Some(marks), None),
            Err(reason) => (None, Some(reason)),
        });
        marks.collect()
    }))
}

/// Each problem of the rows, compiled once. Identities only: a table opens no file of this machine.
fn problems<'r>(rows: &'r [Row], bank: &Bank, secret: Option<&[u8]>) -> HashMap<&'r str, Result<Problem, String>> {
    let mut names: Vec<&str> = rows.iter().map(|row| row.0.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let compiled = |name: &'r str| {
        let problem = bank.0.find(name).and_then(|source| compiled(source.clone(), secret));
        (name, problem.map_err(|faults| faults.to_string()))
    };
    names.into_par_iter().map(compiled).collect()
}

fn mark_row(
    (name, seed, form, answers, hints, closed): &Row,
    problems: &HashMap<&str, Result<Problem, String>>,
    decimal: DecimalMark,
) -> Result<Marks, String> {
    let problem = problems.get(name.as_str()).ok_or("the problem is not known")?.as_ref().map_err(Clone::clone)?;
    let exercise = problem.draw(seed, form.as_deref(), SheetSeed::of_a_sheet)?;
    let report = marked(&exercise, answers, decimal, Sitting { hints: *hints, closed: *closed })?;
    Ok((report.points(), report.report.out_of, report.record))
}
