//! A problem file typed or uploaded: it is shown as its students would see it, and kept once it loads.

use std::sync::Arc;

use serde::Serialize;

use momentous_bank::course_letters;
use momentous_course::{Item, ProblemFile};
use momentous_fault::{Faults, Source};
use momentous_problem::{digest, load};

use super::super::super::items;
use super::super::super::library;
use super::super::super::outcome::NotShown;
use super::super::super::reply::Reply;
use super::super::super::visit::Visit;
use super::super::super::withheld::Withheld;
use super::super::assignment::{SampleSheet, looked};
use super::trial;
use super::trial::{NAME, Trial};
use momentous_pages::Withheld as _;

#[derive(Serialize)]
struct WritePage {
    title: &'static str,
    text: String,
    /// Every fault with its excerpt, as the command line prints them.
    faults: Option<String>,
    /// Three variants, where the file was to be shown and can be.
    looked: Vec<SampleSheet>,
}

impl WritePage {
    const fn new(text: String, faults: Option<String>, looked: Vec<SampleSheet>) -> Self {
        Self { title: "New problem", text, faults, looked }
    }

    async fn reply(self, visit: &Visit) -> Result<Reply, NotShown> {
        let is_wrong = self.faults.is_some();
        let page = visit.page("courses/staff/write", self).await?;
        Ok(if is_wrong { page.wrong() } else { page })
    }
}

/// A file that can be used, with the letters in which it is printed.
struct Usable {
    file: ProblemFile,
    item: Item,
}

/// An empty field, or the file of a problem to start from.
pub(crate) async fn new(visit: &Visit) -> Result<Reply, NotShown> {
    let text = match visit.fields.get("from") {
        None => String::new(),
        Some(id) => {
            Withheld::from_student(visit).await?.check(id)?;
            items::current(visit, id).await?.text
        }
    };
    WritePage::new(text, None, Vec::new()).reply(visit).await
}

/// The file as it was sent; browsers send the ends of lines in their own way.
fn sent(visit: &Visit) -> String {
    visit.fields.text("text").replace("\r\n", "\n")
}

/// Shows what the file makes, or what is wrong with it. Nothing is kept.
pub(crate) async fn preview(visit: &Visit) -> Result<Reply, NotShown> {
    let text = sent(visit);
    let Usable { file, item } = match read(visit, &text).await? {
        Ok(usable) => usable,
        Err(faults) => return refused(visit, text, faults).await,
    };
    let course = visit.course()?.clone();
    let problem = visit.work(move |_| Ok(library::compiled(&course, &file, &item))).await?;
    match problem {
        Ok(problem) => WritePage::new(text, None, looked(visit, &problem, 0).await?).reply(visit).await,
        Err(faults) => refused(visit, text, faults.to_string()).await,
    }
}

/// The file in its field, with everything that is wrong with it.
async fn refused(visit: &Visit, text: String, faults: String) -> Result<Reply, NotShown> {
    WritePage::new(text, Some(faults), Vec::new()).reply(visit).await
}

/// Keeps a file that loads, as a draft. One that does not stays in its field, with everything that is wrong with it.
pub(crate) async fn save(visit: &Visit) -> Result<Reply, NotShown> {
    let text = sent(visit);
    let Usable { file, item } = match read(visit, &text).await? {
        Ok(usable) => usable,
        Err(faults) => return refused(visit, text, faults).await,
    };
    let (course, courses, written_file) = (visit.course()?.clone(), Arc::clone(&visit.courses), file.clone());
    if let Err(faults) = visit.work(move |_| Ok(courses.library.problem(&course, &written_file, &item))).await? {
        return refused(visit, text, faults.to_string()).await;
    }
    let before = visit.store().problem_file(visit.course()?.key, &file.digest).await?;
    if before.is_none_or(|before| before.course.is_none()) {
        let entry = visit.entry("problem saved", format!("{} {}", file.problem, file.digest));
        visit.store().save_problem_file(&file, Some(&entry)).await?;
    }
    Ok(Reply::To(visit.in_course(&format!("/problems/{}", file.digest))?))
}

/// Reads a file, after a trial of whether it can be compiled; else everything that is wrong with it. What is open where the reader
/// learns is not shown under another name.
async fn read(visit: &Visit, text: &str) -> Result<Result<Usable, String>, NotShown> {
    if let Trial::Not(faults) = trial::try_file(visit, text).await? {
        return Ok(Err(faults));
    }
    let (course, now, text) = (visit.course()?.key, visit.now, text.to_owned());
    let usable = visit.work(move |_| {
        let read = || -> Result<Usable, Faults> {
            let source = Source::new(NAME, &text);
            let problem = load(source.clone())?.draft.id;
            let digest = digest(&source);
            let file = ProblemFile { digest, problem, text, course: Some(course), published: None, saved: now };
            let item = Item { letters: course_letters(&library::source(&file))?, ..items::unpinned(&file.problem) };
            Ok(Usable { file, item })
        };
        Ok(read())
    });
    let usable = match usable.await? {
        Ok(usable) => usable,
        Err(faults) => return Ok(Err(faults.to_string())),
    };
    let reserved = Withheld::from_student(visit).await?.check(&usable.file.problem);
    Ok(reserved.map(|()| usable).map_err(|reserved| reserved.sentences().join(" ")))
}
