//! What the answers of a class say about the problems.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::course;
use crate::grade::Statistics;

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::class::{assignment, handed_in_sheets, students};

#[derive(Serialize)]
struct StatisticsPage {
    title: String,
    assignment: String,
    answers: u64,
    students: usize,
    mean: String,
    parts: Vec<PartShown>,
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
pub(in crate::web::courses) async fn statistics(visit: &Visit) -> Result<Reply, NotShown> {
    let whole = assignment(visit).await?;
    let students: BTreeSet<_> = students(visit).await?.into_iter().map(|own| own.member.key).collect();
    let mut all = handed_in_sheets(visit, &whole).await?;
    all.retain(|own| students.contains(&own.sheet.member));
    let (title, key) = (format!("Statistics: {}", whole.assignment.title), whole.assignment.key.to_string());
    let found =
        visit.work(move |_| Ok(course::statistics(all.iter().map(|own| (&own.sheet, own.reports.as_slice()))))).await?;
    visit.page("courses/grades/statistics", shown(title, key, found)).await
}

fn percent(share: f64) -> String {
    format!("{:.0} %", share * 100.0)
}

fn shown(title: String, assignment: String, found: Statistics) -> StatisticsPage {
    let parts = found.items.into_iter().map(|own| PartShown {
        problem: own.item.problem,
        form: own.item.form,
        part: own.item.part,
        answers: own.answers,
        facility: percent(own.facility),
        discrimination: own.discrimination.map_or_else(|| "\u{2013}".to_owned(), |found| format!("{found:.2}")),
        mistakes: own.mistakes.into_iter().map(|own| Counted { what: own.does.to_owned(), count: own.count }).collect(),
        wrong: own.wrong.into_iter().map(|own| Counted { what: own.answer, count: own.count }).collect(),
    });
    StatisticsPage {
        title,
        assignment,
        answers: found.answers,
        students: found.students,
        mean: percent(found.mean),
        parts: parts.collect(),
    }
}
