//! The page of the editor.

use serde::Serialize;

use momentous_course::{Kind, Release, SolutionRelease, Solvers, Unsubmitted};
use momentous_store::AssignmentWithItems;

use super::super::super::items;
use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::super::course_form::Choice;
use super::super::form::Form;
use super::catalogue::{Catalogue, Offered};
use super::draft::{Draft, Row};
use super::homework::Refused;

#[derive(Serialize)]
struct EditorPage {
    title: &'static str,
    /// The assignment's key; nothing for a new one.
    key: Option<String>,
    /// When its problems were pinned, where they were.
    pinned: Option<String>,
    form: Form,
    rows: Vec<ShownRow>,
    /// The date in the file of the homework.
    date: Option<String>,
    /// The file of a homework that cannot be used, and why.
    homework: String,
    homework_faults: Option<String>,
    revision: String,
    verdicts: Vec<Choice>,
    solutions: Vec<Choice>,
    unsubmitted: Vec<Choice>,
    solvers: Vec<Choice>,
    zone: String,
    search: String,
    level: String,
    found: Option<Vec<Offered>>,
    saved: bool,
    /// Whether fields are at fault.
    wrong: bool,
}

/// A row with what the reader should know of its problem.
#[derive(Serialize)]
struct ShownRow {
    row: Row,
    title: String,
    forms: Vec<String>,
    /// The simulator that shows its scene.
    simulator: Option<&'static str>,
    /// Whether students have seen it, so that it stays.
    stays: bool,
}

/// The editor with these fields.
pub(super) async fn page(
    visit: &Visit,
    draft: Draft,
    catalogue: &Catalogue,
    before: Option<&AssignmentWithItems>,
) -> Result<Reply, NotShown> {
    with(visit, draft, catalogue, before, None).await
}

/// The editor of a new assignment beside a homework that cannot be used.
pub(super) async fn refused(visit: &Visit, homework: Refused, catalogue: &Catalogue) -> Result<Reply, NotShown> {
    with(visit, Draft::empty(visit.now, &visit.course()?.zone), catalogue, None, Some(homework)).await
}

async fn with(
    visit: &Visit,
    draft: Draft,
    catalogue: &Catalogue,
    before: Option<&AssignmentWithItems>,
    homework: Option<Refused>,
) -> Result<Reply, NotShown> {
    let is_pinned = before.is_some_and(|before| before.assignment.pinned.is_some());
    let is_kept =
        |key: &str| before.is_some_and(|assignment| assignment.items.iter().any(|item| item.key.to_string() == key));
    let wrong = draft.is_wrong();
    let is_refused = homework.is_some();
    let (homework, homework_faults) = homework.map_or_else(Default::default, |read| (read.text, Some(read.faults)));
    let mut rows = Vec::new();
    for (row, order) in draft.rows.into_iter().zip(1_u32..) {
        let offered = catalogue.find(&row.problem).map(|offered| &offered.card);
        let simulator = match offered {
            Some(_) => simulator(visit, &row.problem).await?,
            None => None,
        };
        rows.push(ShownRow {
            title: offered.map_or_else(|| row.problem.clone(), |card| card.title.clone()),
            forms: offered.map(|card| card.forms.clone()).unwrap_or_default(),
            simulator,
            stays: is_pinned && is_kept(&row.key),
            row: if row.fault.is_some() { row } else { Row { order: order.to_string(), ..row } },
        });
    }
    let field = |name: &str| visit.fields.text(name).to_owned();
    let (search, level) = (field("search"), field("level"));
    let is_sought = field("do") == "search" || !search.is_empty() || !level.is_empty();
    let results = is_sought.then(|| catalogue.search(&search, &level));
    let zone = &visit.course()?.zone;
    let page = EditorPage {
        title: if before.is_some() { "Edit the assignment" } else { "New assignment" },
        key: before.map(|before| before.assignment.key.to_string()),
        pinned: before.and_then(|before| before.assignment.pinned).map(|at| at.shown(zone)),
        form: draft.form,
        rows,
        date: draft.date,
        homework,
        homework_faults,
        revision: draft.revision,
        verdicts: Release::ALL.map(|release| Choice { name: release.name(), said: verdicts_said(release) }).into(),
        solutions: SolutionRelease::ALL
            .map(|release| Choice { name: release.name(), said: solutions_said(release) })
            .into(),
        unsubmitted: Unsubmitted::ALL
            .map(|unsubmitted| Choice { name: unsubmitted.name(), said: unsubmitted_said(unsubmitted) })
            .into(),
        solvers: Solvers::ALL.map(|solvers| Choice { name: solvers.name(), said: solvers_said(solvers) }).into(),
        zone: zone.clone(),
        search,
        level,
        found: results,
        saved: !wrong && visit.fields.get("saved").is_some(),
        wrong,
    };
    let page = visit.page("courses/staff/editor", page).await?;
    Ok(if wrong || is_refused { page.wrong() } else { page })
}

fn verdicts_said(release: Release) -> &'static str {
    match release {
        Release::AtOnce => "at once",
        Release::AtClose => "when it has closed for them",
    }
}

fn solutions_said(release: SolutionRelease) -> &'static str {
    match release {
        SolutionRelease::AtClose => "when it has closed for them",
        SolutionRelease::Never => "never",
    }
}

fn unsubmitted_said(unsubmitted: Unsubmitted) -> &'static str {
    match unsubmitted {
        Unsubmitted::Leave => "do not count",
        Unsubmitted::HandIn => "are submitted as last saved",
    }
}

fn solvers_said(solvers: Solvers) -> &'static str {
    match solvers {
        Solvers::Shown => "go on solving",
        Solvers::Hidden => "solve nothing of these kinds",
    }
}

/// The simulator that shows the scene of a problem.
async fn simulator(visit: &Visit, problem: &str) -> Result<Option<&'static str>, NotShown> {
    let item = items::unpinned(problem);
    Ok(items::problem(visit, &item).await.ok().and_then(|problem| Kind::of(problem.loaded()).simulator()))
}
