//! A variant: the sheet, the solution, the answers, the figure, and marks.

use momentous::exercise::Exercise;
use momentous::explain::{Audience, Detail};
use momentous::fault::Faults;
use momentous::figure::svg_file;
use momentous::grade::{DecimalMark, Sitting};
use momentous::render::{Document, Format, Renderer, Solution};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

use super::error;
use super::report::{Report, of_json};

/// The numbers of one seed, solved.
#[pyclass(frozen, module = "momentous")]
pub(super) struct Variant(pub(super) Exercise);

#[pymethods]
impl Variant {
    /// The identity of the problem.
    #[getter]
    fn problem(&self) -> &str {
        self.0.problem().id()
    }

    /// The name of the form; none where the problem has one form without a name.
    #[getter]
    fn form(&self) -> Option<&str> {
        self.0.worked().form.question.name.as_deref()
    }

    /// The seed.
    #[getter]
    fn seed(&self) -> Option<u64> {
        self.0.variant().seed()
    }

    /// What the student is given, as a document: markdown, html, latex or typst.
    #[pyo3(signature = (format="markdown"))]
    fn sheet(&self, py: Python<'_>, format: &str) -> PyResult<String> {
        printed(py, format, |renderer, format| renderer.render_sheets(&[self.0.sheet()], format))
    }

    /// The worked solution, as a document.
    #[pyo3(signature = (format="markdown", *, detailed=false, instructor=false, faded=None))]
    fn solution(
        &self,
        py: Python<'_>,
        format: &str,
        detailed: bool,
        instructor: bool,
        faded: Option<usize>,
    ) -> PyResult<String> {
        let audience = if instructor { Audience::Instructor } else { Audience::Everyone };
        let detail = if detailed { Detail::Full } else { Detail::Short };
        printed(py, format, |renderer, format| {
            let (outline, identity) = (self.0.outline(audience, detail), self.0.identity());
            renderer.render_solution(&Solution { outline, identity, audience, faded }, format)
        })
    }

    /// The right answers, each as it is printed, by the names of the parts.
    fn answers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let answers = PyDict::new(py);
        for part in &self.0.worked().form.parts {
            answers.set_item(&part.id, self.0.printed(part))?;
        }
        Ok(answers)
    }

    /// The figure of the sheet as SVG; none where there is nothing to show.
    fn figure(&self, py: Python<'_>) -> Option<String> {
        py.detach(|| self.0.sheet().figure.map(|drawing| svg_file(&drawing)))
    }

    /// The variant as `momentous generate --format json` writes it.
    fn record<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        of_json(py, &py.detach(|| self.0.record(None).to_string()))
    }

    /// Marks answers, by the names of the parts.
    #[pyo3(signature = (answers, *, decimal="point", hints=0, closed=false))]
    pub(super) fn mark(
        &self,
        py: Python<'_>,
        answers: &Bound<'_, PyMapping>,
        decimal: &str,
        hints: usize,
        closed: bool,
    ) -> PyResult<Report> {
        let answers: Vec<(String, String)> = answers.items()?.extract()?;
        let marked = py.detach(|| marked(&self.0, &answers, decimal_mark(decimal)?, Sitting { hints, closed }));
        marked.map_err(|message| error::of_message(py, &message))
    }

    /// The sheet for a page of somebody else, such as a notebook's: a document in a frame, so that neither changes the other's style.
    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        let escaped = |text: &str| text.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
        let (title, sheet) = (escaped(self.0.problem().title()), escaped(&self.sheet(py, Format::Html.name())?));
        Ok(format!("<iframe title=\"{title}\" style=\"width:100%;height:36em;border:0\" srcdoc=\"{sheet}\"></iframe>"))
    }

    fn __repr__(&self) -> String {
        let seed = self.seed().map(|seed| format!("seed {seed}"));
        let named = [Some(self.problem().to_owned()), self.form().map(str::to_owned), seed];
        format!("<Variant of {}>", named.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

/// The decimal mark of that name.
pub(super) fn decimal_mark(name: &str) -> Result<DecimalMark, String> {
    match name {
        "point" => Ok(DecimalMark::Point),
        "comma" => Ok(DecimalMark::Comma),
        other => Err(format!("`{other}` is not a decimal mark\nhelp: choose one of point, comma")),
    }
}

/// The report on answers, by the names of the parts.
pub(super) fn marked(
    exercise: &Exercise,
    answers: &[(String, String)],
    decimal: DecimalMark,
    sitting: Sitting,
) -> Result<Report, String> {
    let typed = answers.iter().map(|(name, text)| (name.as_str(), text.as_str()));
    let answers = exercise.answers_by_part(typed).map_err(|faults| faults.join("\n"))?;
    let report = exercise.mark(&answers, decimal, sitting);
    let record = exercise.mark_record(&report).map_err(|error| error.to_string())?;
    Ok(Report { report, record: record.to_string() })
}

/// A document by the built-in templates.
fn printed(
    py: Python<'_>,
    format: &str,
    document: impl Fn(&Renderer, Format) -> Result<Document, Faults> + Send + Sync,
) -> PyResult<String> {
    let format: Format = format.parse().map_err(|message: String| error::of_message(py, &message))?;
    let document = py.detach(|| document(&Renderer::new(None)?.with_font(), format));
    document.map(|document| document.text).map_err(|faults| error::of_faults(py, &faults))
}
