//! A course and its assignments as a student sees them.

use serde::Serialize;

use momentous_course::{Assignment, GradeMark, Item, Part, Phase, Standing, Window};
use momentous_grade::Points;

use super::super::at_close;
use super::super::grades;
use super::super::ledger::{Has, Records};
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;

#[derive(Serialize)]
struct CoursePage {
    title: String,
    assignments: Vec<OwnAssignment>,
    /// The grade so far, in percent; nothing for those who teach, and as long as nothing counts.
    grade: Option<String>,
}

#[derive(Serialize)]
struct OwnAssignment {
    key: String,
    title: String,
    opens: String,
    due: String,
    closes: String,
    phase: &'static str,
    /// The points, once it is over and verdicts are shown.
    points: Option<String>,
}

/// The assignments of a course. Students see those that have opened.
pub(crate) async fn course(visit: &Visit) -> Result<Reply, NotShown> {
    let place = visit.place()?;
    let all = visit.store().assignments(place.course.key).await?;
    let is_seen = |assignment: &Assignment| assignment.policy.opens <= visit.now || place.member.role.is_staff();
    let extensions = visit.store().extensions_of(place.member.key).await?;
    let book = grades::own_grades(visit, &all, &extensions).await?;
    let row = book.as_ref().and_then(|book| book.rows.first());
    let mut assignments = Vec::new();
    for assignment in all.into_iter().filter(is_seen) {
        let extension = extensions.iter().find(|extension| extension.assignment == assignment.key);
        let window = Window::of(&assignment.policy, extension, &place.course.zone);
        let points = || {
            let place = book.as_ref()?.columns.iter().position(|column| column.assignment == assignment.key)?;
            let (column, cell) = (book.as_ref()?.columns.get(place)?, row?.cells.get(place)?);
            let points =
                cell.points.as_ref().filter(|_| cell.part != Part::Open && window.shows_verdicts(visit.now))?;
            let left_out = if cell.part == Part::LeftOut { ", left out" } else { "" };
            Some(format!("{} of {}{left_out}", Points(points.clone()), column.out_of))
        };
        assignments.push(OwnAssignment { points: points(), ..OwnAssignment::of(visit, &assignment, &window)? });
    }
    let grade = row.and_then(|row| row.share.as_ref()).map(grades::percent);
    let page = CoursePage { title: place.course.title.clone(), assignments, grade };
    visit.page("courses/course", page).await
}

impl OwnAssignment {
    fn of(visit: &Visit, assignment: &Assignment, window: &Window) -> Result<Self, NotShown> {
        let zone = visit.course()?.zone.as_str();
        Ok(Self {
            key: assignment.key.to_string(),
            title: assignment.title.clone(),
            opens: window.opens.shown(zone),
            due: window.due.shown(zone),
            closes: window.closes.shown(zone),
            phase: match window.phase(visit.now) {
                Phase::NotOpen => "not open yet",
                Phase::Open => "open",
                Phase::Late(_) => "late",
                Phase::Over | Phase::Closed => "closed",
            },
            points: None,
        })
    }
}

/// The times of an assignment for whoever asks.
async fn window(visit: &Visit, assignment: &Assignment) -> Result<Window, NotShown> {
    let place = visit.place()?;
    let extension = visit.store().extension(assignment.key, place.member.key).await?;
    Ok(Window::of(&assignment.policy, extension.as_ref(), &place.course.zone))
}

#[derive(Serialize)]
struct AssignmentPage {
    title: String,
    own: OwnAssignment,
    items: Vec<OwnItem>,
    /// The points of all items, once verdicts are shown.
    total: Option<String>,
    out_of: u32,
}

#[derive(Serialize)]
struct OwnItem {
    key: String,
    problem: String,
    title: String,
    out_of: u32,
    /// The number of times that something was handed in.
    attempts: u32,
    /// The standing for it, once verdicts are shown.
    has: Option<Has>,
}

/// The items of an assignment, with what one has reached.
pub(crate) async fn assignment(visit: &Visit) -> Result<Reply, NotShown> {
    let place = visit.place()?;
    let missing = || NotShown::missing("there is no such assignment in this course, or it is not open yet");
    let whole = visit.store().assignment(visit.key("assignment")?).await?.ok_or_else(missing)?;
    let window = window(visit, &whole.assignment).await?;
    let is_seen = window.phase(visit.now) != Phase::NotOpen || place.member.role.is_staff();
    if whole.assignment.course != place.course.key || !is_seen {
        return Err(missing());
    }
    at_close::hand_in(visit, &whole, Some(place.member.key)).await?;
    let records = Records::of_student(visit, &whole, place.member.key).await?;
    let account = records.accounts().account(place.member.key);
    let released = window.shows_verdicts(visit.now);
    let mut items = Vec::new();
    for standing in account.standings.iter().filter(|standing| standing.mark != GradeMark::Dropped) {
        let Some(item) = whole.items.iter().find(|item| item.key == standing.item) else { continue };
        items.push(OwnItem::of(visit, item, records.attempts_at(item), released.then_some(standing)).await?);
    }
    let page = AssignmentPage {
        title: whole.assignment.title.clone(),
        own: OwnAssignment::of(visit, &whole.assignment, &window)?,
        total: released.then(|| Points(account.total.clone()).to_string()),
        out_of: account.out_of,
        items,
    };
    visit.page("courses/assignment", page).await
}

impl OwnItem {
    async fn of(visit: &Visit, item: &Item, attempts: u32, standing: Option<&Standing>) -> Result<Self, NotShown> {
        Ok(Self {
            key: item.key.to_string(),
            problem: item.problem.clone(),
            title: super::super::items::problem(visit, item).await?.title().to_owned(),
            out_of: item.points,
            attempts,
            has: standing.map(Has::of),
        })
    }
}
