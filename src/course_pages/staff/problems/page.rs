//! A problem of the course: three variants side by side, its file, and what a check says of it.

use serde::Serialize;

use momentous_course::{Item, ProblemFile};

use super::super::super::items;
use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::super::super::withheld::Withheld;
use super::super::assignment::{SampleSheet, looked};
use super::check::{Checked, run};
use momentous_pages::{FormLink, Withheld as _};

#[derive(Serialize)]
struct ProblemPage {
    title: String,
    problem: String,
    digest: String,
    text: String,
    published: Option<String>,
    forms: Vec<FormLink>,
    form: Option<String>,
    looked: Vec<SampleSheet>,
    checked: Option<Checked>,
}

/// The page.
pub(crate) async fn show(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, super::file_of(visit).await?, None).await
}

async fn with(visit: &Visit, file: ProblemFile, checked: Option<Checked>) -> Result<Reply, NotShown> {
    Withheld::from_student(visit).await?.check(&file.problem)?;
    let letters = items::letters(visit, &file).await?;
    let item = Item { digest: Some(file.digest.clone()), letters, ..items::unpinned(&file.problem) };
    let problem = items::problem(visit, &item).await?;
    let first = problem.forms().first().and_then(|form| form.question.name.clone());
    let form = visit.fields.get("form").map(str::to_owned).or(first);
    let Some(place) = problem.form(form.as_deref()) else {
        return Err(NotShown::missing(format!("{} has no such form", problem.id())));
    };
    let zone = &visit.course()?.zone;
    let page = ProblemPage {
        title: problem.title().to_owned(),
        problem: file.problem,
        digest: file.digest,
        text: file.text,
        published: file.published.map(|at| at.shown(zone)),
        forms: FormLink::all(&problem),
        form,
        looked: looked(visit, &problem, place).await?,
        checked,
    };
    visit.page("courses/staff/problem", page).await
}

/// Checks what the problem promises, over many seeds.
pub(crate) async fn check(visit: &Visit) -> Result<Reply, NotShown> {
    let file = super::file_of(visit).await?;
    let checked = run(visit, &file).await?;
    with(visit, file, Some(checked)).await
}

/// From now on assignments of the course can have it. Those that are open keep the version that they have.
pub(crate) async fn publish(visit: &Visit) -> Result<Reply, NotShown> {
    let file = ProblemFile { published: Some(visit.now), ..super::file_of(visit).await? };
    let entry = visit.entry("problem published", format!("{} {}", file.problem, file.digest));
    visit.store().save_problem_file(&file, Some(&entry)).await?;
    Ok(Reply::To(visit.in_course(&format!("/problems/{}", file.digest))?))
}
