//! The engine as a module of Python: names and numbers go in, texts come out. What a sheet says and what a mark is, the rooms
//! of the engine decide.

mod bank;
mod error;
mod problem;
mod report;
mod rows;
mod variant;

use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyMapping;

use bank::Bank;
use problem::{Problem, Seed};
use report::{Part, Report};
use variant::Variant;

/// Marks answers to the variant of a seed, as `momentous grade` does.
#[pyfunction]
#[pyo3(signature = (problem, seed, answers, *, form=None, decimal="point", hints=0, closed=false, secret=None))]
#[expect(clippy::too_many_arguments, reason = "each is a named argument of Python")]
fn mark(
    py: Python<'_>,
    problem: &str,
    seed: Seed,
    answers: &Bound<'_, PyMapping>,
    form: Option<&str>,
    decimal: &str,
    hints: usize,
    closed: bool,
    secret: Option<PyBackedBytes>,
) -> PyResult<Report> {
    let problem = Bank::here(py)?.problem(py, problem, secret)?;
    problem.of_a_sheet(py, seed, form)?.mark(py, answers, decimal, hints, closed)
}

/// The module.
#[pymodule]
fn _engine(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<Bank>()?;
    module.add_class::<Problem>()?;
    module.add_class::<Variant>()?;
    module.add_class::<Report>()?;
    module.add_class::<Part>()?;
    module.add_function(wrap_pyfunction!(rows::mark_rows, module)?)?;
    module.add_function(wrap_pyfunction!(mark, module)?)
}
