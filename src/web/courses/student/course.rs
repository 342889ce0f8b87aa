//! A course and its assignments as a student sees them.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::course::{Assignment, Attempt, Item, Key, Phase, Score, Sheet, StoredReport, Window};
use crate::grade::Points;
use crate::quantity::Rational;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;

#[derive(Serialize)]
struct CoursePage {
    title: String,
    assignments: Vec<OwnAssignment>,
}

#[derive(Serialize)]
struct OwnAssignment {
    key: String,
    title: String,
    opens: String,
    due: String,
    closes: String,
    phase: &'static str,
}

/// The assignments of a course. Students see those that have opened.
pub(in crate::web::courses) async fn course(visit: &Visit) -> Result<Reply, NotShown> {
    let place = visit.place()?;
    let all = visit.store().assignments(place.course.key).await?;
    let is_seen = |own: &Assignment| own.policy.opens <= visit.now || place.member.role.is_staff();
    let extensions = visit.store().extensions_of(place.member.key).await?;
    let mut assignments = Vec::new();
    for own in all.into_iter().filter(is_seen) {
        let extension = extensions.iter().find(|extension| extension.assignment == own.key);
        let window = Window::of(&own.policy, extension, &place.course.zone);
        assignments.push(OwnAssignment::of(visit, &own, &window)?);
    }
    let page = CoursePage { title: place.course.title.clone(), assignments };
    visit.page("courses/course", page).await
}

impl OwnAssignment {
    fn of(visit: &Visit, own: &Assignment, window: &Window) -> Result<Self, NotShown> {
        let zone = visit.course()?.zone.as_str();
        Ok(Self {
            key: own.key.to_string(),
            title: own.title.clone(),
            opens: window.opens.shown(zone),
            due: window.due.shown(zone),
            closes: window.closes.shown(zone),
            phase: match window.phase(visit.now) {
                Phase::NotOpen => "not open yet",
                Phase::Open => "open",
                Phase::Late(_) => "late",
                Phase::Over | Phase::Closed => "closed",
            },
        })
    }
}

/// The times of an assignment for whoever asks.
async fn window(visit: &Visit, own: &Assignment) -> Result<Window, NotShown> {
    let place = visit.place()?;
    let extension = visit.store().extension(own.key, place.member.key).await?;
    Ok(Window::of(&own.policy, extension.as_ref(), &place.course.zone))
}

#[derive(Serialize)]
struct AssignmentPage {
    title: String,
    own: OwnAssignment,
    items: Vec<OwnItem>,
    /// The points of all items, once verdicts are shown.
    total: Option<Points>,
    out_of: u32,
}

#[derive(Serialize)]
struct OwnItem {
    key: String,
    problem: String,
    title: String,
    out_of: u32,
    attempts: usize,
    points: Option<Points>,
}

/// The items of an assignment, with what one has reached.
pub(in crate::web::courses) async fn assignment(visit: &Visit) -> Result<Reply, NotShown> {
    let place = visit.place()?;
    let missing = || NotShown::missing("there is no such assignment in this course, or it is not open yet");
    let whole = visit.store().assignment(visit.key("assignment")?).await?.ok_or_else(missing)?;
    let window = window(visit, &whole.assignment).await?;
    let is_seen = window.phase(visit.now) != Phase::NotOpen || place.member.role.is_staff();
    if whole.assignment.course != place.course.key || !is_seen {
        return Err(missing());
    }
    let attempts = visit.store().attempts_of(whole.assignment.key, place.member.key).await?;
    let sheets = visit.store().sheets_of(place.member.key).await?;
    let released = window.shows_verdicts(visit.now);
    let mut items = Vec::new();
    for item in whole.items.iter().filter(|item| !item.dropped) {
        items.push(OwnItem::of(visit, item, &sheets, &attempts, released).await?);
    }
    let total =
        items.iter().filter_map(|item| item.points.as_ref()).fold(Rational::ZERO, |sum, points| sum + &points.0);
    let page = AssignmentPage {
        title: whole.assignment.title.clone(),
        own: OwnAssignment::of(visit, &whole.assignment, &window)?,
        total: released.then_some(Points(total)),
        out_of: items.iter().map(|item| item.out_of).sum(),
        items,
    };
    visit.page("courses/assignment", page).await
}

impl OwnItem {
    async fn of(
        visit: &Visit,
        item: &Item,
        sheets: &[Sheet],
        attempts: &BTreeMap<Key<Sheet>, Vec<Attempt>>,
        released: bool,
    ) -> Result<Self, NotShown> {
        let sheet = sheets.iter().find(|sheet| sheet.item == item.key && sheet.issue == item.issue);
        let own = sheet.and_then(|sheet| attempts.get(&sheet.key)).map_or(&[][..], Vec::as_slice);
        let last = own.last().map(StoredReport::of).transpose().map_err(|error| NotShown::Store(error.into()))?;
        let points =
            last.filter(|_| released).and_then(|last| Some(Points(Score::of(&last)?.scaled(item.points).points)));
        Ok(Self {
            key: item.key.to_string(),
            problem: item.problem.clone(),
            title: super::super::items::problem(visit, item).await?.title().to_owned(),
            out_of: item.points,
            attempts: own.len(),
            points,
        })
    }
}
