//! Items of assignments, and the problems behind them.

use std::sync::Arc;

use momentous_bank::course_letters;
use momentous_course::{Course, Item, Key, Member, Moment, ProblemFile, Sheet, Weights};
use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_exercise::{Derivation, Exercise, SeedSource};
use momentous_problem::{CourseSymbols, Part, Problem, digest};
use momentous_store::AssignmentWithItems;

use super::library::source;
use super::outcome::NotShown;
use super::session;
use super::visit::Visit;

/// The number of times that problems are pinned again where others change the assignment at the same time.
const AGAIN: usize = 8;

/// An assignment of the course of the address, with one of its items.
pub(super) async fn item_of(visit: &Visit, item: Key<Item>) -> Result<(AssignmentWithItems, Key<Item>), NotShown> {
    let missing = || NotShown::missing("there is no such problem in this course");
    let row = visit.store().item(item).await?.ok_or_else(missing)?;
    let whole = visit.store().assignment(row.assignment).await?.ok_or_else(missing)?;
    if whole.assignment.course == visit.course()?.key { Ok((whole, item)) } else { Err(missing()) }
}

/// The assignment with its problems pinned, once it has opened: what is drawn from then on is drawn from the files as they are now.
pub(super) async fn pinned(visit: &Visit, whole: AssignmentWithItems) -> Result<AssignmentWithItems, NotShown> {
    if visit.now < whole.assignment.policy.opens { Ok(whole) } else { pinned_now(visit, whole).await }
}

/// The same, even before it opens: for sheets that are handed out on paper.
pub(super) async fn pinned_now(visit: &Visit, whole: AssignmentWithItems) -> Result<AssignmentWithItems, NotShown> {
    let mut whole = whole;
    for _ in 0..AGAIN {
        if whole.assignment.pinned.is_some() {
            return Ok(whole);
        }
        for item in &mut whole.items {
            pin(visit, item).await?;
        }
        whole.assignment.pinned = Some(visit.now);
        let entry = visit.entry("problems pinned", whole.assignment.key.to_string());
        visit.store().save_assignment(&whole, &entry).await?;
        // Another request may have pinned them, or changed the assignment; what is kept counts.
        let missing = || NotShown::missing("there is no such assignment in this course");
        whole = visit.store().assignment(whole.assignment.key).await?.ok_or_else(missing)?;
    }
    Err(NotShown::Conflict("the assignment was changed again and again at the moment when it opened".to_owned()))
}

/// Writes into an item from which file and in which letters its sheets are drawn, and keeps that file.
pub(super) async fn pin(visit: &Visit, item: &mut Item) -> Result<(), NotShown> {
    let file = current(visit, &item.problem).await?;
    item.letters = letters(visit, &file).await?;
    item.digest = Some(file.digest.clone());
    // A file of the course is kept already.
    if file.course.is_none() {
        visit.store().save_problem_file(&file, None).await?;
    }
    Ok(())
}

/// A problem as an item that is not pinned and stands in no assignment.
pub(super) fn unpinned(problem: &str) -> Item {
    let (key, assignment) = (session::key(), session::key());
    let (problem, letters) = (problem.to_owned(), CourseSymbols::default());
    Item {
        key,
        assignment,
        position: 0,
        problem,
        form: None,
        points: 1,
        weights: Weights::default(),
        repeat: 0,
        digest: None,
        letters,
        issue: 0,
        dropped: false,
    }
}

/// The letters in which a file is printed now.
pub(super) async fn letters(visit: &Visit, file: &ProblemFile) -> Result<CourseSymbols, NotShown> {
    let source = source(file);
    visit.work(move |_| Ok(course_letters(&source)?)).await
}

/// The file of a problem as it is now: the course's own that was published last, else the bank's.
pub(super) async fn current(visit: &Visit, problem: &str) -> Result<ProblemFile, NotShown> {
    let files = visit.store().problem_files(visit.course()?.key).await?;
    let published = files.into_iter().filter(|file| file.problem == problem && file.published.is_some());
    if let Some(file) = published.max_by_key(|file| file.published) {
        return Ok(file);
    }
    let source = visit.app.pages.library.source(problem)?;
    Ok(ProblemFile {
        digest: digest(&source),
        problem: problem.to_owned(),
        text: source.text.to_string(),
        course: None,
        published: Some(visit.now),
        saved: visit.now,
    })
}

/// The problem of an item, compiled: as it was pinned, or before that as it is now.
pub(super) async fn problem(visit: &Visit, item: &Item) -> Result<Arc<Problem>, NotShown> {
    let course = visit.course()?.clone();
    let known = |digest: &String| visit.courses.library.known(course.key, digest, item);
    if let Some(known) = item.digest.as_ref().and_then(known) {
        return Ok(known);
    }
    let (file, item) = match &item.digest {
        Some(digest) => {
            let file = visit.store().problem_file(course.key, digest).await?.ok_or_else(|| {
                let message = format!("the file of {} with the digest {digest} is missing", item.problem);
                NotShown::Refused(Refused::new(RefusedKind::Fault, message))
            })?;
            (file, item.clone())
        }
        None => {
            let file = current(visit, &item.problem).await?;
            let letters = letters(visit, &file).await?;
            (file, Item { letters, ..item.clone() })
        }
    };
    let courses = Arc::clone(&visit.courses);
    visit.work(move |_| Ok(courses.library.problem(&course, &file, &item)?)).await
}

/// The parts that an item asks for, with the points that they have in the file; nothing where its problem has no such form.
pub(super) async fn parts(visit: &Visit, item: &Item) -> Result<Option<Vec<Part>>, NotShown> {
    let problem = problem(visit, &Item { weights: Weights::default(), ..item.clone() }).await?;
    let form = problem.form(item.form.as_deref()).and_then(|place| problem.forms().get(place));
    Ok(form.map(|form| form.parts.clone()))
}

/// A new sheet of an item for a member of the course.
pub(super) fn sheet(
    course: &Course,
    member: Key<Member>,
    item: &Item,
    problem: &Arc<Problem>,
    seen: Moment,
) -> Result<Sheet, NotShown> {
    let seeds = SeedSource { secret: Some(course.secret.as_bytes()), ..SeedSource::default() };
    // Names and identities do not enter the seed: they may change, and others may know them.
    let student = if item.issue == 0 { member.to_string() } else { format!("{member}/{}", item.issue) };
    let form = item.form.as_deref().unwrap_or_default();
    // The first of several that ask the same draws what it draws alone.
    let asked = if item.repeat == 0 { form.to_owned() } else { format!("{form}#{}", item.repeat.saturating_add(1)) };
    let seed = seeds.seed(&student, &item.problem, &asked);
    let form = problem.form(item.form.as_deref()).ok_or_else(|| NotShown::missing("the problem has no such form"))?;
    let exercise = Exercise::draw(problem, form, seed).map_err(Refused::from)?;
    let issued = exercise.issue(Some(Derivation::default()), course.decimal);
    Ok(Sheet { key: session::key(), item: item.key, member, issue: item.issue, issued, seen })
}
