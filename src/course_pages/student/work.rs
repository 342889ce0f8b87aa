//! The work beside the answers of an item: what was typed, and what is found of each line.

use std::sync::Arc;

use serde::Serialize;

use momentous_course::{Phase, StoredReport};
use momentous_exercise::{JudgedLine, Letter, WorkVerdict};

use super::super::outcome::NotShown;
use super::super::visit::Visit;
use super::own_sheet::OwnSheet;

/// The message on a line with numbers while answers are taken.
const NUMBERS_LATER: &str = "Its numbers are judged with the answers.";

/// The work of a student on an item.
#[derive(Serialize)]
pub(super) struct WorkState {
    typed: String,
    /// The lines that were handed in last; other lines in the field are new.
    handed_in: String,
    /// Whether other work is no longer taken.
    locked: bool,
    /// The findings on the lines that were handed in, as far as verdicts are shown.
    lines: Vec<LineFound>,
    letters: Vec<Letter>,
}

#[derive(Serialize)]
struct LineFound {
    text: String,
    /// Nothing where it is not told yet.
    verdict: Option<WorkVerdict>,
    message: String,
}

impl WorkState {
    /// The work on a sheet: what was typed and not handed in, else what was handed in last.
    pub(super) async fn of(visit: &Visit, own_sheet: &OwnSheet, typed: Option<&String>) -> Result<Self, NotShown> {
        let stored = own_sheet.last.as_ref().and_then(|last| last.work.as_ref());
        let text = stored.map_or_else(String::new, |work| work.text.clone());
        let rules = own_sheet.whole.assignment.policy.rules();
        let is_right = |last: &StoredReport| last.parts.iter().all(|part| part.verdict.is_right());
        let is_open = matches!(own_sheet.window.phase(visit.now), Phase::Open | Phase::Late(_));
        let is_over = !is_open || own_sheet.last.as_ref().is_some_and(is_right);
        let judged = if own_sheet.window.shows_verdicts(visit.now) {
            let (exercise, work, decimal) =
                (Arc::clone(&own_sheet.exercise), text.clone(), own_sheet.sheet.issued.decimal);
            visit.work(move |_| Ok(exercise.judge_work(&work, decimal).0.lines)).await?
        } else {
            Vec::new()
        };
        Ok(Self {
            typed: typed.cloned().unwrap_or_else(|| text.clone()),
            handed_in: text,
            locked: !rules.counts(stored.map_or(0, |work| work.made)),
            lines: judged.into_iter().map(|line| LineFound::of(line, is_over)).collect(),
            letters: own_sheet.exercise.letters_for_work(),
        })
    }
}

impl LineFound {
    /// While answers are taken, a line with numbers is not told: a list of guesses would tell the right one.
    fn of(line: JudgedLine, is_over: bool) -> Self {
        if is_over || line.is_in_letters {
            Self { text: line.text, verdict: Some(line.verdict), message: line.message }
        } else {
            Self { text: line.text, verdict: None, message: NUMBERS_LATER.to_owned() }
        }
    }
}
