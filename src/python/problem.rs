//! A problem, from which variants are drawn.

use std::sync::Arc;

use momentous::bank::load_in_course;
use momentous::exercise::{Exercise, SheetSeed};
use momentous::fault::{Code, Fault, Faults, Source, unknown_name};
use momentous::problem;
use momentous::problem::compile;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;

use super::error;
use super::variant::Variant;

/// A seed as a program has it, or as it stands on a sheet.
#[derive(FromPyObject)]
pub(super) enum Seed {
    /// `7`
    Number(u64),
    /// `"7"`, or `"7-kmbtrs"` where a secret was used
    Text(String),
}

/// What is in the scene, and what is asked: numbers for it come from a seed.
#[pyclass(frozen, module = "momentous")]
pub(super) struct Problem(pub(super) Arc<problem::Problem>);

#[pymethods]
impl Problem {
    /// A problem of the text of its file; the name stands in messages.
    #[new]
    #[pyo3(signature = (text, *, name="problem.yaml", secret=None))]
    fn new(py: Python<'_>, text: &str, name: &str, secret: Option<PyBackedBytes>) -> PyResult<Self> {
        let source = Source::new(name, text);
        py.detach(move || compiled(source, secret.as_deref())).map_err(|faults| error::of_faults(py, &faults))
    }

    /// The identity: `impact/two-carts`.
    #[getter]
    fn id(&self) -> &str {
        self.0.id()
    }

    /// The title.
    #[getter]
    fn title(&self) -> &str {
        self.0.title()
    }

    /// The names of its forms; empty where it has one form without a name.
    #[getter]
    fn forms(&self) -> Vec<&str> {
        self.0.forms().iter().filter_map(|form| form.question.name.as_deref()).collect()
    }

    /// Draws the numbers of a seed and solves them; the first form if none is named.
    #[pyo3(signature = (seed, *, form=None))]
    fn variant(&self, py: Python<'_>, seed: Seed, form: Option<&str>) -> PyResult<Variant> {
        self.drawn(py, seed, form, SheetSeed::of)
    }

    fn __repr__(&self) -> String {
        format!("<Problem {}>", self.0.id())
    }
}

impl Problem {
    /// The variant whose seed was copied from a sheet.
    pub(super) fn of_a_sheet(&self, py: Python<'_>, seed: Seed, form: Option<&str>) -> PyResult<Variant> {
        self.drawn(py, seed, form, SheetSeed::of_a_sheet)
    }

    fn drawn(
        &self,
        py: Python<'_>,
        seed: Seed,
        form: Option<&str>,
        number: fn(&SheetSeed, &problem::Problem) -> Result<u64, String>,
    ) -> PyResult<Variant> {
        let drawn = py.detach(move || self.draw(&seed, form, number));
        drawn.map(Variant).map_err(|message| error::of_message(py, &message))
    }

    /// Draws and solves; the seed is read as a program's own, or as one that was copied from a sheet.
    pub(super) fn draw(
        &self,
        seed: &Seed,
        form: Option<&str>,
        number: fn(&SheetSeed, &problem::Problem) -> Result<u64, String>,
    ) -> Result<Exercise, String> {
        let seed = match seed {
            Seed::Number(number) => SheetSeed { number: *number, mark: None },
            Seed::Text(text) => text.parse()?,
        };
        let seed = number(&seed, &self.0)?;
        let unknown = || match form {
            Some(name) => unknown_name(name, &format!("form of {}", self.0.id()), &self.forms()),
            None => format!("{} asks for nothing", self.0.id()),
        };
        let form = self.0.form(form).ok_or_else(unknown)?;
        Exercise::draw(&self.0, form, seed).map_err(|reason| format!("{}, seed {seed}: {reason}", self.0.id()))
    }
}

/// Reads and compiles a problem file. The line end that an editor leaves behind a secret is no part of it.
pub(super) fn compiled(source: Source, secret: Option<&[u8]>) -> Result<Problem, Faults> {
    let secret = secret.map(<[u8]>::trim_ascii_end);
    if secret.is_some_and(<[u8]>::is_empty) {
        let fault =
            Fault::new(Code::Value, "the secret is empty").help("read it from the file: `momentous secret` writes one");
        return Err(Faults { source: Source::new("secret", ""), list: vec![fault] });
    }
    let problem = load_in_course(source).and_then(|loaded| compile(loaded, secret))?;
    Ok(Problem(Arc::new(problem)))
}
