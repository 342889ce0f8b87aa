//! Worked solutions, of a variant or of values of the user's own.

use serde::Deserialize;
use serde::Serialize;

use momentous_explain::Audience;
use momentous_explain::Detail;
use momentous_problem::PartKind;
use momentous_render as render;
use momentous_render::Fragment;
use momentous_render::Identity;
use momentous_render::Page;
use momentous_render::Solution;

use super::super::Exercise;
use super::Engine;
use super::refused::Refused;
use super::variant::VariantRequest;

/// Asks for a worked solution.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct SolveRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// Only so many steps; the rest is left to the reader.
    #[serde(default)]
    pub steps: Option<usize>,
    /// Every step of the algebra in symbols, what acts and what is neglected, and all checks.
    #[serde(default)]
    pub detailed: bool,
}

/// A worked solution.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolveResponse {
    /// The problem's title.
    pub title: String,
    /// The solution.
    pub solution: Fragment,
    /// The number of steps that can be shown one by one.
    pub steps: usize,
    /// The answers; empty while steps are left to the reader.
    pub answers: Vec<SolvedPart>,
}

/// An answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolvedPart {
    /// The name of the part in answers.
    pub id: String,
    /// The answer as it is printed.
    pub printed: String,
    /// The number in the unit of the question, where it is one.
    pub value: Option<f64>,
}

impl Engine<'_> {
    /// The worked solution of a variant.
    ///
    /// # Errors
    /// As for a sheet.
    pub fn solve(&self, request: &SolveRequest) -> Result<SolveResponse, Refused> {
        let detail = if request.detailed { Detail::Full } else { Detail::Short };
        self.solution_of(&self.draw(&request.variant)?, request.steps, detail)
    }

    /// The worked solution of a variant that was drawn: of so many steps, or whole.
    ///
    /// # Errors
    /// Where it is not fit to print.
    pub fn solution_of(
        &self,
        exercise: &Exercise,
        steps: Option<usize>,
        detail: Detail,
    ) -> Result<SolveResponse, Refused> {
        let outline = exercise.outline(Audience::Everyone, detail);
        let (title, all) = (outline.title.clone(), render::steps(&outline));
        let faded = steps.filter(|steps| *steps < all);
        // The page around it says which numbers these are, in words for students.
        let identity = Identity::default();
        let solution = Solution { outline, identity, audience: Audience::Everyone, faded };
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
pub(super) fn answers(exercise: &Exercise) -> Vec<SolvedPart> {
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
