//! The gradebook of an assignment, as a page and as a table.

use serde::Serialize;

use momentous_course::{GradeMark, Gradebook};
use momentous_grade::Points;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::class::{Class, titles};

#[derive(Serialize)]
struct GradebookPage {
    title: String,
    assignment: String,
    columns: Vec<Column>,
    rows: Vec<Row>,
    out_of: u32,
    /// Students who have handed in something for every item.
    complete: usize,
    dropped: usize,
}

#[derive(Serialize)]
struct Column {
    heading: String,
    points: u32,
    missing: usize,
}

#[derive(Serialize)]
struct Row {
    member: String,
    name: String,
    login: String,
    section: String,
    cells: Vec<Cell>,
    total: String,
}

#[derive(Serialize)]
struct Cell {
    item: String,
    /// The points; nothing where nothing was handed in.
    points: Option<String>,
    /// How they came about, where it was not by marking.
    how: &'static str,
}

fn cell(item: String, mark: &GradeMark) -> Cell {
    Cell { item, points: mark.points().map(|points| Points(points.clone()).to_string()), how: mark.how() }
}

/// Students by items: what each has, and what is missing.
pub(crate) async fn gradebook(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let book = class.gradebook();
    let is_missing = |mark: &GradeMark| *mark == GradeMark::Missing;
    let titles = titles(visit, &class.whole).await?;
    let columns = book.columns.iter().enumerate().map(|(place, column)| Column {
        heading: titles.get(&column.item).cloned().unwrap_or_else(|| column.heading.clone()),
        points: column.points,
        missing: book.rows.iter().filter(|row| row.marks.get(place).is_some_and(is_missing)).count(),
    });
    let page = GradebookPage {
        title: format!("Gradebook: {}", class.whole.assignment.title),
        assignment: class.whole.assignment.key.to_string(),
        columns: columns.collect(),
        complete: book.rows.iter().filter(|row| !row.marks.iter().any(is_missing)).count(),
        rows: rows(&book),
        out_of: book.out_of,
        dropped: class.whole.items.iter().filter(|item| item.dropped).count(),
    };
    visit.page("courses/grades/gradebook", page).await
}

fn rows(book: &Gradebook) -> Vec<Row> {
    let cells = |marks: &[GradeMark]| {
        book.columns.iter().zip(marks).map(|(column, mark)| cell(column.item.to_string(), mark)).collect()
    };
    let row = |listed: &momentous_course::GradeRow| Row {
        member: listed.member.to_string(),
        name: listed.name.clone(),
        login: listed.login.clone(),
        section: listed.section.clone(),
        cells: cells(&listed.marks),
        total: Points(listed.total.clone()).to_string(),
    };
    book.rows.iter().map(row).collect()
}

/// The same as a table to be saved.
pub(crate) async fn gradebook_csv(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let bytes = class.gradebook().to_csv().into_bytes();
    let name = format!("{}.csv", class.whole.assignment.title);
    Ok(Reply::Download { name, kind: "text/csv; charset=utf-8", bytes })
}
