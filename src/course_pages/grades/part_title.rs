//! How the parts of a problem are called away from their sheet.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_exercise::PartLabel;
use momentous_problem::Problem;
use momentous_render::Fragment;

/// A part: its letter on the sheet, and what it asks, as `(a) the velocity of cart A after the collision`.
#[derive(Clone, Serialize)]
pub(super) struct PartTitle {
    pub(super) letter: String,
    asks: Fragment,
}

impl PartTitle {
    /// The parts of a form, by their names in answers; none where the problem has no such form.
    pub(super) fn all(problem: &Problem, form: Option<&str>) -> BTreeMap<String, Self> {
        let form = problem.form(form).and_then(|place| problem.forms().get(place));
        let labels = form.map(PartLabel::all).unwrap_or_default().into_iter();
        labels.map(|PartLabel { id, letter, asks }| (id, Self { letter, asks: Fragment::inline(&asks) })).collect()
    }
}
