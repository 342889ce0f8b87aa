//! The givens of a form, for whoever wants to put values of their own in their place.

use serde::Serialize;

use momentous_problem::say_quantity;
use momentous_render::Fragment;

use super::super::Exercise;
use super::Engine;
use super::refused::Refused;
use super::variant::VariantRequest;

/// Asks for the givens.
pub type GivensRequest = VariantRequest;

/// A quantity whose value is given, and may be set.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GivenResponse {
    /// Its name in the file.
    pub name: String,
    /// Its symbol.
    pub symbol: Fragment,
    /// Its value with this seed, as it may be typed.
    pub value: String,
}

impl Engine<'_> {
    /// The givens of a variant, in the order of the file; what is given by its symbol alone has no value to set.
    ///
    /// # Errors
    /// As for a sheet.
    pub fn givens(&self, request: &GivensRequest) -> Result<Vec<GivenResponse>, Refused> {
        Ok(GivenResponse::all(&self.draw(request)?))
    }
}

impl GivenResponse {
    /// The givens of a variant that was drawn.
    #[must_use]
    pub fn all(exercise: &Exercise) -> Vec<Self> {
        let problem = exercise.problem();
        let is_literal = |symbol| problem.model().literals.iter().any(|(literal, _)| *literal == symbol);
        let given = exercise.variant().all_given();
        let set =
            given.iter().filter(|(symbol, ..)| !is_literal(*symbol) && !exercise.worked().form.free.contains(symbol));
        let shown = set.map(|(symbol, value, unit)| Self {
            name: problem.model().symbols.entry(*symbol).name.clone(),
            symbol: Fragment::math(&problem.math_of(*symbol)),
            value: say_quantity(value, unit),
        });
        shown.collect()
    }
}
