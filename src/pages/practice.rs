//! The practice sheet: a field for each part, marks, messages and hints.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_bank::Card;
use momentous_exercise::calls::{
    HintResponse, MarkResponse, MarkedPart, ReadResponse, Refused, SheetResponse, WorkResponse, within,
};
use momentous_exercise::{Exercise, Letter};
use momentous_grade::Sitting;
use momentous_render::Fragment;

use super::parameters::Parameters;
use super::place::Place;
use super::view::View;

/// Before the name of a part in the names of fields.
const ANSWER: &str = "answer.";
/// An easier problem is offered once so many checks in a row found something that is not right.
const FAILURES: usize = 3;

#[derive(Serialize)]
struct PracticePage {
    title: String,
    place: Place,
    sheet: SheetResponse,
    /// The text typed into each field, in their order.
    typed: Vec<String>,
    /// How that was read, in the same order.
    read: Vec<ReadResponse>,
    /// The marks of each field, in their order; empty before anything is marked.
    marked: Vec<Option<MarkedPart>>,
    /// Marks of the whole sheet, once it is marked.
    report: Option<MarkResponse>,
    /// Whether a check was asked for with nothing in any field.
    is_empty: bool,
    /// How many checks found something that is not right.
    failures: usize,
    /// An easier problem on the same matter, after several of them.
    easier: Option<Easier>,
    /// The author's hints that were asked for.
    hints: Vec<Fragment>,
    /// The number of further hints on wrong answers that were asked for.
    further: usize,
    /// Whether a further hint can be asked for.
    more_further: bool,
    decimal: String,
    /// The lines of work that were typed.
    work: String,
    /// The judgement of the lines; `None` before there are some, or a hint is asked for.
    judged: Option<WorkResponse>,
    /// The letters that they may hold.
    letters: Vec<Letter>,
    /// How plain a hint for the next step was asked for.
    next: usize,
    /// Whether the problem is solved with numbers of the reader's own.
    own_numbers: bool,
}

/// A problem that is offered.
#[derive(Serialize)]
struct Easier {
    id: String,
    title: String,
}

/// The practice sheet. With answers it is marked; what was typed stays.
pub(super) fn practice(view: &View<'_>, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let variant = fields.variant(problem)?;
    let exercise = view.engine().draw(&variant)?;
    let sheet = SheetResponse::of(&exercise)?;
    let answers = fields.behind(ANSWER);
    within(answers.len(), view.pages.limits.values, "answers can be handed in")?;
    let asks = |what: &str| fields.get("do") == Some(what);
    let further = fields.count("further")?.saturating_add(usize::from(asks("further")));
    let shown = fields.count("hints")?.saturating_add(usize::from(asks("hint"))).min(sheet.hints);
    let hints = (1..=shown).map(|number| HintResponse::of(&exercise, number).map(|response| response.hint));
    let hints = hints.collect::<Result<Vec<Fragment>, Refused>>()?;
    let sitting = Sitting { hints: further, closed: false };
    let is_answered = !answers.is_empty();
    let report = is_answered.then(|| MarkResponse::of(&exercise, &answers, fields.decimal(), sitting));
    let has_failed = asks("check") && report.iter().flat_map(|report| &report.parts).any(is_wrong);
    let failures = fields.count("failures")?.saturating_add(usize::from(has_failed));
    let work = fields.text("work").to_owned();
    let next = fields.count("next")?.saturating_add(usize::from(asks("next")));
    let is_judged = next > 0 || !work.trim().is_empty();
    let judged = is_judged.then(|| WorkResponse::of(&exercise, &work, fields.decimal(), next));
    let is_empty = asks("check") && !is_answered && !is_judged;
    let page = PracticePage {
        title: sheet.title.clone(),
        place: Place::of(&exercise, &variant)?,
        typed: typed(&sheet, &answers),
        read: read(&exercise, &sheet, &answers, fields)?,
        marked: marked(&sheet, report.as_ref()),
        more_further: report.iter().flat_map(|report| &report.parts).any(|part| part.more_hints),
        is_empty,
        failures,
        easier: if failures >= FAILURES { easier(view, exercise.problem().id())? } else { None },
        report,
        sheet,
        hints,
        further,
        decimal: fields.text("decimal").to_owned(),
        work,
        letters: exercise.letters_for_work(),
        judged,
        next,
        own_numbers: view.engine().problems.own_numbers(exercise.problem()).is_ok(),
    };
    view.page("practice", &page)
}

fn typed(sheet: &SheetResponse, answers: &BTreeMap<String, String>) -> Vec<String> {
    sheet.fields.iter().map(|field| answers.get(&field.id).cloned().unwrap_or_default()).collect()
}

/// Whether an answer is there, was read, and is not right.
fn is_wrong(part: &MarkedPart) -> bool {
    !part.right && part.understood.is_some()
}

/// How each answer is read; where there is none, or it was chosen, nothing is said.
fn read(
    exercise: &Exercise,
    sheet: &SheetResponse,
    answers: &BTreeMap<String, String>,
    fields: &Parameters,
) -> Result<Vec<ReadResponse>, Refused> {
    let typed = |id: &str| answers.get(id).map_or("", String::as_str);
    let fields_of_sheet = sheet.fields.iter();
    fields_of_sheet.map(|field| ReadResponse::of(exercise, &field.id, typed(&field.id), fields.decimal())).collect()
}

/// An easier problem on the same matter that is not withheld from the reader.
fn easier(view: &View<'_>, id: &str) -> Result<Option<Easier>, Refused> {
    let exhibits = view.pages.library.exhibits()?;
    let cards = || exhibits.iter().map(|exhibit| &exhibit.card);
    let Some(card_of_problem) = cards().find(|card| card.id == id) else { return Ok(None) };
    let is_open = |card: &&Card| view.is_open(&card.id);
    let offered = card_of_problem.easier(cards().filter(is_open));
    Ok(offered.map(|card| Easier { id: card.id.clone(), title: card.title.clone() }))
}

fn marked(sheet: &SheetResponse, report: Option<&MarkResponse>) -> Vec<Option<MarkedPart>> {
    let marked = |id: &str| report.and_then(|report| report.parts.iter().find(|part| part.id == id).cloned());
    sheet.fields.iter().map(|field| marked(&field.id)).collect()
}
