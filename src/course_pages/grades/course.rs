//! The gradebook of a course: every assignment that has opened, with the grade of each student.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use momentous_course::{
    Assignment, Course, CourseGradebook, CourseRow, Extension, FieldFault, Gradebook, Grading, Key, MarkedAssignment,
    Member, Part, Phase, Window,
};
use momentous_grade::Points;
use momentous_pages::words;
use momentous_quantity::{Decimal, Rational};
use momentous_store::Membership;

use super::super::at_close;
use super::super::ledger::Records;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::staff::Form;
use super::super::visit::Visit;
use super::class::{people, students};

/// The greatest weight, and the most assignments that may be left out.
const MOST: u32 = 1000;

/// The field of how many are left out.
const DROPPED: &str = "dropped";

#[derive(Serialize)]
struct CourseGradebookPage {
    title: &'static str,
    columns: Vec<ColumnHead>,
    rows: Vec<Row>,
    sections: Vec<String>,
    section: String,
    sort: String,
    /// The number of a student's weakest assignments that are left out.
    dropped: u32,
    form: Form,
    saved: bool,
}

#[derive(Serialize)]
struct ColumnHead {
    key: String,
    title: String,
    out_of: u32,
    weight: u32,
    /// The name of the field with its weight.
    field: String,
}

#[derive(Serialize)]
struct Row {
    member: String,
    name: String,
    login: String,
    section: String,
    cells: Vec<Cell>,
    /// The grade in percent.
    grade: Option<String>,
}

#[derive(Serialize)]
struct Cell {
    points: Option<String>,
    part: Part,
}

/// The assignments that have opened, with the marks of these students.
pub(crate) struct Marked {
    assignments: Vec<(Assignment, Gradebook, BTreeMap<Key<Member>, Extension>)>,
}

impl Marked {
    /// Those of a course. The number of reads does not depend on the number of students.
    async fn of(visit: &Visit, students: &[Membership]) -> Result<Self, NotShown> {
        let people = people(students);
        let mut assignments = Vec::new();
        for assignment in visit.store().assignments(visit.course()?.key).await? {
            let Some(whole) =
                visit.store().assignment(assignment.key).await?.filter(|_| assignment.policy.opens <= visit.now)
            else {
                continue;
            };
            at_close::hand_in(visit, &whole, None).await?;
            let records = Records::of_class(visit, &whole).await?;
            let extensions = visit.store().extensions(assignment.key).await?;
            let extensions = extensions.into_iter().map(|extension| (extension.member, extension)).collect();
            assignments.push((assignment, Gradebook::of(&records.accounts(), &people), extensions));
        }
        Ok(Self { assignments })
    }

    fn gradebook(&self, visit: &Visit, students: &[Membership]) -> Result<CourseGradebook, NotShown> {
        let course = visit.course()?;
        let mut marked = Vec::new();
        for (assignment, marks, extensions) in &self.assignments {
            let is_over = |membership: &Membership| {
                counts(visit, &Window::of(&assignment.policy, extensions.get(&membership.member.key), &course.zone))
            };
            marked.push(MarkedAssignment { assignment, marks, is_over: students.iter().map(is_over).collect() });
        }
        Ok(CourseGradebook::of(&course.grading, &marked, &people(students)))
    }
}

/// The gradebook of a course, as a page.
pub(crate) async fn course_gradebook(visit: &Visit) -> Result<Reply, NotShown> {
    with(visit, None).await
}

async fn with(visit: &Visit, form: Option<Form>) -> Result<Reply, NotShown> {
    let students = students(visit).await?;
    let book = Marked::of(visit, &students).await?.gradebook(visit, &students)?;
    let grading = &visit.course()?.grading;
    let is_wrong = form.as_ref().is_some_and(Form::is_wrong);
    let form = form.unwrap_or_else(|| filled(grading, &book));
    let sections: BTreeSet<String> =
        book.rows.iter().map(|row| row.section.clone()).filter(|section| !section.is_empty()).collect();
    let (section, sort) = (visit.fields.text("section").to_owned(), visit.fields.text("sort").to_owned());
    let mut rows: Vec<&CourseRow> =
        book.rows.iter().filter(|row| section.is_empty() || row.section == section).collect();
    sorted(&mut rows, &sort, &book);
    let columns = book.columns.iter().map(|column| ColumnHead {
        key: column.assignment.to_string(),
        title: column.title.clone(),
        out_of: column.out_of,
        weight: column.weight,
        field: weight_field(column.assignment),
    });
    let page = CourseGradebookPage {
        title: words::GRADEBOOK,
        columns: columns.collect(),
        rows: rows.into_iter().map(row).collect(),
        sections: sections.into_iter().collect(),
        section,
        sort,
        dropped: grading.dropped,
        form,
        saved: !is_wrong && visit.fields.get("saved").is_some(),
    };
    let page = visit.page("courses/grades/course", page).await?;
    Ok(if is_wrong { page.wrong() } else { page })
}

fn row(listed: &CourseRow) -> Row {
    let cell = |cell: &momentous_course::CourseCell| Cell {
        points: cell.points.as_ref().map(|points| Points(points.clone()).to_string()),
        part: cell.part,
    };
    Row {
        member: listed.member.to_string(),
        name: listed.name.clone(),
        login: listed.login.clone(),
        section: listed.section.clone(),
        cells: listed.cells.iter().map(cell).collect(),
        grade: listed.share.as_ref().map(percent),
    }
}

/// A share in percent, to one decimal.
pub(crate) fn percent(share: &Rational) -> String {
    let tenths = (share * Rational::from(1000)).round();
    format!("{}\u{a0}%", Decimal::from_scaled(tenths, 1))
}

/// By what the reader chose; grades and points with the greatest first. Students of the same stay by name.
fn sorted(rows: &mut [&CourseRow], by: &str, book: &CourseGradebook) {
    match by {
        "" | "name" => {}
        "login" => rows.sort_by_key(|row| row.login.clone()),
        "section" => rows.sort_by_key(|row| row.section.clone()),
        "grade" => rows.sort_by(|one, other| other.share.cmp(&one.share)),
        key => {
            if let Some(place) = book.columns.iter().position(|column| column.assignment.to_string() == key) {
                let points = |row: &CourseRow| row.cells.get(place).and_then(|cell| cell.points.clone());
                rows.sort_by_key(|row| std::cmp::Reverse(points(row)));
            }
        }
    }
}

/// The name of the field of an assignment's weight.
fn weight_field(assignment: Key<Assignment>) -> String {
    format!("weight.{assignment}")
}

fn filled(grading: &Grading, book: &CourseGradebook) -> Form {
    let weight = |assignment: Key<Assignment>| {
        grading.weights.get(&assignment.to_string()).map_or_else(String::new, u32::to_string)
    };
    let weights = book.columns.iter().map(|column| (weight_field(column.assignment), weight(column.assignment)));
    Form::new(weights.chain([(DROPPED.to_owned(), grading.dropped.to_string())]))
}

/// Keeps weights, and how many assignments are left out.
pub(crate) async fn save_grading(visit: &Visit) -> Result<Reply, NotShown> {
    let assignments = visit.store().assignments(visit.course()?.key).await?;
    let mut form = Form::sent(visit, &[DROPPED]);
    // Those that have not opened yet have no field, and keep what they have.
    let mut grading = visit.course()?.grading.clone();
    let number = |text: &str| text.parse::<u32>().ok().filter(|points| *points <= MOST);
    for assignment in assignments.iter().filter(|assignment| assignment.policy.opens <= visit.now) {
        let name = weight_field(assignment.key);
        let text = visit.fields.text(&name).trim().to_owned();
        form.fill(&name, text.clone());
        match (text.as_str(), number(&text)) {
            ("", _) => {
                grading.weights.remove(&assignment.key.to_string());
            }
            (_, Some(weight)) => {
                grading.weights.insert(assignment.key.to_string(), weight);
            }
            (_, None) => form.say(
                &name,
                &format!("write a whole number from 0 to {MOST}, or nothing to let it count as its points"),
            ),
        }
    }
    match number(form.value(DROPPED)) {
        Some(dropped) => grading.dropped = dropped,
        None => {
            let message = format!("write how many assignments are left out, from 0 to {MOST}");
            form = form.with(&[FieldFault { field: DROPPED, message }]);
        }
    }
    if form.is_wrong() {
        return with(visit, Some(form)).await;
    }
    let course = Course { grading, ..visit.course()?.clone() };
    visit.store().save_course(&course, &visit.entry("grade weights changed", "")).await?;
    Ok(Reply::To(visit.in_course("/gradebook?saved=yes")?))
}

/// The same as a table to be saved.
pub(crate) async fn course_gradebook_csv(visit: &Visit) -> Result<Reply, NotShown> {
    let students = students(visit).await?;
    let book = Marked::of(visit, &students).await?.gradebook(visit, &students)?;
    let name = format!("{}.csv", visit.course()?.title);
    Ok(Reply::Download { name, kind: "text/csv; charset=utf-8", bytes: book.to_csv().into_bytes() })
}

/// The grades of one student of the assignments that have closed, by the same rules; nothing for those who teach.
pub(crate) async fn own_grades(
    visit: &Visit,
    assignments: &[Assignment],
    extensions: &[Extension],
) -> Result<Option<CourseGradebook>, NotShown> {
    let place = visit.place()?;
    if place.member.role.is_staff() {
        return Ok(None);
    }
    let mut marked = Vec::new();
    for assignment in assignments {
        let extension = extensions.iter().find(|extension| extension.assignment == assignment.key);
        let has_closed = counts(visit, &Window::of(&assignment.policy, extension, &place.course.zone));
        let whole = if has_closed { visit.store().assignment(assignment.key).await? } else { None };
        let Some(whole) = whole else { continue };
        at_close::hand_in(visit, &whole, Some(place.member.key)).await?;
        let records = Records::of_student(visit, &whole, place.member.key).await?;
        let marks = Gradebook::of(&records.accounts(), &[(&place.member, &place.person)]);
        let extension = extension.map(|extension| (extension.member, extension.clone())).into_iter().collect();
        marked.push((assignment.clone(), marks, extension));
    }
    Marked { assignments: marked }.gradebook(visit, std::slice::from_ref(place)).map(Some)
}

/// Whether an assignment with these times counts in a grade now.
fn counts(visit: &Visit, window: &Window) -> bool {
    window.phase(visit.now) == Phase::Closed && window.shows_verdicts(visit.now)
}
