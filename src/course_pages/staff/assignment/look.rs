//! A problem as students of the course would get it: three seeds side by side, with their answers.

use std::sync::Arc;

use serde::Serialize;

use momentous_course::Kind;
use momentous_exercise::Exercise;
use momentous_exercise::calls::{Refused, SheetResponse};
use momentous_problem::Problem;
use momentous_render::Fragment;

use super::super::super::items;
use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::super::super::withheld::Withheld;
use momentous_pages::{FormLink, Withheld as _};

/// The seeds that are shown.
const SEEDS: [u64; 3] = [1, 2, 3];

#[derive(Serialize)]
struct LookPage {
    title: String,
    problem: String,
    form: Option<String>,
    forms: Vec<FormLink>,
    looked: Vec<SampleSheet>,
    simulator: Option<&'static str>,
}

/// A variant with its answers.
#[derive(Serialize)]
pub(in crate::staff) struct SampleSheet {
    seed: u64,
    sheet: SheetResponse,
    answers: Vec<Answer>,
}

#[derive(Serialize)]
struct Answer {
    part: String,
    answer: Fragment,
}

/// A problem that an assignment can have.
pub(crate) async fn look(visit: &Visit) -> Result<Reply, NotShown> {
    let name = visit.fields.text("problem");
    Withheld::from_student(visit).await?.check(name)?;
    let problem = items::problem(visit, &items::unpinned(name)).await?;
    let first = problem.forms().first().and_then(|form| form.question.name.clone());
    let form = visit.fields.get("form").map(str::to_owned).or(first);
    let Some(place) = problem.form(form.as_deref()) else {
        return Err(NotShown::missing(format!("{} has no such form", problem.id())));
    };
    let looked = looked(visit, &problem, place).await?;
    let page = LookPage {
        title: problem.title().to_owned(),
        problem: problem.id().to_owned(),
        form,
        forms: FormLink::all(&problem),
        looked,
        simulator: Kind::of(problem.loaded()).simulator(),
    };
    visit.page("courses/staff/look", page).await
}

/// Three variants of a form.
pub(in crate::staff) async fn looked(
    visit: &Visit,
    problem: &Arc<Problem>,
    form: usize,
) -> Result<Vec<SampleSheet>, NotShown> {
    let problem = Arc::clone(problem);
    visit.work(move |_| Ok(SEEDS.map(|seed| one(&problem, form, seed)).into_iter().collect::<Result<_, _>>()?)).await
}

fn one(problem: &Arc<Problem>, form: usize, seed: u64) -> Result<SampleSheet, Refused> {
    let exercise = Exercise::draw(problem, form, seed)?;
    let answer = |row: momentous_render::KeyRow| Answer { part: row.part, answer: Fragment::inline(&row.answer) };
    let answers = exercise.key().into_iter().map(answer).collect();
    Ok(SampleSheet { seed, sheet: SheetResponse::of(&exercise)?, answers })
}
