//! The worked solution of a student's own sheet, once it is released.

use serde::Serialize;

use crate::exercise::calls::SolveResponse;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::own_sheet::OwnSheet;

#[derive(Serialize)]
struct SolutionPage {
    title: String,
    back: String,
    solved: SolveResponse,
}

/// The worked solution.
pub(in crate::web::courses) async fn solution(visit: &Visit) -> Result<Reply, NotShown> {
    let own = OwnSheet::of(visit).await?;
    if !own.window.shows_solutions(visit.now) && !visit.place()?.member.role.is_staff() {
        return Err(NotShown::Forbidden("the solution is shown when the assignment has closed for you, if at all"));
    }
    let back = own.address(visit)?;
    let solved = visit.work(move |app| Ok(app.engine().solution_of(&own.exercise, None, false)?)).await?;
    visit.page("courses/solution", SolutionPage { title: solved.title.clone(), back, solved }).await
}
