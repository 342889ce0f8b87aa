//! Which variant a call is about.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Deserialize;
use serde::Serialize;

use momentous_fault::did_you_mean;
use momentous_problem::Problem;

use super::super::Exercise;
use super::Engine;
use super::limits::within;
use super::refused::{Refused, RefusedKind};

/// A variant by its problem, form and seed, or with values of the user's own: what `set` does not give is drawn from the seed.
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
    /// Values of the user's own, with their units.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub set: BTreeMap<String, String>,
    /// The quantities to find instead of what the form asks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub find: Vec<String>,
}

fn first_seed() -> u64 {
    1
}

impl VariantRequest {
    /// The variant of a seed.
    #[must_use]
    pub fn drawn(problem: &str, form: Option<&str>, seed: u64) -> Self {
        Self {
            problem: problem.to_owned(),
            form: form.map(str::to_owned),
            seed,
            set: BTreeMap::new(),
            find: Vec::new(),
        }
    }

    /// Whether anything of it is the user's own.
    #[must_use]
    pub fn is_typed(&self) -> bool {
        !self.set.is_empty() || !self.find.is_empty()
    }

    /// The problem and the position of the form.
    fn found(&self, engine: &Engine<'_>) -> Result<(Arc<Problem>, usize), Refused> {
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
    /// A variant, drawn or with values of the user's own, and solved.
    ///
    /// # Errors
    /// Where there is no such problem or form, the seed draws nothing, or the values cannot be read or leave no admissible solution.
    pub fn draw(&self, variant: &VariantRequest) -> Result<Exercise, Refused> {
        let (problem, form) = variant.found(self)?;
        if variant.is_typed() {
            return self.typed(&problem, form, variant);
        }
        Ok(Exercise::draw(&problem, form, variant.seed)?)
    }

    /// The same of a problem that was found, with the values of the user's own.
    ///
    /// # Errors
    /// Where there are too many values, they cannot be read, or they leave no admissible solution.
    pub fn typed(&self, problem: &Problem, form: usize, variant: &VariantRequest) -> Result<Exercise, Refused> {
        self.problems.own_numbers(problem)?;
        within(variant.set.len(), self.limits.values, "values can be set")?;
        within(variant.find.len(), self.limits.values, "quantities can be sought")?;
        let set: Vec<(String, String)> = variant.set.iter().map(|(name, text)| (name.clone(), text.clone())).collect();
        let typed = Exercise::typed(problem, form, variant.seed, &set, &variant.find);
        typed.map_err(|faults| Refused::values(&faults))
    }
}
