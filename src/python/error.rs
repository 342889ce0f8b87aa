//! What is wrong, as `momentous.Error`: a message, the place and the way out.

use momentous::fault::{Fault, Faults, Source};
use pyo3::prelude::*;
use pyo3::types::PyList;

/// Where the exception is defined.
const MODULE: &str = "momentous._error";

/// What stands between a message and its way out.
const HELP: &str = "\nhelp: ";

/// A fault as Python has it: message, file, line, column, the way out.
type Told<'a> = (&'a str, &'a str, Option<usize>, Option<usize>, Option<&'a str>);

/// The exception for faults of a file.
pub(super) fn of_faults(py: Python<'_>, faults: &Faults) -> PyErr {
    let told: Vec<Told<'_>> = faults.list.iter().map(|fault| told(&faults.source, fault)).collect();
    raised(py, &faults.to_string(), &told)
}

/// The exception for what is said of an argument, as a rule with a way out behind it.
pub(super) fn of_message(py: Python<'_>, message: &str) -> PyErr {
    let (said, help) = message.split_once(HELP).map_or((message, None), |(said, help)| (said, Some(help)));
    raised(py, message, &[(said, "", None, None, help)])
}

fn told<'a>(source: &'a Source, fault: &'a Fault) -> Told<'a> {
    let place = fault.span.map(|span| source.line_and_column(span.start));
    (&fault.message, &source.name, place.map(|(line, _)| line), place.map(|(_, column)| column), fault.help.as_deref())
}

fn raised(py: Python<'_>, text: &str, faults: &[Told<'_>]) -> PyErr {
    let exception = || -> PyResult<Bound<'_, PyAny>> {
        let faults = PyList::new(py, faults)?;
        py.import(MODULE)?.getattr("Error")?.call_method1("_of", (text.trim_end(), faults))
    };
    exception().map_or_else(|error| error, PyErr::from_value)
}
