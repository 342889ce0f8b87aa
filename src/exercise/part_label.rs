//! What the parts of a form are called away from their sheet.

use momentous_explain::Inline;
use momentous_problem::Part;
use momentous_problem::PlannedForm;
use momentous_problem::part_letter;

/// A part of a form, as `(a) the velocity of cart A after the collision`.
#[derive(Clone, Debug, PartialEq)]
pub struct PartLabel {
    /// What the part is called in answers.
    pub id: String,
    /// Its letter on the sheet.
    pub letter: String,
    /// What it asks.
    pub asks: Vec<Inline>,
}

impl PartLabel {
    /// The parts of a form, in their order.
    #[must_use]
    pub fn all(form: &PlannedForm) -> Vec<Self> {
        let parts = form.parts.iter().enumerate();
        let label = |(place, part): (usize, &Part)| Self {
            id: part.id.clone(),
            letter: part_letter(place),
            asks: Inline::line(&part.label),
        };
        parts.map(label).collect()
    }
}
