//! The pages: each takes the fields of its address or form, asks the engine, and fills a template.

mod play;
mod practice;
mod simulator;
mod solve;
mod start;

pub(super) use play::play;
pub(super) use practice::practice;
pub(super) use simulator::simulator;
pub(super) use solve::{solution, solve};
pub(super) use start::start;

use serde::Serialize;

use crate::exercise::calls::{Problems, Refused, VariantRequest};

use super::app::App;

/// Which variant a page shows, and its neighbours.
#[derive(Serialize)]
pub(super) struct Place {
    /// The problem's identity.
    problem: String,
    /// The form's name.
    form: Option<String>,
    /// The seed.
    seed: u64,
    /// The seed of the next numbers.
    next_seed: u64,
    /// The forms of the problem that have names.
    forms: Vec<String>,
    /// The part of an address that names the variant: `form=forward&seed=1`.
    query: String,
}

impl Place {
    fn of(app: &App, variant: &VariantRequest) -> Result<Self, Refused> {
        let problem = app.library.problem(&variant.problem)?;
        let forms: Vec<String> = problem.forms().iter().filter_map(|form| form.question.name.clone()).collect();
        let form = variant.form.clone().or_else(|| forms.first().cloned());
        // The language allows only letters, digits and hyphens in the names of forms.
        let named = form.as_ref().map_or_else(String::new, |form| format!("form={form}&"));
        let query = format!("{named}seed={}", variant.seed);
        Ok(Self {
            problem: variant.problem.clone(),
            form,
            seed: variant.seed,
            next_seed: variant.seed.wrapping_add(1),
            forms,
            query,
        })
    }
}
