//! Answers of one student at one item, attempt by attempt.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::{Attempt, Item, Override, OverrideRule, Role, Sheet, StoredPart, StoredReport, is_redacted};
use momentous_grade::Points;
use momentous_laws::wrong;
use momentous_store::{AssignmentWithItems, Membership};

use super::super::at_close;
use super::super::items;
use super::super::ledger::{Has, Records};
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::super::withheld::Withheld;
use super::class::{member, reports, titles};
use super::part_title::PartTitle;
use momentous_pages::Withheld as _;

#[derive(Serialize)]
struct AnswersPage {
    title: String,
    assignment: String,
    assignment_title: String,
    item: String,
    member: String,
    name: String,
    points: u32,
    /// The standing of the student for it.
    standing: Option<Has>,
    /// When the student was given the problem: by opening it, on paper, or with points set by hand.
    seen: Option<String>,
    /// The text of the sheet as it was shown.
    statement: String,
    attempts: Vec<AttemptShown>,
    by_hand: Vec<ByHandShown>,
    decides: bool,
    /// Whether points can be set: those of students.
    is_student: bool,
    typed: Typed,
}

#[derive(Serialize)]
struct AttemptShown {
    number: u32,
    received: String,
    late: Option<u32>,
    counts: bool,
    total: String,
    out_of: u32,
    parts: Vec<PartShown>,
    /// The work beside the answers; empty where there is none.
    work: String,
}

#[derive(Serialize)]
struct PartShown {
    id: String,
    /// Nothing where the file no longer asks it.
    title: Option<PartTitle>,
    /// Its right answer, where whoever asks may have it.
    right: Option<String>,
    typed: String,
    is_redacted: bool,
    read: Option<String>,
    unread: Option<String>,
    verdict: &'static str,
    points: String,
    out_of: u32,
    mistakes: Vec<&'static str>,
    message: String,
}

/// What the problem says of its parts, by their names in answers.
#[derive(Default)]
struct Key {
    titles: BTreeMap<String, PartTitle>,
    right: BTreeMap<String, String>,
}

#[derive(Serialize)]
struct ByHandShown {
    points: Option<String>,
    /// Whether a regrade kept them as the least.
    kept: bool,
    reason: String,
    comment: String,
    at: String,
}

/// The fields typed into the forms of the page, and their faults.
#[derive(Default, Serialize)]
pub(super) struct Typed {
    pub(super) points: String,
    pub(super) reason: String,
    pub(super) comment: String,
    pub(super) fault: Option<String>,
}

/// The student and the item of the address.
pub(super) struct Place {
    pub(super) whole: AssignmentWithItems,
    pub(super) item: Item,
    pub(super) student: Membership,
    /// The sheet that counts; nothing where the student has not seen the problem.
    pub(super) sheet: Option<Sheet>,
}

impl Place {
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let (whole, key) = items::item_of(visit, visit.key("item")?).await?;
        let missing = || NotShown::missing("there is no such problem in this course");
        let item = whole.items.iter().find(|item| item.key == key).cloned().ok_or_else(missing)?;
        let student = member(visit).await?;
        at_close::hand_in(visit, &whole, Some(student.member.key)).await?;
        let sheet = visit.store().sheet(item.key, student.member.key, item.issue).await?;
        Ok(Self { whole, item, student, sheet })
    }

    /// The sheet that counts. A student who has not opened the problem is given it now, as on paper: points stand on a sheet.
    pub(super) async fn issued(&self, visit: &Visit) -> Result<Sheet, NotShown> {
        if let Some(sheet) = &self.sheet {
            return Ok(sheet.clone());
        }
        let member = &self.student.member;
        if member.role != Role::Student {
            return Err(NotShown::NotPossible("only students of the course have points".to_owned()));
        }
        let whole = items::pinned_now(visit, self.whole.clone()).await?;
        let item = whole.items.into_iter().find(|item| item.key == self.item.key).unwrap_or_else(|| self.item.clone());
        let problem = items::problem(visit, &item).await?;
        let (course, member, now) = (visit.course()?.clone(), member.key, visit.now);
        let (item_key, issue) = (item.key, item.issue);
        let sheet = visit.work(move |_| items::sheet(&course, member, &item, &problem, now)).await?;
        visit.store().add_sheet(&sheet).await?;
        // The student may have opened the problem meanwhile: the first sheet that is kept counts.
        Ok(visit.store().sheet(item_key, member, issue).await?.unwrap_or(sheet))
    }

    /// The address of the page.
    pub(super) fn address(&self, visit: &Visit) -> Result<String, NotShown> {
        visit.in_course(&format!("/items/{}/students/{}", self.item.key, self.student.member.key))
    }
}

/// Every attempt, with what was typed, what was read, and what was found.
pub(crate) async fn answers(visit: &Visit) -> Result<Reply, NotShown> {
    page(visit, &Place::of(visit).await?, Typed::default()).await
}

pub(super) async fn page(visit: &Visit, place: &Place, typed: Typed) -> Result<Reply, NotShown> {
    let Place { whole, item, student, sheet } = place;
    let zone = visit.course()?.zone.as_str();
    let attempts = match sheet {
        Some(sheet) => visit.store().attempts(sheet.key).await?,
        None => Vec::new(),
    };
    let reports = reports(&attempts)?;
    let counting = reports.last().and_then(|last| last.history.counting());
    let records = Records::of_student(visit, whole, student.member.key).await?;
    let key = key(visit, place).await?;
    let is_own = |decision: &&Override| records.is_at(decision, item.key);
    let page = AnswersPage {
        title: format!(
            "{}: {}",
            student.person.shown(),
            titles(visit, whole).await?.remove(&item.key).unwrap_or_default()
        ),
        assignment: whole.assignment.key.to_string(),
        assignment_title: whole.assignment.title.clone(),
        item: item.key.to_string(),
        member: student.member.key.to_string(),
        name: student.person.shown().to_owned(),
        points: item.points,
        standing: records.standing(student.member.key, item.key).map(|standing| Has::of(&standing)),
        seen: sheet.as_ref().map(|sheet| sheet.seen.shown(zone)),
        statement: sheet.as_ref().map(|sheet| sheet.issued.statement.clone()).unwrap_or_default(),
        attempts: attempts
            .iter()
            .zip(&reports)
            .map(|(attempt, report)| shown((attempt, report), counting, zone, &key))
            .collect(),
        by_hand: records.by_hand.iter().filter(is_own).map(|decision| set(decision, zone)).collect(),
        decides: visit.place()?.member.role == Role::Instructor,
        is_student: student.member.role == Role::Student,
        typed,
    };
    visit.page("courses/grades/answers", page).await
}

/// What the parts of the sheet ask, and the right answers, which are kept from whoever learns in another course where the problem is open.
async fn key(visit: &Visit, place: &Place) -> Result<Key, NotShown> {
    let Some(sheet) = &place.sheet else { return Ok(Key::default()) };
    let (problem, issued) = (items::problem(visit, &place.item).await?, sheet.issued.clone());
    let titles = PartTitle::all(&problem, issued.form.as_deref());
    if Withheld::from_student(visit).await?.check(&place.item.problem).is_err() {
        return Ok(Key { titles, ..Key::default() });
    }
    let right = visit.work(move |_| {
        // A corrected problem may no longer draw this sheet; then nothing stands beside it.
        let Ok(exercise) = issued.draw(&problem) else { return Ok(BTreeMap::new()) };
        let parts = exercise.worked().form.parts.iter();
        Ok(parts.map(|part| (part.id.clone(), exercise.printed(part))).collect())
    });
    Ok(Key { titles, right: right.await? })
}

fn shown((attempt, report): (&Attempt, &StoredReport), counting: Option<u32>, zone: &str, key: &Key) -> AttemptShown {
    AttemptShown {
        number: attempt.number,
        received: attempt.received.shown(zone),
        late: report.late.as_ref().map(|late| late.days),
        counts: counting == Some(attempt.number),
        total: Points(report.total.clone()).to_string(),
        out_of: report.out_of,
        parts: report.parts.iter().map(|kept| part(attempt, kept, key)).collect(),
        work: report.work.as_ref().map_or_else(String::new, |work| work.text.clone()),
    }
}

fn part(attempt: &Attempt, kept: &StoredPart, key: &Key) -> PartShown {
    PartShown {
        id: kept.id.clone(),
        title: key.titles.get(&kept.id).cloned(),
        right: key.right.get(&kept.id).cloned(),
        typed: attempt.answers.get(&kept.id).cloned().unwrap_or_default(),
        is_redacted: is_redacted(attempt, &kept.id),
        read: kept.read.clone(),
        unread: kept.unread.clone(),
        verdict: kept.verdict.meaning(),
        points: Points(kept.points.clone()).to_string(),
        out_of: kept.out_of,
        mistakes: kept.mistakes.iter().filter_map(|code| Some(wrong::find(code)?.does)).collect(),
        message: kept.message.clone(),
    }
}

fn set(decision: &Override, zone: &str) -> ByHandShown {
    let points = decision.points.as_deref().and_then(|points| points.parse().ok());
    ByHandShown {
        points: points.map(|points| Points(points).to_string()),
        kept: decision.rule == OverrideRule::AtLeast,
        reason: decision.reason.clone(),
        comment: decision.comment.clone(),
        at: decision.at.shown(zone),
    }
}
