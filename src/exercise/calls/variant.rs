//! Which variant a call is about.

use std::sync::Arc;

use serde::Deserialize;
use serde::Serialize;

use crate::fault::did_you_mean;
use crate::problem::Problem;

use super::super::Exercise;
use super::Engine;
use super::refused::{Refused, RefusedKind};

/// A variant by its problem, form and seed.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct VariantRequest {
    /// The problem's identity.
    pub problem: String,
    /// The form's name; the first where none is named.
    #[serde(default)]
    pub form: Option<String>,
    /// The seed, 1 where none is named.
    #[serde(default = "first_seed")]
    pub seed: u64,
}

fn first_seed() -> u64 {
    1
}

impl VariantRequest {
    /// The problem and the position of the form.
    pub(super) fn find(&self, engine: &Engine<'_>) -> Result<(Arc<Problem>, usize), Refused> {
        let problem = engine.problems.problem(&self.problem)?;
        let name = self.form.as_deref().filter(|name| !name.is_empty());
        let Some(form) = problem.form(name) else {
            let names: Vec<&str> = problem.forms().iter().filter_map(|form| form.question.name.as_deref()).collect();
            let name = name.unwrap_or_default();
            let help = match did_you_mean(name, names.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None if names.is_empty() => "it has one form, without a name".to_owned(),
                None => format!("its forms are {}", names.join(", ")),
            };
            let message = format!("{} has no form `{name}`", problem.id());
            return Err(Refused::new(RefusedKind::Unknown, message).help(help));
        };
        Ok((problem, form))
    }
}

impl Engine<'_> {
    /// A variant, drawn and solved.
    ///
    /// # Errors
    /// Where there is no such problem or form, or the seed draws nothing.
    pub fn draw(&self, variant: &VariantRequest) -> Result<Exercise, Refused> {
        let (problem, form) = variant.find(self)?;
        Ok(Exercise::draw(&problem, form, variant.seed)?)
    }
}
