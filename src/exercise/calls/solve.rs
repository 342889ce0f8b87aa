//! Worked solutions, of a variant or of values of the user's own.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::Serialize;

use crate::explain::Audience;
use crate::problem::PartKind;
use crate::render::Fragment;
use crate::render::Page;
use crate::render::Solution;
use crate::render::steps;

use super::super::Exercise;
use super::Engine;
use super::limits::within;
use super::refused::Refused;
use super::variant::VariantRequest;

/// Asks for a worked solution.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct SolveRequest {
    /// The variant; what `set` does not give is drawn from its seed.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// Values of the user's own, with their units.
    #[serde(default)]
    pub set: BTreeMap<String, String>,
    /// What to find instead of what the form asks.
    #[serde(default)]
    pub find: Vec<String>,
    /// Only so many steps; the rest is left to the reader.
    #[serde(default)]
    pub steps: Option<usize>,
    /// The solution on one page: laws, equations with numbers and answers.
    #[serde(default)]
    pub brief: bool,
}

/// A worked solution.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolveResponse {
    /// The problem's title.
    pub title: String,
    /// The solution.
    pub solution: Fragment,
    /// How many steps can be shown one by one.
    pub steps: usize,
    /// The answers; empty while steps are left to the reader.
    pub answers: Vec<SolvedPart>,
}

/// An answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolvedPart {
    /// How the part is called in answers.
    pub id: String,
    /// The answer as it is printed.
    pub printed: String,
    /// The number in the unit of the question, where it is one.
    pub value: Option<f64>,
}

impl SolveRequest {
    /// The variant with the user's own values, solved.
    pub(super) fn solve(&self, engine: &Engine<'_>) -> Result<Exercise, Refused> {
        if self.set.is_empty() && self.find.is_empty() {
            return engine.draw(&self.variant);
        }
        within(self.set.len(), engine.limits.values, "values can be set")?;
        within(self.find.len(), engine.limits.values, "quantities can be sought")?;
        let (problem, form) = self.variant.find(engine)?;
        let set: Vec<(String, String)> = self.set.iter().map(|(name, text)| (name.clone(), text.clone())).collect();
        let solved = Exercise::with_values(&problem, form, self.variant.seed, &set, &self.find);
        solved.map_err(|faults| Refused::values(&faults))
    }
}

impl Engine<'_> {
    /// The worked solution of a variant.
    ///
    /// # Errors
    /// As for a sheet, and where the values of the user's own cannot be read or leave no admissible solution.
    pub fn solve(&self, request: &SolveRequest) -> Result<SolveResponse, Refused> {
        self.solution_of(&request.solve(self)?, request)
    }

    /// The solution of an exercise, as the request wants to see it.
    pub(super) fn solution_of(&self, exercise: &Exercise, request: &SolveRequest) -> Result<SolveResponse, Refused> {
        let outline = if request.brief { exercise.brief() } else { exercise.outline(Audience::Everyone) };
        let (title, all) = (outline.title.clone(), steps(&outline));
        let faded = request.steps.filter(|steps| *steps < all);
        let solution = Solution { outline, identity: exercise.identity(), audience: Audience::Everyone, faded };
        let solution = Fragment::page(self.renderer, &Page::Solution(solution));
        Ok(SolveResponse {
            title,
            solution: solution.map_err(|faults| Refused::fault(&faults))?,
            steps: all,
            answers: if faded.is_some() { Vec::new() } else { answers(exercise) },
        })
    }
}

/// The answers to all parts.
fn answers(exercise: &Exercise) -> Vec<SolvedPart> {
    let worked = exercise.worked();
    let solved = worked.form.parts.iter().map(|part| SolvedPart {
        id: part.id.clone(),
        printed: exercise.printed(part),
        value: match &part.kind {
            PartKind::Number(number) => Some(worked.answer(number).or_zero()),
            PartKind::Vector(_) | PartKind::Formula(_) | PartKind::Range(_) | PartKind::Choice(_) => None,
        },
    });
    solved.collect()
}
