//! Hints: each is noted when it is shown, because it may cost something.

use momentous_course::{Draft, HintShown, Phase};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::hand_in::ANSWER;
use super::own_sheet::OwnSheet;

/// The author's next hint.
pub(crate) async fn hint(visit: &Visit) -> Result<Reply, NotShown> {
    let own = OwnSheet::of(visit).await?;
    open(visit, &own)?;
    keep_typed(visit, &own).await?;
    let seen = own.hints.iter().filter(|hint| hint.part.is_none()).count();
    if seen < own.exercise.student_sheet().hints.len() {
        let number = u32::try_from(seen + 1).unwrap_or(u32::MAX);
        let hint = HintShown { sheet: own.sheet.key, part: None, number, at: visit.now };
        visit.store().show_hint(&hint).await?;
    }
    Ok(Reply::To(own.address(visit)? + "#hints"))
}

/// The next hint on a wrong answer.
pub(crate) async fn further(visit: &Visit) -> Result<Reply, NotShown> {
    let own = OwnSheet::of(visit).await?;
    open(visit, &own)?;
    keep_typed(visit, &own).await?;
    let part = visit.part("part");
    let stored = own.last.as_ref().and_then(|last| last.part(part));
    if let Some(next) = stored.and_then(|stored| stored.next_hint(&own.hints, &own.window, visit.now)) {
        let hint = HintShown { sheet: own.sheet.key, part: Some(part.to_owned()), number: next.number, at: visit.now };
        visit.store().show_hint(&hint).await?;
    }
    Ok(Reply::To(own.address(visit)? + "#marks"))
}

/// Hints are for those who can still hand in.
fn open(visit: &Visit, own: &OwnSheet) -> Result<(), NotShown> {
    match own.window.phase(visit.now) {
        Phase::Open | Phase::Late(_) => Ok(()),
        Phase::NotOpen | Phase::Over | Phase::Closed => Err(NotShown::Forbidden("the time for answers is over")),
    }
}

/// What was typed goes along with the button, and is there when the page comes back.
async fn keep_typed(visit: &Visit, own: &OwnSheet) -> Result<(), NotShown> {
    let answers = visit.fields.behind(ANSWER);
    if !answers.is_empty() {
        visit.store().save_draft(&Draft { sheet: own.sheet.key, answers, saved: visit.now, settled: None }).await?;
    }
    Ok(())
}
