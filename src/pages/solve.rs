//! Worked solutions: of a variant, step by step or whole, and of values of the reader's own.

use serde::Serialize;

use momentous_exercise::Letter;
use momentous_exercise::calls::{Detail, GivenResponse, Refused, RefusedKind, SolveResponse, VariantRequest};

use super::parameters::Parameters;
use super::place::Place;
use super::view::View;

#[derive(Serialize)]
struct SolutionPage {
    title: String,
    place: Place,
    solved: SolveResponse,
    /// The number of steps that are shown; nothing where all are.
    shown: Option<usize>,
    /// Whether it says every step of the algebra and every check.
    is_full: bool,
}

/// The worked solution of a variant; `steps` shows so many and leaves the rest to the reader, `detail=full` says all that there is
/// to say.
pub(super) fn solution(view: &View<'_>, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let variant = fields.variant(problem)?;
    let steps = fields.number("steps")?.map(|steps| usize::try_from(steps).unwrap_or(usize::MAX));
    let engine = view.engine();
    let exercise = engine.draw(&variant)?;
    let is_full = fields.text("detail") == "full";
    let detail = if is_full { Detail::Full } else { Detail::Short };
    let solved = engine.solution_of(&exercise, steps, detail)?;
    let shown = steps.filter(|steps| *steps < solved.steps);
    let place = Place::of(&exercise, &variant)?;
    view.page("solution", &SolutionPage { title: solved.title.clone(), place, solved, shown, is_full })
}

#[derive(Serialize)]
struct SolvePage {
    title: String,
    place: Place,
    /// The givens with what was typed in their place.
    givens: Vec<GivenField>,
    /// The quantities sought, as they were typed.
    find: String,
    /// The quantities that have a name here, with what they are.
    letters: Vec<Letter>,
    solved: Option<SolveResponse>,
    /// Why there is no solution with these values, as sentences.
    refused: Option<Vec<String>>,
}

#[derive(Serialize)]
struct GivenField {
    given: GivenResponse,
    /// The quantity, in words.
    meaning: String,
    typed: String,
}

/// The solver for values of the reader's own: `set.m_A`, and `find` with names between spaces or commas.
pub(super) fn solve(view: &View<'_>, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let engine = view.engine();
    let asked = fields.variant(problem)?;
    let drawn = VariantRequest { set: [].into(), find: Vec::new(), ..asked.clone() };
    let exercise = engine.draw(&drawn)?;
    engine.problems.own_numbers(exercise.problem())?;
    let solved = asked.is_typed().then(|| {
        let exercise = engine.typed(exercise.problem(), exercise.variant().form(), &asked)?;
        engine.solution_of(&exercise, None, Detail::Short)
    });
    let (solved, refused) = match solved {
        None => (None, None),
        Some(Ok(solved)) => (Some(solved), None),
        // What the values do not allow is part of the page, beside the fields that hold them.
        Some(Err(refused)) if refused.kind == RefusedKind::Values => (None, Some(refused.sentences())),
        Some(Err(refused)) => return Err(refused),
    };
    let given = GivenResponse::all(&exercise).into_iter();
    let letters = exercise.letters_for_work();
    let meaning = |name: &str| letters.iter().find(|letter| letter.name == name).map(|letter| letter.meaning.clone());
    let typed = |name: &str| asked.set.get(name).cloned().unwrap_or_default();
    let page = SolvePage {
        title: exercise.problem().title().to_owned(),
        place: Place::of(&exercise, &drawn)?,
        givens: given
            .map(|given| GivenField {
                meaning: meaning(&given.name).unwrap_or_default(),
                typed: typed(&given.name),
                given,
            })
            .collect(),
        find: fields.text("find").to_owned(),
        letters,
        solved,
        refused,
    };
    view.page("solve", &page)
}
