//! Hints: each is noted when it is shown, because it may cost something.

use momentous_course::{Draft, HintShown, Phase};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::hand_in::ANSWER;
use super::own_sheet::OwnSheet;

/// The author's next hint.
pub(crate) async fn hint(visit: &Visit) -> Result<Reply, NotShown> {
    let own_sheet = OwnSheet::of(visit).await?;
    open(visit, &own_sheet)?;
    keep_typed(visit, &own_sheet).await?;
    let given = own_sheet.hints.iter().filter(|hint| hint.part.is_none()).count();
    if given < own_sheet.exercise.student_sheet().hints.len() {
        let number = u32::try_from(given + 1).unwrap_or(u32::MAX);
        let hint = HintShown { sheet: own_sheet.sheet.key, part: None, number, at: visit.now };
        visit.store().show_hint(&hint).await?;
    }
    Ok(Reply::To(own_sheet.address(visit)? + "#hints"))
}

/// The next hint on a wrong answer.
pub(crate) async fn further(visit: &Visit) -> Result<Reply, NotShown> {
    let own_sheet = OwnSheet::of(visit).await?;
    open(visit, &own_sheet)?;
    keep_typed(visit, &own_sheet).await?;
    let part = visit.part("part");
    let stored = own_sheet.last.as_ref().and_then(|last| last.part(part));
    if let Some(next) = stored.and_then(|stored| stored.next_hint(&own_sheet.hints, &own_sheet.window, visit.now)) {
        let hint =
            HintShown { sheet: own_sheet.sheet.key, part: Some(part.to_owned()), number: next.number, at: visit.now };
        visit.store().show_hint(&hint).await?;
    }
    Ok(Reply::To(own_sheet.address(visit)? + "#marks"))
}

/// Hints are for those who can still hand in.
fn open(visit: &Visit, own_sheet: &OwnSheet) -> Result<(), NotShown> {
    match own_sheet.window.phase(visit.now) {
        Phase::Open | Phase::Late(_) => Ok(()),
        Phase::NotOpen | Phase::Over | Phase::Closed => Err(NotShown::Forbidden("the time for answers is over")),
    }
}

/// The typed answers go along with the button, and are there when the page comes back.
async fn keep_typed(visit: &Visit, own_sheet: &OwnSheet) -> Result<(), NotShown> {
    let answers = visit.fields.behind(ANSWER);
    if !answers.is_empty() {
        visit
            .store()
            .save_draft(&Draft { sheet: own_sheet.sheet.key, answers, saved: visit.now, settled: None })
            .await?;
    }
    Ok(())
}
