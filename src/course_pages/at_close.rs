//! Hands in at the close what students saved and did not hand in, where the assignment says so. It happens when somebody asks for
//! anything of the assignment afterwards: nobody sees it without.

use std::collections::BTreeMap;

use momentous_course::{
    self as course, Attempt, Draft, Extension, Key, Member, Refusal, Sheet, StoredReport, Unsubmitted, Window,
    is_due_at_close,
};
use momentous_exercise::calls::Refused;
use momentous_store::{AssignmentWithItems, HandIn, HandedIn, StoreFault};

use super::items;
use super::outcome::NotShown;
use super::visit::Visit;

/// The key of a hand-in that nobody sent. No page sends it.
pub(super) const REQUEST: &str = "at the close";
/// The number of times that an attempt is marked again where something else changes at the same time.
const AGAIN: usize = 8;

/// Hands in what lies saved at an assignment, of everybody or of one student.
pub(super) async fn hand_in(
    visit: &Visit,
    whole: &AssignmentWithItems,
    student: Option<Key<Member>>,
) -> Result<(), NotShown> {
    let policy = &whole.assignment.policy;
    if policy.unsubmitted == Unsubmitted::Leave || visit.now <= policy.due {
        return Ok(());
    }
    let mut drafts = visit.store().drafts(whole.assignment.key, student).await?;
    drafts.retain(|(draft, _)| draft.settled.is_none());
    if drafts.is_empty() {
        return Ok(());
    }
    let extensions = visit.store().extensions(whole.assignment.key).await?;
    let extensions: BTreeMap<Key<Member>, Extension> =
        extensions.into_iter().map(|extension| (extension.member, extension)).collect();
    for (draft, sheet) in drafts {
        let window = Window::of(policy, extensions.get(&sheet.member), &visit.course()?.zone);
        one(visit, whole.assignment.key, &draft, &sheet, &window).await?;
    }
    Ok(())
}

/// Hands in what lies saved at one sheet, where its time is over.
async fn one(
    visit: &Visit,
    assignment: Key<course::Assignment>,
    draft: &Draft,
    sheet: &Sheet,
    window: &Window,
) -> Result<(), NotShown> {
    for _ in 0..AGAIN {
        let missing = || NotShown::missing("there is no such assignment in this course");
        let whole = visit.store().assignment(assignment).await?.ok_or_else(missing)?;
        let counts = |item: &&course::Item| item.key == sheet.item && item.issue == sheet.issue && !item.dropped;
        let Some(item) = whole.items.iter().find(counts) else { return Ok(()) };
        let attempts = visit.store().attempts(sheet.key).await?;
        let last = attempts.last();
        if !is_due_at_close(&whole.assignment.policy, window, draft, last.map(|attempt| attempt.received), visit.now) {
            return Ok(());
        }
        let taken = marked(visit, &whole, item, (draft, sheet, window), last).await?;
        let Ok(report) = taken else { return settle(visit, draft).await };
        let attempt = Attempt {
            sheet: sheet.key,
            number: last.map_or(0, |last| last.number) + 1,
            received: draft.saved,
            answers: draft.answers.clone(),
            report: serde_json::value::to_raw_value(&report).map_err(StoreFault::Record)?,
            request: REQUEST.to_owned(),
        };
        match visit.store().hand_in(HandIn { attempt: &attempt, assignment, revision: whole.revision }).await? {
            HandedIn::Kept | HandedIn::Before(_) => return settle(visit, draft).await,
            HandedIn::Stale => {}
        }
    }
    Err(NotShown::Conflict("the assignment was changed again and again at this moment".to_owned()))
}

/// Marks the saved answers, as of when they were saved.
async fn marked(
    visit: &Visit,
    whole: &AssignmentWithItems,
    item: &course::Item,
    (draft, sheet, window): (&Draft, &Sheet, &Window),
    last: Option<&Attempt>,
) -> Result<Result<StoredReport, Refusal>, NotShown> {
    let last = last.map(StoredReport::of).transpose().map_err(|error| NotShown::Store(StoreFault::Record(error)))?;
    let problem = items::problem(visit, item).await?;
    let hints = visit.store().hints(sheet.key).await?;
    let (policy, window) = (whole.assignment.policy.clone(), window.clone());
    let (answers, issued, at) = (draft.answers.clone(), sheet.issued.clone(), draft.saved);
    visit
        .work(move |_| {
            let exercise = issued.draw(&problem).map_err(Refused::from)?;
            let hand_in = course::HandIn {
                exercise: &exercise,
                decimal: issued.decimal,
                last: last.as_ref(),
                answers: &answers,
                hints: &hints,
                policy: &policy,
                window: &window,
                at,
            };
            Ok(hand_in.take().map(|accepted| accepted.stored))
        })
        .await
}

/// It is not tried again, and what was typed stays.
async fn settle(visit: &Visit, draft: &Draft) -> Result<(), NotShown> {
    Ok(visit.store().save_draft(&Draft { settled: Some(visit.now), ..draft.clone() }).await?)
}
