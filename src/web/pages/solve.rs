//! Worked solutions: of a variant, step by step or whole, and of values of the reader's own.

use serde::Serialize;

use crate::exercise::calls::{GivenResponse, Refused, RefusedKind, SolveRequest, SolveResponse};

use super::super::app::App;
use super::super::parameters::Parameters;
use super::Place;

#[derive(Serialize)]
struct SolutionPage {
    title: String,
    place: Place,
    solved: SolveResponse,
    /// How many steps are shown; nothing where all are.
    shown: Option<usize>,
}

/// The worked solution of a variant; `steps` shows so many and leaves the rest to the reader.
pub(in crate::web) fn solution(app: &App, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let variant = fields.variant(problem)?;
    let steps = fields.number("steps")?.map(|steps| usize::try_from(steps).unwrap_or(usize::MAX));
    let request = SolveRequest { steps, ..plain(variant.clone()) };
    let solved = app.engine().solve(&request)?;
    let shown = steps.filter(|steps| *steps < solved.steps);
    app.page("solution", &SolutionPage { title: solved.title.clone(), place: Place::of(app, &variant)?, solved, shown })
}

fn plain(variant: crate::exercise::calls::VariantRequest) -> SolveRequest {
    SolveRequest { variant, set: [].into(), find: Vec::new(), steps: None, brief: false }
}

#[derive(Serialize)]
struct SolvePage {
    title: String,
    place: Place,
    /// The givens with what was typed in their place.
    givens: Vec<GivenField>,
    /// The quantities sought, as they were typed.
    find: String,
    solved: Option<SolveResponse>,
    /// Why there is no solution with these values, as sentences.
    refused: Option<Vec<String>>,
}

#[derive(Serialize)]
struct GivenField {
    given: GivenResponse,
    typed: String,
}

/// The solver for values of the reader's own: `set.m_A`, and `find` with names between spaces or commas.
pub(in crate::web) fn solve(app: &App, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let engine = app.engine();
    let variant = fields.variant(problem)?;
    let title = app.engine().sheet(&variant)?.title;
    let set = fields.behind("set.");
    let find = fields.get("find").unwrap_or_default().to_owned();
    let names = find.split([' ', ',']).filter(|name| !name.is_empty()).map(str::to_owned).collect::<Vec<_>>();
    let asked = SolveRequest { set: set.clone(), find: names, ..plain(variant.clone()) };
    let is_asked = !asked.set.is_empty() || !asked.find.is_empty();
    let (solved, refused) = match is_asked.then(|| engine.solve(&asked)) {
        None => (None, None),
        Some(Ok(solved)) => (Some(solved), None),
        // What the values do not allow is part of the page, beside the fields that hold them.
        Some(Err(refused)) if refused.kind == RefusedKind::Values => (None, Some(refused.sentences())),
        Some(Err(refused)) => return Err(refused),
    };
    let given = engine.givens(&variant)?.into_iter();
    let givens = given.map(|given| GivenField { typed: set.get(&given.name).cloned().unwrap_or_default(), given });
    let givens = givens.collect();
    app.page("solve", &SolvePage { title, place: Place::of(app, &variant)?, givens, find, solved, refused })
}
