//! Which variant a page shows, and its neighbours.

use serde::Serialize;

use momentous_exercise::calls::{Refused, RefusedKind, VariantRequest};
use momentous_exercise::{Exercise, FormLabel};
use momentous_problem::Problem;
use momentous_render::Fragment;

/// Which variant a page shows, and its neighbours.
#[derive(Serialize)]
pub(super) struct Place {
    /// The problem's identity.
    problem: String,
    /// The form's name.
    form: Option<String>,
    /// The seed; nothing where every value is the reader's own.
    seed: Option<u64>,
    /// The seed of the next numbers.
    next_seed: u64,
    /// The forms of the problem that have names; none where the values are the reader's own, which may not fit another form.
    forms: Vec<FormLink>,
    /// The part of an address that names the variant: `form=forward&seed=1`.
    query: String,
    /// The same as the fields of a form.
    fields: Vec<(String, String)>,
    /// The same as calls of the engine take it.
    variant: String,
}

/// A form of the problem, and what it asks.
#[derive(Serialize)]
pub struct FormLink {
    name: String,
    label: Fragment,
}

impl FormLink {
    /// The forms of a problem that have names.
    #[must_use]
    pub fn all(problem: &Problem) -> Vec<Self> {
        let link = |FormLabel { name, label }| Self { label: Fragment::inline(&label), name };
        FormLabel::all(problem).into_iter().map(link).collect()
    }
}

impl Place {
    pub(super) fn of(exercise: &Exercise, variant: &VariantRequest) -> Result<Self, Refused> {
        let forms = if variant.is_typed() { Vec::new() } else { FormLink::all(exercise.problem()) };
        let form = exercise.worked().form.question.name.clone();
        let mut fields: Vec<(String, String)> = form.iter().map(|form| ("form".to_owned(), form.clone())).collect();
        let seed = exercise.variant().seed();
        fields.extend(seed.map(|seed| ("seed".to_owned(), seed.to_string())));
        fields.extend(variant.set.iter().map(|(name, value)| (format!("set.{name}"), value.clone())));
        if !variant.find.is_empty() {
            fields.push(("find".to_owned(), variant.find.join(" ")));
        }
        let broken = |error: &dyn std::error::Error| Refused::new(RefusedKind::Fault, error.to_string());
        Ok(Self {
            problem: variant.problem.clone(),
            form,
            seed,
            next_seed: seed.map_or(1, |seed| seed.wrapping_add(1)),
            forms,
            query: serde_urlencoded::to_string(&fields).map_err(|error| broken(&error))?,
            fields,
            variant: serde_json::to_string(variant).map_err(|error| broken(&error))?,
        })
    }
}
