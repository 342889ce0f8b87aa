//! A collection of problems.

use std::path::PathBuf;

use momentous::bank;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyIterator, PyList};

use super::error;
use super::problem::{Problem, compiled};

/// Problems that are known by their identities.
#[pyclass(frozen, module = "momentous")]
pub(super) struct Bank(pub(super) bank::Bank);

#[pymethods]
impl Bank {
    /// The bank of a folder; without one the course's `problem_bank/` here or above, else the one that is built in.
    #[new]
    #[pyo3(signature = (folder=None))]
    fn new(py: Python<'_>, folder: Option<PathBuf>) -> PyResult<Self> {
        match folder {
            Some(folder) => {
                let bank = py.detach(|| bank::Bank::in_folder(&folder));
                bank.map(Self).map_err(|faults| error::of_faults(py, &faults))
            }
            None => Self::here(py),
        }
    }

    /// The bank that is built in, wherever the program runs.
    #[staticmethod]
    fn built_in() -> Self {
        Self(bank::Bank::built_in())
    }

    /// The identities, in order.
    fn ids(&self) -> Vec<&str> {
        self.0.ids().collect()
    }

    /// What stands before the first slash of the identities, each once, in order.
    fn topics(&self) -> Vec<&str> {
        self.0.topics()
    }

    /// The problem of that identity, or that file; with a secret, the numbers are those of the course alone.
    #[pyo3(signature = (name, *, secret=None))]
    pub(super) fn problem(&self, py: Python<'_>, name: &str, secret: Option<PyBackedBytes>) -> PyResult<Problem> {
        let compiled = py.detach(move || self.0.open(name).and_then(|source| compiled(source, secret.as_deref())));
        compiled.map_err(|faults| error::of_faults(py, &faults))
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Problem> {
        self.problem(py, name, None)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.ids())?.try_iter()
    }

    fn __contains__(&self, id: &str) -> bool {
        self.0.ids().any(|listed| listed == id)
    }

    fn __len__(&self) -> usize {
        self.0.ids().count()
    }

    fn __repr__(&self) -> String {
        format!("<Bank of {} problems>", self.__len__())
    }
}

impl Bank {
    /// The bank where the program runs.
    pub(super) fn here(py: Python<'_>) -> PyResult<Self> {
        py.detach(bank::Bank::here).map(Self).map_err(|faults| error::of_faults(py, &faults))
    }
}
