//! The problems of which sheets are wanted, each in one form.

use std::sync::Arc;

use crate::cli::failure::Failure;
use crate::cli::open;
use crate::problem::Problem;

use super::names;

/// A problem with the form in which it is asked.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    pub problem: Arc<Problem>,
    pub form: usize,
    /// Its part of the names of files: `impact-two-carts-find-e`.
    pub stem: String,
}

impl Asked {
    /// Each problem in the form of that name, or in its first.
    pub(super) fn all(problems: &[Arc<Problem>], form: Option<&str>) -> Result<Vec<Self>, Failure> {
        let forms = problems.iter().map(|problem| open::form(problem, form)).collect::<Result<Vec<usize>, _>>()?;
        let texts: Vec<String> = problems.iter().zip(&forms).map(|(problem, form)| said(problem, *form)).collect();
        let stems = names::distinct(&texts);
        let asked = problems.iter().zip(forms).zip(stems);
        Ok(asked.map(|((problem, form), stem)| Self { problem: Arc::clone(problem), form, stem }).collect())
    }

    /// The name of the form; empty where the problem has one form without a name.
    pub(super) fn form_name(&self) -> &str {
        form_name(&self.problem, self.form)
    }
}

fn form_name(problem: &Problem, form: usize) -> &str {
    problem.forms().get(form).and_then(|form| form.question.name.as_deref()).unwrap_or_default()
}

/// Problem and form in a line.
pub(super) fn said(problem: &Problem, form: usize) -> String {
    format!("{} {}", problem.id(), form_name(problem, form)).trim_end().to_owned()
}
