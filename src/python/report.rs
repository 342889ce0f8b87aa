//! What was found about answers.

use momentous::grade;
use pyo3::prelude::*;

/// Marks, and the reason for each.
#[pyclass(frozen, module = "momentous")]
pub(super) struct Report {
    pub(super) report: grade::Report,
    /// The same as JSON.
    pub(super) record: String,
}

/// What was found about one part.
#[pyclass(frozen, module = "momentous")]
pub(super) struct Part(grade::PartReport);

#[pymethods]
impl Report {
    /// The points reached.
    #[getter]
    pub(super) fn points(&self) -> f64 {
        self.report.total.0.to_f64().value()
    }

    /// The points that can be reached.
    #[getter]
    fn out_of(&self) -> u32 {
        self.report.out_of
    }

    /// The share of the points that was reached, from 0 to 1.
    #[getter]
    fn score(&self) -> f64 {
        if self.report.out_of == 0 { 0.0 } else { self.points() / f64::from(self.report.out_of) }
    }

    /// Whether every answer is right.
    #[getter]
    fn is_right(&self) -> bool {
        self.report.is_right()
    }

    /// The parts, in the order of the question.
    #[getter]
    fn parts(&self) -> Vec<Part> {
        self.report.parts.iter().cloned().map(Part).collect()
    }

    /// The report as `momentous grade --format json` writes it.
    fn record<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        of_json(py, &self.record)
    }

    fn __str__(&self) -> String {
        self.report.to_string().trim_end().to_owned()
    }

    fn __repr__(&self) -> String {
        format!("<Report {} of {}>", self.report.total, self.report.out_of)
    }
}

#[pymethods]
impl Part {
    /// The name of the part.
    #[getter]
    fn id(&self) -> &str {
        &self.0.id
    }

    /// The code of what was found: `right`, `sign`, `unit_missing`.
    #[getter]
    fn verdict(&self) -> &str {
        self.0.verdict.code()
    }

    /// Whether it is right.
    #[getter]
    fn is_right(&self) -> bool {
        self.0.verdict.is_right()
    }

    /// The points reached.
    #[getter]
    fn points(&self) -> f64 {
        self.0.points.0.to_f64().value()
    }

    /// The points that can be reached.
    #[getter]
    fn out_of(&self) -> u32 {
        self.0.out_of
    }

    /// What the student is told; it never holds the right value.
    #[getter]
    fn message(&self) -> &str {
        &self.0.message
    }

    /// What was understood of the answer; none where it cannot be read.
    #[getter]
    fn understood(&self) -> Option<&str> {
        self.0.understood.as_deref()
    }

    fn __repr__(&self) -> String {
        format!("<Part {}: {}, {} of {}>", self.0.id, self.0.verdict.code(), self.0.points, self.0.out_of)
    }
}

/// A text of JSON as objects of Python.
pub(super) fn of_json<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (text,))
}
