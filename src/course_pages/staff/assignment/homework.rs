//! A new assignment from the file of a homework: its fields are filled in, and looked over before they are kept.

use momentous_course::{Item, Weights};
use momentous_fault::Source;
use momentous_problem::{HomeworkDraft, SlotDraft};

use super::super::super::items;
use super::super::super::outcome::NotShown;
use super::super::super::visit::Visit;
use super::catalogue::Catalogue;
use super::draft::{Draft, MOST_ITEMS, Row};

/// How faults name the file.
const NAME: &str = "homework.yaml";

/// A text that is no homework, and everything that is wrong with it, as the command line prints it.
pub(super) struct Refused {
    pub(super) text: String,
    pub(super) faults: String,
}

/// The fields as the file that was sent says them.
pub(super) async fn filled_in(visit: &Visit, catalogue: &Catalogue) -> Result<Result<Draft, Refused>, NotShown> {
    let text = visit.fields.text("homework").replace("\r\n", "\n");
    let source = Source::new(NAME, &text);
    let homework = match visit.work(move |_| Ok(HomeworkDraft::read(&source))).await? {
        Ok(homework) => homework,
        Err(faults) => return Ok(Err(Refused { text, faults: faults.to_string() })),
    };
    if homework.problems.len() > MOST_ITEMS {
        let faults = format!("an assignment has at most {MOST_ITEMS} problems, and this file names more");
        return Ok(Err(Refused { text, faults }));
    }
    let mut rows = Vec::new();
    for slot in &homework.problems {
        rows.push(row(visit, slot, catalogue).await?);
    }
    let mut draft = Draft::titled(homework.title);
    (draft.rows, draft.date) = (rows, homework.date);
    Ok(Ok(draft))
}

async fn row(visit: &Visit, slot: &SlotDraft, catalogue: &Catalogue) -> Result<Row, NotShown> {
    let weights: Weights = slot.weights.iter().map(|(name, weight)| (name.to_owned(), *weight)).collect();
    let form = slot.form.clone();
    let item = Item { form: form.clone(), weights, ..items::unpinned(&slot.problem) };
    let (points, fault) = match catalogue.find(&slot.problem) {
        None => (
            None,
            Some(format!("there is no problem `{}`\nhelp: take it out, or publish it in this course", slot.problem)),
        ),
        Some(_) => match items::parts(visit, &item).await? {
            None => (None, Some(format!("it has no form `{}`", form.as_deref().unwrap_or_default()))),
            Some(parts) => (Some(item.weights.over(&parts).iter().sum::<u32>()), item.weights.fault(&parts)),
        },
    };
    let mut row = Row {
        problem: slot.problem.clone(),
        form: form.unwrap_or_default(),
        points: slot.points.or(points).map(|points| points.to_string()).unwrap_or_default(),
        weights: item.weights.to_string(),
        ..Row::default()
    };
    if let Some(fault) = fault {
        row.say(&fault);
    }
    Ok(row)
}
