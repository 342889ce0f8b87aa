//! The worked solution of a student's own sheet, once it is released.

use std::sync::Arc;

use serde::Serialize;

use momentous_course::Item;
use momentous_exercise::calls::{Detail, Refused, RefusedKind, SolveResponse};
use momentous_exercise::{Exercise, Remark};

use super::super::items;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::super::withheld::Withheld;
use super::own_sheet::OwnSheet;
use momentous_pages::Withheld as _;

#[derive(Serialize)]
struct SolutionPage {
    title: String,
    back: String,
    /// The remark for the reader.
    note: Option<&'static str>,
    solved: SolveResponse,
}

/// The worked solution.
pub(crate) async fn solution(visit: &Visit) -> Result<Reply, NotShown> {
    let own_sheet = OwnSheet::of(visit).await?;
    if !own_sheet.window.shows_solutions(visit.now) && !visit.place()?.member.role.is_staff() {
        return Err(NotShown::Forbidden("the solution is shown when the assignment has closed for you, if at all"));
    }
    if !own_sheet.window.shows_solutions(visit.now) {
        Withheld::from_student(visit).await?.check(&own_sheet.item.problem)?;
    }
    let back = own_sheet.address(visit)?;
    let (exercise, note) = right(visit, &own_sheet).await?;
    let solved = visit.work(move |app| Ok(app.engine().solution_of(&exercise, None, Detail::Short)?)).await?;
    visit.page("courses/solution", SolutionPage { title: solved.title.clone(), back, note, solved }).await
}

/// The remark where a corrected problem no longer draws the sheet that was handed out.
const DIFFERS: &str = "The problem was corrected after your sheet was handed out, and what it says or asks has changed. This is the \
    solution of the corrected problem, with the numbers that it has for you.";

/// The message where the file that took a problem's place is none.
const NO_PROBLEM: &str = "the problem was withdrawn, and there is no corrected one that could be solved";

/// The variant that is solved: that of the corrected problem, where it was corrected, whatever became of the marks.
async fn right(visit: &Visit, own_sheet: &OwnSheet) -> Result<(Arc<Exercise>, Option<&'static str>), NotShown> {
    let corrections = visit.store().corrections(own_sheet.whole.assignment.key).await?;
    let digest = own_sheet.item.right_digest(&corrections).map(str::to_owned);
    if digest == own_sheet.item.digest {
        return Ok((Arc::clone(&own_sheet.exercise), None));
    }
    let problem =
        items::problem(visit, &Item { digest, ..own_sheet.item.clone() }).await.map_err(|reason| match reason {
            NotShown::Refused(refused) if refused.kind == RefusedKind::Fault => NotShown::Forbidden(NO_PROBLEM),
            other => other,
        })?;
    let issued = own_sheet.sheet.issued.clone();
    visit
        .work(move |_| {
            let note = (issued.remark(&problem) == Remark::Differs).then_some(DIFFERS);
            Ok((Arc::new(issued.draw(&problem).map_err(Refused::from)?), note))
        })
        .await
}
