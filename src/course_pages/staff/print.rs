//! The sheets of a class on paper, and their key: documents to save and to print.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde::Serialize;

use momentous_course::{Item, Key, Member, Role, Sheet};
use momentous_exercise::Exercise;
use momentous_exercise::calls::Refused;
use momentous_fault::Faults;
use momentous_pages::words;
use momentous_problem::Problem;
use momentous_render as render;
#[cfg(feature = "pdf")]
use momentous_render::Press;
use momentous_render::{Format, KeyRow, Page, Renderer, SheetPart};
use momentous_store::{AssignmentWithItems, Membership};

use super::super::items;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::super::withheld::Withheld;
use super::assignment;
use momentous_pages::Withheld as _;

#[derive(Serialize)]
struct PrintPage {
    title: &'static str,
    assignment: String,
    key: String,
    students: usize,
    sheets: usize,
    pinned: bool,
    /// Whether this program makes PDF.
    pdf: bool,
}

/// The format in which a document is written.
#[derive(Clone, Copy)]
enum Paper {
    Html,
    #[cfg(feature = "pdf")]
    Pdf,
}

impl Paper {
    /// Reads the request of the address.
    fn asked(visit: &Visit) -> Result<Self, NotShown> {
        match visit.fields.get("as") {
            None => Ok(Self::Html),
            #[cfg(feature = "pdf")]
            Some("pdf") => Ok(Self::Pdf),
            Some(_) => Err(NotShown::missing("this program prints no such kind of document")),
        }
    }

    /// The end of a file's name, and what is in it.
    fn kind(self) -> (&'static str, &'static str) {
        match self {
            Self::Html => ("html", "text/html; charset=utf-8"),
            #[cfg(feature = "pdf")]
            Self::Pdf => ("pdf", "application/pdf"),
        }
    }

    fn bytes(self, pages: &[Page], templates: Option<&Path>) -> Result<Vec<u8>, Faults> {
        let renderer = Renderer::new(templates)?.with_font();
        match self {
            Self::Html => Ok(renderer.render(pages, Format::Html)?.text.into_bytes()),
            #[cfg(feature = "pdf")]
            Self::Pdf => Press::new(templates)?.pdf(&renderer.render(pages, Format::Typst)?.text),
        }
    }
}

/// Which version of a problem that was corrected is printed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    /// The one that students have.
    HandedOut,
    /// The corrected one, whatever became of the marks.
    Right,
}

/// A drawn sheet, whose it is, and what it is worth.
struct Printed {
    student: String,
    exercise: Exercise,
    points: u32,
}

/// Shows the sheets that can be printed.
pub(crate) async fn page(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = assignment::assignment_of(visit).await?;
    let students = students(visit).await?.len();
    let page = PrintPage {
        title: words::PRINT,
        students,
        sheets: students * counted(&whole).count(),
        pinned: whole.assignment.pinned.is_some(),
        pdf: cfg!(feature = "pdf"),
        key: whole.assignment.key.to_string(),
        assignment: whole.assignment.title,
    };
    visit.page("courses/staff/print", page).await
}

/// The sheets of every student.
pub(crate) async fn sheets(visit: &Visit) -> Result<Reply, NotShown> {
    let printed = drawn(visit, Version::HandedOut).await?;
    let pages = printed.iter().map(|printed| Page::Sheet(sheet(printed))).collect();
    document(visit, "sheets", pages).await
}

/// The answers of every student.
pub(crate) async fn key(visit: &Visit) -> Result<Reply, NotShown> {
    let named = |printed: &Printed| {
        let student = printed.student.clone();
        printed
            .exercise
            .key()
            .into_iter()
            .map(move |row| KeyRow { student: Some(student.clone()), ..row })
            .collect::<Vec<_>>()
    };
    let whole = assignment::assignment_of(visit).await?;
    let withheld = Withheld::from_student(visit).await?;
    counted(&whole).try_for_each(|item| withheld.check(&item.problem))?;
    let title = whole.assignment.title;
    let printed = drawn(visit, Version::Right).await?;
    let rows = printed.iter().flat_map(named).collect();
    document(visit, "key", vec![Page::Key(render::Key { title, rows })]).await
}

async fn document(visit: &Visit, name: &str, pages: Vec<Page>) -> Result<Reply, NotShown> {
    let paper = Paper::asked(visit)?;
    let (end, kind) = paper.kind();
    let bytes = visit.work(move |app| Ok(paper.bytes(&pages, app.settings.templates.as_deref())?)).await?;
    Ok(Reply::Download { name: format!("{name}.{end}"), kind, bytes })
}

/// A sheet without what costs points, and with the points of the assignment.
fn sheet(printed: &Printed) -> render::Sheet {
    let sheet = printed.exercise.sheet();
    let total: f64 = sheet.parts.iter().filter_map(|part| part.points).sum();
    let scaled = |points: f64| if total > 0.0 { points * f64::from(printed.points) / total } else { 0.0 };
    let parts = sheet.parts.into_iter().map(|part| SheetPart { points: part.points.map(scaled), ..part });
    render::Sheet { student: Some(printed.student.clone()), hints: Vec::new(), parts: parts.collect(), ..sheet }
}

fn counted(whole: &AssignmentWithItems) -> impl Iterator<Item = &Item> {
    whole.items.iter().filter(|item| !item.dropped)
}

/// The students of the course, by section and name.
async fn students(visit: &Visit) -> Result<Vec<Membership>, NotShown> {
    let mut members = visit.store().members(visit.course()?.key).await?;
    members.retain(|membership| membership.member.role == Role::Student && membership.member.left.is_none());
    members.sort_by_cached_key(|membership| (membership.member.section.clone(), membership.person.shown().to_owned()));
    Ok(members)
}

/// Every student's sheets, student by student. What is printed is handed out: from then on its problems are pinned, and students find
/// the same numbers in their pages.
async fn drawn(visit: &Visit, version: Version) -> Result<Vec<Printed>, NotShown> {
    let whole = items::pinned_now(visit, assignment::assignment_of(visit).await?).await?;
    let students = students(visit).await?;
    let mut problems: BTreeMap<Key<Item>, (Item, Arc<Problem>)> = BTreeMap::new();
    for item in counted(&whole) {
        problems.insert(item.key, (item.clone(), items::problem(visit, item).await?));
    }
    let kept = visit.store().sheets(whole.assignment.key).await?;
    let has = |item: &Item, member| {
        kept.iter().any(|sheet| (sheet.item, sheet.member, sheet.issue) == (item.key, member, item.issue))
    };
    let missing: Vec<(Key<Item>, Key<Member>)> = counted(&whole)
        .flat_map(|item| students.iter().map(move |membership| (item, membership.member.key)))
        .filter(|(item, member)| !has(item, *member))
        .map(|(item, member)| (item.key, member))
        .collect();
    if !missing.is_empty() {
        let (course, now, problems) = (visit.course()?.clone(), visit.now, problems.clone());
        let new = visit.work(move |_| {
            let new = missing.iter().filter_map(|(item, member)| Some((problems.get(item)?, *member)));
            new.map(|((item, problem), member)| items::sheet(&course, member, item, problem, now)).collect()
        });
        let new: Vec<Sheet> = new.await?;
        visit.store().add_sheets(&new).await?;
    }
    let mut sheets: BTreeMap<(Key<Member>, Key<Item>), Sheet> = BTreeMap::new();
    for sheet in visit.store().sheets(whole.assignment.key).await? {
        if problems.get(&sheet.item).is_some_and(|(item, _)| item.issue == sheet.issue) {
            sheets.insert((sheet.member, sheet.item), sheet);
        }
    }
    if version == Version::Right {
        let corrections = visit.store().corrections(whole.assignment.key).await?;
        for (item, problem) in problems.values_mut() {
            let digest = item.right_digest(&corrections).map(str::to_owned);
            if digest != item.digest {
                *problem = items::problem(visit, &Item { digest, ..item.clone() }).await?;
            }
        }
    }
    let order: Vec<Key<Item>> = counted(&whole).map(|item| item.key).collect();
    visit
        .work(move |_| {
            let mut printed = Vec::new();
            for membership in &students {
                let student = format!("{} ({})", membership.person.shown(), membership.person.login);
                for item in &order {
                    let (Some((item, problem)), Some(sheet)) =
                        (problems.get(item), sheets.get(&(membership.member.key, *item)))
                    else {
                        continue;
                    };
                    let exercise = sheet.issued.draw(problem).map_err(Refused::from)?;
                    printed.push(Printed { student: student.clone(), exercise, points: item.points });
                }
            }
            Ok(printed)
        })
        .await
}
