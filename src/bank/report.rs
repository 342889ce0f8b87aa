//! Reports of an audit on a problem.

use std::collections::BTreeMap;

use serde::Serialize;

use momentous_fault::{Fault, Faults, Span};
use momentous_witness::Simulated;

use super::promise::Finding;
use super::promise::Outcome;
use super::promise::Promise;

/// The report on one problem; the keys of `momentous check --format json`.
#[derive(Clone, Debug, Serialize)]
pub struct Audit {
    /// Its identity; none where the file does not load.
    pub problem: Option<String>,
    /// The path of its file.
    pub file: String,
    /// The digest of its file.
    pub digest: String,
    /// Every fault of the file, where it does not load or cannot be planned.
    pub faults: Option<String>,
    /// The failures, each with its place in the file where it has one: faults, and promises that are broken.
    pub failing: Vec<Failing>,
    /// The audits of the forms; empty where there are faults.
    pub forms: Vec<FormAudit>,
}

/// Something that fails, in a sentence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Failing {
    /// The line of the file, from 1.
    pub line: Option<usize>,
    /// The column, from 1.
    pub column: Option<usize>,
    /// The failure, and the form in which it occurs.
    pub message: String,
}

/// The audit of one form.
#[derive(Clone, Debug, Serialize)]
pub struct FormAudit {
    /// Its name; none where the problem has one form without a name.
    pub form: Option<String>,
    /// The number of seeds that were drawn, from 1.
    pub seeds: u64,
    /// The number of different sets of numbers before any is rejected; at most 2^64 - 1.
    pub combinations: u64,
    /// The number of different sets of numbers that these seeds drew.
    pub variants: usize,
    /// The number of different texts of sheets that these seeds drew.
    pub sheets: usize,
    /// The share of draws that were not rejected.
    pub acceptance: f64,
    /// The laws that lead to the answers, each once, in the order of their use.
    pub laws: Vec<String>,
    /// The answers, part by part.
    pub answers: Vec<AnswerSpread>,
    /// The findings on the promises.
    pub promises: Vec<Finding>,
    /// How it was simulated, and how closely that agrees.
    pub simulation: Simulated,
}

/// How the answers to one part lie.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum AnswerSpread {
    /// Numbers, in the unit of the question.
    Number {
        /// The part.
        id: String,
        /// The unit.
        unit: String,
        /// The smallest answer.
        least: f64,
        /// A quarter of the answers are at most this.
        lower_quartile: f64,
        /// Half of the answers are at most this.
        median: f64,
        /// Three quarters of the answers are at most this.
        upper_quartile: f64,
        /// The largest answer.
        most: f64,
        /// The number of answers that differ as they are printed.
        distinct: usize,
        /// The largest bound on an error.
        error_bound: Option<f64>,
    },
    /// A choice, or a formula.
    Choice {
        /// The part.
        id: String,
        /// The number of times that each phrase, or each formula, is the right one.
        right: BTreeMap<String, usize>,
    },
}

impl Failing {
    pub(super) fn nowhere(message: String) -> Self {
        Self { line: None, column: None, message }
    }

    /// Each fault of a file.
    pub(super) fn placed(faults: &Faults) -> Vec<Self> {
        let place = |span: Span| faults.source.line_and_column(span.start);
        let placed = |fault: &Fault| {
            let (line, column) = fault.span.map(place).unzip();
            let help = fault.help.as_ref().map_or_else(String::new, |help| format!("; {help}"));
            Self { line, column, message: format!("{}{help}", fault.message) }
        };
        faults.list.iter().map(placed).collect()
    }

    /// Each promise that a form breaks.
    pub(super) fn broken(form: &FormAudit) -> Vec<Self> {
        let name = form.form.as_ref().map_or_else(String::new, |form| format!("{form}: "));
        let broken = |finding: &Finding| match &finding.outcome {
            Outcome::Broken(remark) => {
                Some(Self::nowhere(format!("{name}broken: {}: {remark}", finding.promise.sentence())))
            }
            Outcome::Kept | Outcome::Noted(_) | Outcome::Acknowledged { .. } | Outcome::NotChecked(_) => None,
        };
        form.promises.iter().filter_map(broken).collect()
    }
}

impl Audit {
    /// Whether anything does not hold.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.faults.is_some() || self.forms.iter().any(FormAudit::is_broken)
    }
}

impl FormAudit {
    /// The finding on a promise.
    #[must_use]
    pub fn outcome(&self, promise: Promise) -> Option<&Outcome> {
        self.promises.iter().find(|finding| finding.promise == promise).map(|finding| &finding.outcome)
    }

    /// Whether a promise does not hold.
    #[must_use]
    pub fn is_broken(&self) -> bool {
        self.promises.iter().any(|finding| matches!(finding.outcome, Outcome::Broken(_)))
    }
}
