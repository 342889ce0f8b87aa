//! Every problem of a course, in all its versions.

use serde::Serialize;

use momentous_course::ProblemFile;
use momentous_pages::words;

use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::titles::title;
use super::super::super::visit::Visit;

#[derive(Serialize)]
struct ListPage {
    title: &'static str,
    files: Vec<Listed>,
}

#[derive(Serialize)]
struct Listed {
    title: String,
    problem: String,
    digest: String,
    saved: String,
    published: Option<String>,
}

/// The problems of the course, the latest version of each first.
pub(crate) async fn list(visit: &Visit) -> Result<Reply, NotShown> {
    let course = visit.course()?;
    let mut files = visit.store().problem_files(course.key).await?;
    files.sort_by(|one, other| (&one.problem, other.saved).cmp(&(&other.problem, one.saved)));
    let zone = course.zone.clone();
    let listed = visit.work(move |_| {
        let listed = |file: ProblemFile| Listed {
            title: title(&file),
            problem: file.problem,
            digest: file.digest,
            saved: file.saved.shown(&zone),
            published: file.published.map(|at| at.shown(&zone)),
        };
        Ok(files.into_iter().map(listed).collect())
    });
    visit.page("courses/staff/problems", ListPage { title: words::PROBLEMS, files: listed.await? }).await
}
