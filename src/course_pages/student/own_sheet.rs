//! A student's sheet of an item, with everything that decides what may be done with it.

use std::sync::Arc;

use momentous_course::{Attempt, HintShown, Item, Phase, Sheet, StoredReport, Window, is_redacted};
use momentous_exercise::Exercise;
use momentous_exercise::calls::Refused;
use momentous_grade::Entry;
use momentous_problem::Problem;
use momentous_store::AssignmentWithItems;

use super::super::at_close;
use super::super::items;
use super::super::outcome::NotShown;
use super::super::visit::Visit;

/// A student's sheet of an item, with everything that decides what may be done with it.
pub(super) struct OwnSheet {
    pub(super) whole: AssignmentWithItems,
    pub(super) item: Item,
    /// The times of the assignment for this student.
    pub(super) window: Window,
    pub(super) sheet: Sheet,
    /// The variant.
    pub(super) exercise: Arc<Exercise>,
    /// The attempts, in their order.
    pub(super) attempts: Vec<Attempt>,
    /// The stored report of the last of these.
    pub(super) last: Option<StoredReport>,
    /// The hints that were shown.
    pub(super) hints: Vec<HintShown>,
}

impl OwnSheet {
    /// The sheet of the item in the address, for whoever asks. It is drawn when it is first seen.
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let (whole, item) = items::item_of(visit, visit.key("item")?).await?;
        let whole = items::pinned(visit, whole).await?;
        // Pinning has written the digest of its problem into the item.
        let item = whole.items.iter().find(|listed| listed.key == item).cloned().ok_or_else(no_item)?;
        let place = visit.place()?;
        let extension = visit.store().extension(whole.assignment.key, place.member.key).await?;
        let window = Window::of(&whole.assignment.policy, extension.as_ref(), &place.course.zone);
        if window.phase(visit.now) == Phase::NotOpen && !place.member.role.is_staff() {
            return Err(no_item());
        }
        at_close::hand_in(visit, &whole, Some(place.member.key)).await?;
        let problem = items::problem(visit, &item).await?;
        let (sheet, exercise) = drawn(visit, &item, problem).await?;
        let attempts = visit.store().attempts(sheet.key).await?;
        let last = attempts.last().map(StoredReport::of).transpose().map_err(|error| NotShown::Store(error.into()))?;
        let hints = visit.store().hints(sheet.key).await?;
        Ok(Self { whole, item, window, sheet, exercise: Arc::new(exercise), attempts, last, hints })
    }

    /// The text typed at a part in the last attempt that could not be read, where there is one.
    pub(super) fn unread(&self, part: &str) -> Option<&str> {
        let is_unread = self.last.as_ref()?.part(part)?.entry == Entry::Unread;
        let last = self.attempts.last().filter(|last| is_unread && !is_redacted(last, part))?;
        last.answers.get(part).map(String::as_str)
    }

    /// The address of its page.
    pub(super) fn address(&self, visit: &Visit) -> Result<String, NotShown> {
        visit.in_course(&format!("/items/{}", self.item.key))
    }
}

fn no_item() -> NotShown {
    NotShown::missing("there is no such problem in this course, or it is not open yet")
}

/// The sheet as it was issued, or a new one. Two requests at once get the same: the first that is kept.
async fn drawn(visit: &Visit, item: &Item, problem: Arc<Problem>) -> Result<(Sheet, Exercise), NotShown> {
    let (course, member) = (visit.course()?, visit.place()?.member.key);
    let redrawn = |sheet: Sheet, problem: Arc<Problem>| {
        visit.work(move |_| Ok((sheet.issued.draw(&problem).map_err(Refused::from)?, sheet)))
    };
    if let Some(sheet) = visit.store().sheet(item.key, member, item.issue).await? {
        let (exercise, sheet) = redrawn(sheet, problem).await?;
        return Ok((sheet, exercise));
    }
    let (course, shared_problem, item_of, now) = (course.clone(), Arc::clone(&problem), item.clone(), visit.now);
    let sheet = visit.work(move |_| items::sheet(&course, member, &item_of, &shared_problem, now)).await?;
    visit.store().add_sheet(&sheet).await?;
    let kept = visit.store().sheet(item.key, member, item.issue).await?.unwrap_or(sheet);
    let (exercise, sheet) = redrawn(kept, problem).await?;
    Ok((sheet, exercise))
}
