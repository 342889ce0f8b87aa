//! The most frequent of many wrong answers, found in memory that does not grow with them (Misra and Gries, 1982).

use std::collections::BTreeMap;

use serde::Serialize;

use super::report::PartReport;

/// Candidates that are counted at a time.
const CANDIDATES: usize = 256;
/// The most that are told.
const TOLD: usize = 5;

/// Wrong answers, counted.
#[derive(Clone, Debug, Default)]
pub(super) struct Frequent(BTreeMap<String, WrongAnswer>);

/// A wrong answer that several students gave.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WrongAnswer {
    /// The answer as it was understood.
    pub answer: String,
    /// How often it was given, at least: where there are very many different ones, some are missed.
    pub count: u64,
    /// The verdict that it got first.
    pub verdict: &'static str,
    /// The usual mistakes that lead to it, by their codes.
    pub mistakes: Vec<&'static str>,
}

impl Frequent {
    /// Counts an answer that is not right.
    pub(super) fn add(&mut self, part: &PartReport) {
        let Some(answer) = &part.understood else { return };
        if let Some(known) = self.0.get_mut(answer) {
            known.count += 1;
        } else if self.0.len() < CANDIDATES {
            let mistakes = part.diagnosis.as_ref().map(|diagnosis| diagnosis.codes.clone()).unwrap_or_default();
            let fresh = WrongAnswer { answer: answer.clone(), count: 1, verdict: part.verdict.code(), mistakes };
            self.0.insert(answer.clone(), fresh);
        } else {
            // One of every candidate goes with it, so that what stays is more frequent than the rest.
            self.0.retain(|_, wrong| {
                wrong.count -= 1;
                wrong.count > 0
            });
        }
    }

    /// Those that were given more than once, the most frequent first.
    pub(super) fn most(&self) -> Vec<WrongAnswer> {
        let mut several: Vec<WrongAnswer> = self.0.values().filter(|wrong| wrong.count > 1).cloned().collect();
        several.sort_by_key(|wrong| std::cmp::Reverse(wrong.count));
        several.truncate(TOLD);
        several
    }
}
