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

/// A form of a problem that an assignment asks.
struct AskedForm {
    problem: String,
    /// Empty where the problem has one without a name.
    form: String,
    /// The problem's title.
    title: String,
    /// Its parts, by their names in answers.
    parts: BTreeMap<String, PartTitle>,
}

/// The forms that an assignment asks, in its order.
struct Asked(Vec<AskedForm>);

impl Asked {
    async fn of(visit: &Visit, whole: &AssignmentWithItems) -> Result<Self, NotShown> {
        let mut asked = Vec::new();
        // What was never drawn has no answers, and its file may be at fault just now.
        for item in whole.items.iter().filter(|item| item.digest.is_some()) {
            let problem = items::problem(visit, item).await?;
            asked.push(AskedForm {
                problem: item.problem.clone(),
                form: item.form.clone().unwrap_or_default(),
                title: problem.title().to_owned(),
                parts: PartTitle::all(&problem, item.form.as_deref()),
            });
        }
        Ok(Self(asked))
    }

    /// The form of a part, and its place in the assignment.
    fn form_of(&self, part: &AnsweredPart) -> Option<(usize, &AskedForm)> {
        self.0.iter().enumerate().find(|(_, asked)| asked.problem == part.problem && asked.form == part.form)
    }

    fn title(&self, part: &AnsweredPart) -> Option<PartTitle> {
        self.form_of(part)?.1.parts.get(&part.part).cloned()
    }

    /// The place of a part on the sheets: that of its problem in the assignment, and its letter.
    fn place(&self, part: &AnsweredPart) -> (usize, Option<String>) {
        let place = self.form_of(part).map_or(usize::MAX, |(place, _)| place);
        (place, self.title(part).map(|title| title.letter))
    }

    /// The title of a part's problem, and of its form where the problem stands in the assignment in several.
    fn problem(&self, part: &AnsweredPart) -> (String, Option<String>) {
        let forms: Vec<&AskedForm> = self.0.iter().filter(|asked| asked.problem == part.problem).collect();
        let title = forms.first().map_or_else(|| titled(&part.problem), |asked| asked.title.clone());
        let has_others = forms.iter().any(|asked| asked.form != part.form);
        (title, has_others.then(|| titled(&part.form)))
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
    let parts = parts.into_iter().map(|statistics| {
        let (problem, form) = asked.problem(&statistics.item);
        PartShown {
            problem,
            title: asked.title(&statistics.item),
            form,
            answers: statistics.answers,
            facility: percent(statistics.facility),
            discrimination: statistics
                .discrimination
                .map_or_else(|| "\u{2013}".to_owned(), |value| format!("{value:.2}")),
            mistakes: statistics
                .mistakes
                .into_iter()
                .map(|mistake| Counted { what: mistake.does.to_owned(), count: mistake.count })
                .collect(),
            wrong: statistics
                .wrong
                .into_iter()
                .map(|wrong| Counted { what: wrong.answer, count: wrong.count })
                .collect(),
        }
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
