//! Answers that somebody takes out of the records, because they say what must not be kept.

use momentous_exercise::WORK;
use serde::{Deserialize, Serialize};

use super::handed_in::{Attempt, Sheet};
use super::key::Key;
use super::moment::Moment;
use super::people::Person;
use super::stored_report::StoredReport;

/// What stands where an answer was.
const REDACTED: &str = "[redacted]";

/// What is said of a redacted answer that could not be read.
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
    /// Who ordered it.
    pub by: Key<Person>,
    /// When.
    pub at: Moment,
}

/// Why an answer cannot be redacted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotRedacted {
    /// The order is about another attempt.
    #[error("this is another attempt")]
    AnotherAttempt,
    /// There is no such answer.
    #[error("there is no answer at this part")]
    NoAnswer,
    /// Why it is to go is not said.
    #[error("say why: it is kept with the marks")]
    NoReason,
    /// What was kept of the attempt cannot be read.
    #[error("the report of this attempt was written by another version of the program")]
    Report,
}

/// The attempt without the answer. Verdict and points stay; so does what was understood, in words, where the text could be read, for
/// then it is a number, a formula or a choice, and the attempts after it are marked by it.
///
/// # Errors
/// A [`NotRedacted`].
pub fn redacted(attempt: &Attempt, order: &Redaction) -> Result<Attempt, NotRedacted> {
    if (attempt.sheet, attempt.number) != (order.sheet, order.number) {
        return Err(NotRedacted::AnotherAttempt);
    }
    if order.reason.trim().is_empty() {
        return Err(NotRedacted::NoReason);
    }
    let mut attempt = attempt.clone();
    let text = attempt.answers.get_mut(&order.part).ok_or(NotRedacted::NoAnswer)?;
    REDACTED.clone_into(text);
    let mut report = StoredReport::of(&attempt).map_err(|_| NotRedacted::Report)?;
    if let Some(part) = report.parts.iter_mut().find(|part| part.id == order.part && part.unread.is_some()) {
        // What is said of a text that cannot be read may quote it.
        part.unread = Some(UNREAD.to_owned());
        UNREAD.clone_into(&mut part.message);
    }
    if let Some(work) = report.work.as_mut().filter(|_| order.part == WORK) {
        REDACTED.clone_into(&mut work.text);
    }
    attempt.report = serde_json::value::to_raw_value(&report).map_err(|_| NotRedacted::Report)?;
    Ok(attempt)
}

/// Whether the answer to a part was redacted.
#[must_use]
pub fn is_redacted(attempt: &Attempt, part: &str) -> bool {
    attempt.answers.get(part).is_some_and(|text| text == REDACTED)
}
