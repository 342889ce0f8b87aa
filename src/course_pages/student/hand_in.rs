//! Handing in, saving a draft, and reading while somebody types.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::json;

use momentous_course::{self as course, Attempt, Draft, Phase, Refusal, alike};
use momentous_exercise::calls::{ReadResponse, Refused, within};
use momentous_store::{HandIn, HandedIn};

use super::super::outcome::NotShown;
use super::super::reply::Reply;
use super::super::visit::Visit;
use super::item_page::{After, page};
use super::own_sheet::OwnSheet;

/// Before the name of a part in the names of fields.
pub(super) const ANSWER: &str = "answer.";
/// The bytes of the longest key by which a repeated request is known; the pages' own have 32.
const LONGEST_KEY: usize = 64;
/// The number of times that an attempt is marked again where others are handed in at the same time.
const AGAIN: usize = 8;

/// Hands in what was typed. The page that follows shows what is kept; a reload hands nothing in again.
pub(crate) async fn hand_in(visit: &Visit) -> Result<Reply, NotShown> {
    visit.courses.limits.answer(visit.person()?.key)?;
    let answers = answers(visit)?;
    let request = visit.fields.text("request").to_owned();
    within(request.len(), LONGEST_KEY, "bytes make the key of a request")?;
    for _ in 0..AGAIN {
        let own_sheet = OwnSheet::of(visit).await?;
        if let Some(before) = repeated(&own_sheet, &request, &answers) {
            return again(visit, &own_sheet, before);
        }
        if own_sheet.attempts.last().is_some_and(|last| alike(&last.answers, &answers)) {
            return refused(visit, &own_sheet, Refusal::NothingNew).await;
        }
        let (exercise, last, hints) =
            (Arc::clone(&own_sheet.exercise), own_sheet.last.clone(), own_sheet.hints.clone());
        let (policy, window) = (own_sheet.whole.assignment.policy.clone(), own_sheet.window.clone());
        let (decimal, typed, at) = (own_sheet.sheet.issued.decimal, answers.clone(), visit.now);
        let taken = visit
            .work(move |_| {
                let (answers, hints, last) = (&typed, hints.as_slice(), last.as_ref());
                let (policy, window, exercise) = (&policy, &window, exercise.as_ref());
                Ok(course::HandIn { exercise, decimal, last, answers, hints, policy, window, at }.take_or_ask())
            })
            .await?;
        let accepted = match taken {
            Ok(accepted) => accepted,
            Err(refusal) => return refused(visit, &own_sheet, refusal).await,
        };
        let number = own_sheet.attempts.last().map_or(0, |last| last.number) + 1;
        let report =
            serde_json::value::to_raw_value(&accepted.stored).map_err(|error| NotShown::Store(error.into()))?;
        let request = key(&own_sheet, &request, number);
        let attempt =
            Attempt { sheet: own_sheet.sheet.key, number, received: at, answers: answers.clone(), report, request };
        let hand_in = HandIn {
            attempt: &attempt,
            assignment: own_sheet.whole.assignment.key,
            revision: own_sheet.whole.revision,
        };
        match visit.store().hand_in(hand_in).await? {
            HandedIn::Kept => return Ok(Reply::To(own_sheet.address(visit)? + "#marks")),
            HandedIn::Before(before) if alike(&before.answers, &answers) => return again(visit, &own_sheet, &before),
            // Something came between; what it was decides anew.
            HandedIn::Before(_) | HandedIn::Stale => {}
        }
    }
    Err(NotShown::Conflict(
        "other answers to this problem were submitted at the same time, and these were not saved".to_owned(),
    ))
}

/// The attempt that this form was already: it has the same key and says the same, or has no key and says what was handed in last.
fn repeated<'a>(own_sheet: &'a OwnSheet, request: &str, answers: &BTreeMap<String, String>) -> Option<&'a Attempt> {
    let is_same = |attempt: &&Attempt| alike(&attempt.answers, answers);
    match request {
        "" => own_sheet.attempts.last().filter(is_same),
        _ => own_sheet.attempts.iter().filter(|attempt| is_of(attempt, request)).find(is_same),
    }
}

/// Whether an attempt was sent with a form of this key.
fn is_of(attempt: &Attempt, request: &str) -> bool {
    attempt.request.strip_prefix(request).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
}

/// The key under which an attempt is kept: that of its form, and where the form was sent before with other answers, or has none, its number.
fn key(own_sheet: &OwnSheet, request: &str, number: u32) -> String {
    match request {
        "" => format!("number {number}"),
        _ if own_sheet.attempts.iter().any(|attempt| is_of(attempt, request)) => format!("{request} {number}"),
        _ => request.to_owned(),
    }
}

/// The page again, which says which attempt it was.
fn again(visit: &Visit, own_sheet: &OwnSheet, before: &Attempt) -> Result<Reply, NotShown> {
    Ok(Reply::To(format!("{}?again={}#marks", own_sheet.address(visit)?, before.number)))
}

/// The typed answers, by part. They are kept for years, so there is not too much of them.
fn answers(visit: &Visit) -> Result<BTreeMap<String, String>, Refused> {
    let (answers, limits) = (visit.fields.behind(ANSWER), &visit.app.settings.limits);
    within(answers.len(), limits.values, "answers can be sent")?;
    let bytes = answers.iter().map(|(part, text)| part.len() + text.len()).sum();
    within(bytes, limits.request_bytes, "bytes of answers can be sent")?;
    Ok(answers)
}

/// The page with what was typed, and why it was not taken.
async fn refused(visit: &Visit, own_sheet: &OwnSheet, refusal: Refusal) -> Result<Reply, NotShown> {
    let after = After { typed: Some(visit.fields.behind(ANSWER)), refusal: Some(refusal.to_string()) };
    Ok(page(visit, own_sheet, after).await?.wrong())
}

/// Keeps what was typed without handing it in.
pub(crate) async fn draft(visit: &Visit) -> Result<Reply, NotShown> {
    visit.courses.limits.answer(visit.person()?.key)?;
    let answers = answers(visit)?;
    let own_sheet = OwnSheet::of(visit).await?;
    if !matches!(own_sheet.window.phase(visit.now), Phase::Open | Phase::Late(_)) {
        // What was saved in time stays what was saved last.
        return refused(visit, &own_sheet, Refusal::Over).await;
    }
    visit.store().save_draft(&Draft { sheet: own_sheet.sheet.key, answers, saved: visit.now, settled: None }).await?;
    if visit.fields.get("do") == Some("script") {
        return Ok(Reply::Json(json!({ "saved": visit.now.shown(&visit.course()?.zone) })));
    }
    Ok(Reply::To(own_sheet.address(visit)? + "#marks"))
}

/// How an answer is read. It knows the field and nothing of what is right.
pub(crate) async fn read(visit: &Visit) -> Result<Reply, NotShown> {
    visit.courses.limits.reading(visit.person()?.key)?;
    let own_sheet = OwnSheet::of(visit).await?;
    let [part, text] = ["part", "text"].map(|name| visit.fields.text(name).to_owned());
    let decimal = own_sheet.sheet.issued.decimal;
    let read = visit.work(move |_| Ok(ReadResponse::of(&own_sheet.exercise, &part, &text, decimal)?)).await?;
    Ok(Reply::Json(json!(read)))
}
