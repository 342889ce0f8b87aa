//! The page of an item: the sheet, what was handed in, and what was found.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_course::{self as course, Attempt, Found, Item, Phase, ShownPart, StoredReport, Unsubmitted};
use momentous_exercise::WORK;
use momentous_exercise::calls::{FieldResponse, HintResponse, ReadResponse, SheetResponse};
use momentous_grade::{Entry, Points};
use momentous_quantity::Rational;
use momentous_render::Fragment;

use super::super::at_close;
use super::super::ledger::{Has, Records};
use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::session;
use super::super::visit::Visit;
use super::own_sheet::OwnSheet;
use super::work::WorkState;

#[derive(Serialize)]
struct ItemPage {
    title: String,
    assignment: String,
    assignment_title: String,
    item: String,
    /// The key by which a repeated request is known.
    request: String,
    sheet: SheetResponse,
    fields: Vec<FieldState>,
    /// The work beside the answers, where the problem takes any.
    work: Option<WorkState>,
    /// The receipt of each attempt: its number and when the server had it.
    receipts: Vec<Receipt>,
    /// The standing for the item, once verdicts are shown.
    has: Option<Has>,
    out_of: u32,
    phase: &'static str,
    /// The share of the points that is left now, where answers are late.
    left: Option<String>,
    due: String,
    closes: String,
    hints: Vec<Fragment>,
    hint_costs: Option<String>,
    further_costs: Option<String>,
    attempts: Option<u32>,
    attempt_costs: Option<String>,
    verdicts_later: bool,
    shows_solution: bool,
    /// Why nothing was taken, where the page follows a form.
    refusal: Option<String>,
    /// The attempt that the form was already, where it was sent twice.
    again: Option<u32>,
    saved: Option<String>,
    /// Whether what is saved is handed in when no more is taken.
    hands_in_at_close: bool,
    /// The problems of the assignment before and after this one.
    before: Option<Neighbour>,
    next: Option<Neighbour>,
}

#[derive(Serialize)]
struct FieldState {
    typed: String,
    /// The text handed in last; other text in the field is new.
    handed_in: String,
    /// The share of its points that a new answer can earn, in per cent; nothing where none would be marked.
    worth: Option<String>,
    /// Whether the answer can no longer be changed, because it is right.
    locked: bool,
    /// The number of attempts that are left; nothing where any number is.
    left: Option<u32>,
    read: Option<String>,
    unread: Option<String>,
    found: Option<Found>,
    further: Vec<String>,
    more_further: bool,
}

#[derive(Serialize)]
struct Receipt {
    number: u32,
    received: String,
    late: bool,
    counts: bool,
    /// Whether it was handed in by itself, as it was saved.
    at_close: bool,
    /// The typed answers, each with the label of its part.
    typed: Vec<(String, String)>,
}

/// Another problem of the assignment.
#[derive(Serialize)]
struct Neighbour {
    key: String,
    number: usize,
}

/// The text in the fields after a form, in place of what was handed in.
#[derive(Default)]
pub(super) struct After {
    pub(super) typed: Option<BTreeMap<String, String>>,
    pub(super) refusal: Option<String>,
}

/// The page of an item.
pub(crate) async fn item(visit: &Visit) -> Result<Reply, NotShown> {
    let own_sheet = OwnSheet::of(visit).await?;
    page(visit, &own_sheet, After::default()).await
}

pub(super) async fn page(visit: &Visit, own_sheet: &OwnSheet, after: After) -> Result<Reply, NotShown> {
    let course = visit.course()?;
    let zone = course.zone.as_str();
    let draft = visit.store().draft(own_sheet.sheet.key).await?;
    let last_received = own_sheet.attempts.last().map(|attempt| attempt.received);
    let draft = draft.filter(|draft| last_received.is_none_or(|received| draft.saved > received));
    let saved = draft.as_ref().map(|draft| draft.saved.shown(zone));
    let typed = after.typed.or(draft.map(|draft| draft.answers)).unwrap_or_default();
    let shown_hints: Vec<u32> =
        own_sheet.hints.iter().filter(|hint| hint.part.is_none()).map(|hint| hint.number).collect();
    let exercise = std::sync::Arc::clone(&own_sheet.exercise);
    let (drafted, decimal) = (typed.clone(), own_sheet.sheet.issued.decimal);
    let (sheet, hints, readings) = visit
        .work(move |_| {
            let hint =
                |number: &u32| Ok(HintResponse::of(&exercise, usize::try_from(*number).unwrap_or(usize::MAX))?.hint);
            let hints = shown_hints.iter().map(hint).collect::<Result<Vec<Fragment>, NotShown>>()?;
            let asked = drafted.iter().filter(|(part, _)| exercise.part(part).is_some());
            let read = |(part, text): (&String, &String)| {
                Ok((part.clone(), ReadResponse::of(&exercise, part, text, decimal)?))
            };
            let readings = asked.map(read).collect::<Result<BTreeMap<String, ReadResponse>, NotShown>>()?;
            Ok((SheetResponse::of(&exercise)?, hints, readings))
        })
        .await?;
    let policy = &own_sheet.whole.assignment.policy;
    let shown = own_sheet.last.as_ref().map(|last| last.shown(&own_sheet.window, visit.now));
    let field = |id: &String| {
        let part = shown.as_ref().and_then(|shown| shown.parts.iter().find(|part| part.id == *id));
        let stored = own_sheet.last.as_ref();
        FieldState::of(id, part, stored, own_sheet, visit, (typed.get(id), readings.get(id)))
    };
    let phase = own_sheet.window.phase(visit.now);
    let (before, next) = neighbours(own_sheet);
    let costs = |share: &momentous_course::Share| (!share.is_nothing()).then(|| share.percent());
    let has = if own_sheet.window.shows_verdicts(visit.now) {
        let records = Records::of_sheet(visit, &own_sheet.whole, &own_sheet.sheet, own_sheet.last.as_ref()).await?;
        records.standing(own_sheet.sheet.member, own_sheet.item.key).as_ref().map(Has::of)
    } else {
        None
    };
    let work = if own_sheet.exercise.takes_work() {
        Some(WorkState::of(visit, own_sheet, typed.get(WORK)).await?)
    } else {
        None
    };
    let page = ItemPage {
        title: sheet.title.clone(),
        assignment: own_sheet.whole.assignment.key.to_string(),
        assignment_title: own_sheet.whole.assignment.title.clone(),
        item: own_sheet.item.key.to_string(),
        request: session::key::<()>().to_string(),
        fields: sheet.fields.iter().map(|response| field(&response.id)).collect(),
        work,
        receipts: receipts(own_sheet, &sheet, zone),
        has,
        out_of: own_sheet.item.points,
        left: match &phase {
            Phase::Late(late) => Some(Points(&late.factor * Rational::from(100)).to_string()),
            _ => None,
        },
        phase: match phase {
            Phase::NotOpen => "not open",
            Phase::Open => "open",
            Phase::Late(_) => "late",
            Phase::Over | Phase::Closed => "closed",
        },
        due: own_sheet.window.due.shown(zone),
        closes: own_sheet.window.closes.shown(zone),
        hints,
        hint_costs: costs(&policy.hint_penalty),
        further_costs: costs(&policy.further_penalty),
        attempts: policy.attempts,
        attempt_costs: costs(&policy.attempt_penalty),
        verdicts_later: !own_sheet.window.shows_verdicts(visit.now),
        shows_solution: own_sheet.window.shows_solutions(visit.now),
        refusal: after.refusal,
        again: visit.fields.get("again").and_then(|number| number.parse().ok()),
        saved,
        hands_in_at_close: policy.unsubmitted == Unsubmitted::HandIn,
        before,
        next,
        sheet,
    };
    visit.page("courses/item", page).await
}

impl FieldState {
    fn of(
        id: &str,
        part: Option<&ShownPart>,
        stored: Option<&StoredReport>,
        own_sheet: &OwnSheet,
        visit: &Visit,
        (typed, reading): (Option<&String>, Option<&ReadResponse>),
    ) -> Self {
        let policy = &own_sheet.whole.assignment.policy;
        let place = own_sheet.exercise.worked().form.parts.iter().position(|part| part.id == id);
        let history = stored.and_then(|stored| stored.history.parts().get(place?));
        let stands = history.map(|history| history.text().to_owned()).unwrap_or_default();
        // What could not be read does not stand, and yet was typed.
        let handed_in = own_sheet.unread(id).map_or_else(|| stands.clone(), str::to_owned);
        let kept = stored.and_then(|stored| stored.part(id));
        let locked = part.is_some_and(|part| {
            part.entry == Entry::Locked || part.found.as_ref().is_some_and(|finding| finding.right)
        });
        let is_new = typed.is_some_and(|typed| typed.trim() != handed_in.trim());
        let reading = reading.filter(|_| is_new && !locked);
        let (read, unread) = match reading {
            Some(reading) => (reading.understood.clone(), reading.unreadable.clone()),
            None => (part.and_then(|part| part.read.clone()), part.and_then(|part| part.unread.clone())),
        };
        let worth = course::worth(policy, (id, history), &own_sheet.hints, &own_sheet.window.phase(visit.now));
        Self {
            typed: if locked { stands } else { typed.cloned().unwrap_or_else(|| handed_in.clone()) },
            handed_in,
            worth: worth.filter(|_| !locked).map(|share| Points(share * Rational::from(100)).to_string()),
            locked,
            left: policy.attempts.map(|most| most.saturating_sub(part.map_or(0, |part| part.made))),
            read,
            unread,
            found: part.and_then(|part| part.found.clone()),
            further: kept.into_iter().flat_map(|kept| kept.hints_shown(&own_sheet.hints)).map(str::to_owned).collect(),
            more_further: kept
                .is_some_and(|kept| kept.next_hint(&own_sheet.hints, &own_sheet.window, visit.now).is_some()),
        }
    }
}

/// The problems before and after this one, of those that count.
fn neighbours(own_sheet: &OwnSheet) -> (Option<Neighbour>, Option<Neighbour>) {
    let items: Vec<&Item> = own_sheet.whole.items.iter().filter(|item| !item.dropped).collect();
    let at = |place: usize| items.get(place).map(|item| Neighbour { key: item.key.to_string(), number: place + 1 });
    match items.iter().position(|item| item.key == own_sheet.item.key) {
        Some(place) => (place.checked_sub(1).and_then(at), at(place + 1)),
        None => (None, None),
    }
}

fn receipts(own_sheet: &OwnSheet, sheet: &SheetResponse, zone: &str) -> Vec<Receipt> {
    let counting = own_sheet.last.as_ref().and_then(|last| last.history.counting());
    let typed = |attempt: &Attempt| {
        let text =
            |field: &FieldResponse| Some((field.label.clone(), attempt.answers.get(&field.id)?.trim().to_owned()));
        let work = attempt.answers.get(WORK).map(|work| ("work".to_owned(), work.trim().to_owned()));
        sheet.fields.iter().filter_map(text).chain(work).filter(|(_, text)| !text.is_empty()).collect()
    };
    let receipt = |attempt: &Attempt| Receipt {
        number: attempt.number,
        received: attempt.received.shown_exactly(zone),
        late: attempt.received > own_sheet.window.due,
        counts: counting == Some(attempt.number),
        at_close: attempt.request == at_close::REQUEST,
        typed: typed(attempt),
    };
    own_sheet.attempts.iter().map(receipt).collect()
}
