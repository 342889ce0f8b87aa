//! The problems of a course: written, looked at, checked and published in the browser.

mod check;
mod list;
mod page;
mod trial;
mod write;

pub(crate) use list::list;
pub(crate) use page::{check, publish, show};
pub(crate) use write::{new, preview, save};

use momentous_course::ProblemFile;

use super::super::outcome::NotShown;
use super::super::visit::Visit;

/// The problem file of the address, where it is one of the course's own.
async fn file_of(visit: &Visit) -> Result<ProblemFile, NotShown> {
    let course = visit.course()?.key;
    let stored = visit.store().problem_file(course, visit.part("digest")).await?;
    let file = stored.filter(|file| file.course == Some(course));
    file.ok_or_else(|| NotShown::missing("this course has no such problem"))
}
