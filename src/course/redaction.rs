//! Answers that somebody takes out of the records, because they say what must not be kept.

use momentous_exercise::WORK;
use serde::{Deserialize, Serialize};

use super::handed_in::{Attempt, Sheet};
use super::key::Key;
use super::moment::Moment;
use super::people::Person;
use super::stored_report::StoredReport;

/// The text in place of an answer.
const REDACTED: &str = "[redacted]";

/// The message on a redacted answer that could not be read.
const UNREAD: &str = "This answer was redacted.";

/// The order to take an answer out of the records. It is kept itself.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Redaction {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// The number of the attempt.
    pub number: u32,
    /// The part.
    pub part: String,
    /// Why.
    pub reason: String,
    /// The person who ordered it.
    pub by: Key<Person>,
    /// When.
    pub at: Moment,
}

/// Why an answer cannot be redacted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotRedacted {
    /// There is no such attempt.
    #[error("there is no such attempt")]
    NoAttempt,
    /// There is no such answer.
    #[error("there is no answer at this part")]
    NoAnswer,
    /// Why it is to go is not said.
    #[error("say why: it is kept with the marks")]
    NoReason,
    /// The stored report of the attempt cannot be read.
    #[error("the report of this attempt was written by another version of the program")]
    Report,
}

/// The attempts of a sheet that change where an answer is taken out of one of them: the same text goes wherever it stands, and each
/// line of work too. Verdict and points stay; so does what was understood, in words, where the text could be read, for then it is a
/// number, a formula or a choice, and the attempts after it are marked by it.
///
/// # Errors
/// A [`NotRedacted`].
pub fn redacted(attempts: &[Attempt], order: &Redaction) -> Result<Vec<Attempt>, NotRedacted> {
    let is_ordered = |attempt: &&Attempt| (attempt.sheet, attempt.number) == (order.sheet, order.number);
    let ordered = attempts.iter().find(is_ordered).ok_or(NotRedacted::NoAttempt)?;
    if order.reason.trim().is_empty() {
        return Err(NotRedacted::NoReason);
    }
    let removed = ordered.answers.get(&order.part).ok_or(NotRedacted::NoAnswer)?;
    let mut changed = Vec::new();
    for attempt in attempts.iter().filter(|attempt| attempt.sheet == order.sheet) {
        let without = without(attempt, &order.part, removed)?;
        if without.answers != attempt.answers || without.report.get() != attempt.report.get() {
            changed.push(without);
        }
    }
    Ok(changed)
}

/// An attempt without the text of a part.
fn without(attempt: &Attempt, part: &str, removed: &str) -> Result<Attempt, NotRedacted> {
    let mut attempt = attempt.clone();
    let mut report = StoredReport::of(&attempt).map_err(|_| NotRedacted::Report)?;
    let is_changed = attempt.answers.get_mut(part).is_some_and(|text| replace(text, removed));
    let mut unread =
        report.parts.iter_mut().filter(|stored| is_changed && stored.id == part && stored.unread.is_some());
    if let Some(stored) = unread.next() {
        // What is said of a text that cannot be read may quote it.
        stored.unread = Some(UNREAD.to_owned());
        UNREAD.clone_into(&mut stored.message);
    }
    // Work stands on in the reports of later attempts that say nothing of it.
    let stands_on = report.work.as_mut().filter(|_| part == WORK).is_some_and(|work| replace(&mut work.text, removed));
    if is_changed || stands_on {
        attempt.report = serde_json::value::to_raw_value(&report).map_err(|_| NotRedacted::Report)?;
    }
    Ok(attempt)
}

/// Replaces each line of a text that stands in another one; whether there was one.
fn replace(text: &mut String, removed: &str) -> bool {
    let stands =
        |line: &str| !line.trim().is_empty() && removed.lines().any(|line_removed| line_removed.trim() == line.trim());
    if !text.lines().any(stands) {
        return false;
    }
    let lines: Vec<&str> = text.lines().map(|line| if stands(line) { REDACTED } else { line }).collect();
    *text = if lines.iter().all(|line| *line == REDACTED) { REDACTED.to_owned() } else { lines.join("\n") };
    true
}

/// Whether the answer to a part was redacted, or a line of the work.
#[must_use]
pub fn is_redacted(attempt: &Attempt, part: &str) -> bool {
    attempt.answers.get(part).is_some_and(|text| text.lines().any(|line| line == REDACTED))
}
