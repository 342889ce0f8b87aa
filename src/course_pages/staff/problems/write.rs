//! A problem file typed or uploaded: it is kept once it loads.

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
use super::trial;
use super::trial::{NAME, Trial};
use momentous_pages::Withheld as _;

#[derive(Serialize)]
struct WritePage {
    title: &'static str,
    text: String,
    /// Every fault with its excerpt, as the command line prints them.
    faults: Option<String>,
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
    visit.page("courses/staff/write", WritePage { title: "New problem", text, faults: None }).await
}

/// Keeps a file that loads, as a draft. One that does not stays in its field, with everything that is wrong with it.
pub(crate) async fn save(visit: &Visit) -> Result<Reply, NotShown> {
    let text = visit.fields.text("text").replace("\r\n", "\n");
    if let Trial::Not(faults) = trial::of(visit, &text).await? {
        return refused(visit, text, faults).await;
    }
    let course = visit.course()?.clone();
    let (courses, own, now) = (Arc::clone(&visit.courses), text.clone(), visit.now);
    let read = visit.work(move |_| {
        let read = || -> Result<ProblemFile, Faults> {
            let source = Source::new(NAME, &own);
            let problem = load(source.clone())?.draft.id;
            let (digest, key) = (digest(&source), Some(course.key));
            let file = ProblemFile { digest, problem, text: own, course: key, published: None, saved: now };
            let letters = course_letters(&library::source(&file))?;
            courses.library.problem(&course, &file, &Item { letters, ..items::unpinned(&file.problem) })?;
            Ok(file)
        };
        Ok(read())
    });
    let file = match read.await? {
        Ok(file) => file,
        Err(faults) => return refused(visit, text, faults.to_string()).await,
    };
    if let Err(reserved) = Withheld::from_student(visit).await?.check(&file.problem) {
        return refused(visit, text, reserved.sentences().join(" ")).await;
    }
    let before = visit.store().problem_file(visit.course()?.key, &file.digest).await?;
    if before.is_none_or(|before| before.course.is_none()) {
        let entry = visit.entry("problem saved", format!("{} {}", file.problem, file.digest));
        visit.store().save_problem_file(&file, Some(&entry)).await?;
    }
    Ok(Reply::To(visit.in_course(&format!("/problems/{}", file.digest))?))
}

async fn refused(visit: &Visit, text: String, faults: String) -> Result<Reply, NotShown> {
    let page = WritePage { title: "New problem", text, faults: Some(faults) };
    Ok(visit.page("courses/staff/write", page).await?.wrong())
}
