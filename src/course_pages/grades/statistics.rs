//! Statistics of a class for the problems.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course as course;
use momentous_course::ClassStatistics;
use momentous_exercise::titled;
use momentous_grade::Item as AnsweredPart;
use momentous_grade::Points;
use momentous_quantity::Rational;
use momentous_store::AssignmentWithItems;

use super::super::items;
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::class::{Class, handed_in_sheets, titles};
use super::part_title::PartTitle;

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
    /// Nothing where the file no longer asks it.
    title: Option<PartTitle>,
    /// The form, where the problem stands here in several.
    form: Option<String>,
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
    let asked = Asked::of(visit, &class.whole).await?;
    let page = visit.work(move |_| {
        let (accounts, mut book) = (class.records.accounts(), class.gradebook());
        for column in &mut book.columns {
            if let Some(title) = titles.get(&column.item) {
                column.heading.clone_from(title);
            }
        }
        let sheets = all.iter().map(|handed_in| (&handed_in.sheet, handed_in.reports.as_slice()));
        Ok(shown(title, key, course::statistics(&accounts, &book, sheets), &asked))
    });
    visit.page("courses/grades/statistics", page.await?).await
}

/// What the problems of an assignment ask.
struct Asked {
    /// Problems and forms in the order of the assignment.
    order: Vec<(String, String)>,
    /// Titles, by the problems' identities.
    problems: BTreeMap<String, String>,
    /// Parts, by problem and form; the form is empty where the problem has one without a name.
    parts: BTreeMap<(String, String), BTreeMap<String, PartTitle>>,
}

impl Asked {
    async fn of(visit: &Visit, whole: &AssignmentWithItems) -> Result<Self, NotShown> {
        let mut asked = Self { order: Vec::new(), problems: BTreeMap::new(), parts: BTreeMap::new() };
        // What was never drawn has no answers, and its file may be at fault just now.
        for item in whole.items.iter().filter(|item| item.digest.is_some()) {
            let problem = items::problem(visit, item).await?;
            asked.problems.insert(item.problem.clone(), problem.title().to_owned());
            let place = (item.problem.clone(), item.form.clone().unwrap_or_default());
            asked.order.push(place.clone());
            asked.parts.insert(place, PartTitle::all(&problem, item.form.as_deref()));
        }
        Ok(asked)
    }

    fn title(&self, part: &AnsweredPart) -> Option<PartTitle> {
        self.parts.get(&(part.problem.clone(), part.form.clone()))?.get(&part.part).cloned()
    }

    /// The place of a part on the sheets: that of its problem in the assignment, and its letter.
    fn place(&self, part: &AnsweredPart) -> (usize, Option<String>) {
        let place = self.order.iter().position(|(problem, form)| (problem, form) == (&part.problem, &part.form));
        (place.unwrap_or(usize::MAX), self.title(part).map(|title| title.letter))
    }

    /// The form of a part, where the problem stands in the assignment in several.
    fn form(&self, part: &AnsweredPart) -> Option<String> {
        let forms = self.parts.keys().filter(|(problem, _)| *problem == part.problem).count();
        (forms > 1).then(|| titled(&part.form))
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", share * 100.0)
}

fn shown(title: String, assignment: String, class: ClassStatistics, asked: &Asked) -> StatisticsPage {
    let items = class.items.into_iter().map(|statistics| ItemShown {
        heading: statistics.heading,
        students: statistics.students,
        mean: if statistics.students == 0 { "\u{2013}".to_owned() } else { Points(statistics.mean).to_string() },
        out_of: statistics.out_of,
    });
    let mut parts = class.parts.items;
    parts.sort_by_cached_key(|statistics| asked.place(&statistics.item));
    let parts = parts.into_iter().map(|statistics| PartShown {
        problem: asked
            .problems
            .get(&statistics.item.problem)
            .cloned()
            .unwrap_or_else(|| titled(&statistics.item.problem)),
        title: asked.title(&statistics.item),
        form: asked.form(&statistics.item),
        answers: statistics.answers,
        facility: percent(statistics.facility),
        discrimination: statistics.discrimination.map_or_else(|| "\u{2013}".to_owned(), |value| format!("{value:.2}")),
        mistakes: statistics
            .mistakes
            .into_iter()
            .map(|mistake| Counted { what: mistake.does.to_owned(), count: mistake.count })
            .collect(),
        wrong: statistics.wrong.into_iter().map(|wrong| Counted { what: wrong.answer, count: wrong.count }).collect(),
    });
    StatisticsPage {
        title,
        assignment,
        answers: class.parts.answers,
        students: class.students,
        mean: class.mean.map(|mean| format!("{} %", Points(mean * Rational::from(100)))),
        items: items.collect(),
        parts: parts.collect(),
    }
}
