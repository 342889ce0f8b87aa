//! A corrected problem of an item: what it would change for whom.

use std::sync::Arc;

use momentous_course::{Correction, CorrectionChoice, Effect, Item, ProblemFile, Remarked, effects};
use momentous_problem::Problem;
use momentous_store::AssignmentWithItems;

use super::super::items;
use super::super::outcome::NotShown;
use super::super::visit::Visit;
use super::class::{HandedInSheet, handed_in_sheets};

/// A corrected problem of an item, with what it would change.
pub(super) struct Corrected {
    pub(super) item: Item,
    /// The file as it is now.
    pub(super) file: ProblemFile,
    /// The fault where it is no problem.
    pub(super) fault: Option<String>,
    /// The sheets that count.
    pub(super) sheets: Arc<Vec<HandedInSheet>>,
    pub(super) effects: Vec<Effect>,
}

impl Corrected {
    /// Whether the file draws every sheet as it was handed out.
    pub(super) fn draws_alike(&self) -> bool {
        self.fault.is_none() && !self.effects.iter().any(|effect| effect.after == Remarked::Differs)
    }

    /// Whether there is this choice: sheets are marked again only where the file draws all of them alike.
    pub(super) fn offers(&self, choice: CorrectionChoice) -> bool {
        match choice {
            CorrectionChoice::Remark => self.draws_alike(),
            CorrectionChoice::FullMarks | CorrectionChoice::Drop => true,
            CorrectionChoice::IssueAnew => !self.draws_alike() && self.fault.is_none(),
        }
    }
}

/// The items of an assignment whose problem has another file now than the one that its sheets were drawn from. One about which
/// somebody has decided already is not among them.
pub(super) async fn corrected(
    visit: &Visit,
    whole: &AssignmentWithItems,
    decided: &[Correction],
) -> Result<Vec<Corrected>, NotShown> {
    let mut corrections = Vec::new();
    let mut sheets = None;
    for item in whole.items.iter().filter(|item| !item.dropped) {
        let Some(digest) = &item.digest else { continue };
        let file = items::current(visit, &item.problem).await?;
        let is_decided = decided
            .iter()
            .rfind(|correction| correction.item == item.key)
            .is_some_and(|correction| correction.to == file.digest);
        if file.digest == *digest || is_decided {
            continue;
        }
        if sheets.is_none() {
            sheets = Some(handed_in_sheets(visit, whole).await?);
        }
        let is_own =
            |handed_in: &HandedInSheet| handed_in.sheet.item == item.key && handed_in.sheet.issue == item.issue;
        let (handed_in, rest) = sheets.take().unwrap_or_default().into_iter().partition(is_own);
        sheets = Some(rest);
        corrections.push(one(visit, whole, item.clone(), file, handed_in).await?);
    }
    Ok(corrections)
}

async fn one(
    visit: &Visit,
    whole: &AssignmentWithItems,
    item: Item,
    file: ProblemFile,
    sheets: Vec<HandedInSheet>,
) -> Result<Corrected, NotShown> {
    let (course, courses) = (visit.course()?.clone(), Arc::clone(&visit.courses));
    // What was printed in some letters is read in them.
    let (own_file, own_item, policy) = (file.clone(), item.clone(), whole.assignment.policy.clone());
    let sheets = Arc::new(sheets);
    let handed_in = Arc::clone(&sheets);
    let worked = move || {
        let problem = courses.library.problem(&course, &own_file, &own_item);
        let (problem, fault): (Option<Arc<Problem>>, _) = match problem {
            Ok(problem) => (Some(problem), None),
            Err(faults) => (None, Some(faults.to_string())),
        };
        let worked: Vec<_> = handed_in.iter().map(HandedInSheet::worked).collect();
        (effects(&worked, &policy, problem.as_ref()), fault)
    };
    let (effects, fault) = visit.work(move |_| Ok(worked())).await?;
    Ok(Corrected { item, file, fault, sheets, effects })
}
