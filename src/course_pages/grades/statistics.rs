//! What the answers of a class say about the problems.

use serde::Serialize;

use momentous_course as course;
use momentous_course::ClassStatistics;
use momentous_grade::Points;
use momentous_quantity::Rational;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::class::{Class, handed_in_sheets, titles};

#[derive(Serialize)]
struct StatisticsPage {
    title: String,
    assignment: String,
    answers: u64,
    students: usize,
    /// The mean share of all points; nothing where nobody has any.
    mean: Option<String>,
    items: Vec<ItemShown>,
    parts: Vec<PartShown>,
}

#[derive(Serialize)]
struct ItemShown {
    heading: String,
    students: usize,
    mean: String,
    out_of: u32,
}

#[derive(Serialize)]
struct PartShown {
    problem: String,
    form: String,
    part: String,
    answers: u64,
    facility: String,
    discrimination: String,
    mistakes: Vec<Counted>,
    wrong: Vec<Counted>,
}

#[derive(Serialize)]
struct Counted {
    what: String,
    count: u64,
}

/// How easy each part was, how well it tells students apart, and which wrong answers were usual.
pub(crate) async fn statistics(visit: &Visit) -> Result<Reply, NotShown> {
    let class = Class::of(visit).await?;
    let all = handed_in_sheets(visit, &class.whole).await?;
    let whole = &class.whole.assignment;
    let (title, key) = (format!("Statistics: {}", whole.title), whole.key.to_string());
    let titles = titles(visit, &class.whole).await?;
    let found = visit.work(move |app| {
        let (accounts, mut book) = (class.records.accounts(), class.gradebook());
        for column in &mut book.columns {
            if let Some(title) = titles.get(&column.item) {
                column.heading.clone_from(title);
            }
        }
        let mut found = course::statistics(
            &accounts,
            &book,
            all.iter().map(|handed_in| (&handed_in.sheet, handed_in.reports.as_slice())),
        );
        for part in &mut found.parts.items {
            part.item.problem = app.pages.library.title(&part.item.problem)?;
        }
        Ok(found)
    });
    visit.page("courses/grades/statistics", shown(title, key, found.await?)).await
}

fn percent(share: f64) -> String {
    format!("{:.0} %", share * 100.0)
}

fn shown(title: String, assignment: String, found: ClassStatistics) -> StatisticsPage {
    let items = found.items.into_iter().map(|statistics| ItemShown {
        heading: statistics.heading,
        students: statistics.students,
        mean: if statistics.students == 0 { "\u{2013}".to_owned() } else { Points(statistics.mean).to_string() },
        out_of: statistics.out_of,
    });
    let parts = found.parts.items.into_iter().map(|statistics| PartShown {
        problem: statistics.item.problem,
        form: statistics.item.form,
        part: statistics.item.part,
        answers: statistics.answers,
        facility: percent(statistics.facility),
        discrimination: statistics.discrimination.map_or_else(|| "\u{2013}".to_owned(), |found| format!("{found:.2}")),
        mistakes: statistics
            .mistakes
            .into_iter()
            .map(|count| Counted { what: count.does.to_owned(), count: count.count })
            .collect(),
        wrong: statistics.wrong.into_iter().map(|wrong| Counted { what: wrong.answer, count: wrong.count }).collect(),
    });
    StatisticsPage {
        title,
        assignment,
        answers: found.parts.answers,
        students: found.students,
        mean: found.mean.map(|mean| format!("{} %", Points(mean * Rational::from(100)))),
        items: items.collect(),
        parts: parts.collect(),
    }
}
