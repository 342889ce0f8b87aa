//! Answers, marked.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::Serialize;

use momentous_grade::DecimalMark;
use momentous_grade::PartReport;
use momentous_grade::Points;
use momentous_grade::Sitting;

use super::super::Exercise;
use super::Engine;
use super::limits::within;
use super::refused::Refused;
use super::variant::VariantRequest;

/// Asks for marks.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct MarkRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// The typed answers, by part.
    pub answers: BTreeMap<String, String>,
    /// The sign between whole and decimal digits.
    #[serde(default)]
    pub decimal: DecimalMark,
    /// The number of further hints that the student has asked for on wrong answers.
    #[serde(default)]
    pub hints: usize,
    /// Whether no attempts are left: what follows from the student's own answers is then shown.
    #[serde(default)]
    pub closed: bool,
}

/// Marks, with the reason for each. Nothing in it holds a right value.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MarkResponse {
    /// The parts, in the order of the sheet.
    pub parts: Vec<MarkedPart>,
    /// The points reached.
    pub total: Points,
    /// The points that can be reached.
    pub out_of: u32,
    /// Whether every part is right.
    pub right: bool,
    /// Names in the answers that the question does not ask for.
    pub not_asked: Vec<String>,
}

/// A part, marked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MarkedPart {
    /// The name of the part in answers.
    pub id: String,
    /// The code of the verdict.
    pub verdict: &'static str,
    /// Whether the answer is right.
    pub right: bool,
    /// The points reached.
    pub points: Points,
    /// The points that can be reached.
    pub out_of: u32,
    /// The reading of the answer.
    pub understood: Option<String>,
    /// The message to the student, the hints asked for included.
    pub message: String,
    /// Whether a further hint can be asked for.
    pub more_hints: bool,
    /// The values that would have followed from the student's own earlier answers, once the question is closed.
    pub own_values: Option<String>,
}

impl MarkedPart {
    fn of(part: PartReport, hints: usize) -> Self {
        Self {
            id: part.id,
            verdict: part.verdict.code(),
            right: part.verdict.is_right(),
            points: part.points,
            out_of: part.out_of,
            understood: part.understood,
            message: part.message.into_owned(),
            more_hints: part.diagnosis.is_some_and(|diagnosis| diagnosis.hints.len() > hints + 1),
            own_values: part.own_values,
        }
    }
}

impl Engine<'_> {
    /// Marks answers to a variant.
    ///
    /// # Errors
    /// As for a sheet, and where there are too many answers.
    pub fn mark(&self, request: &MarkRequest) -> Result<MarkResponse, Refused> {
        let MarkRequest { variant, answers, decimal, hints, closed } = request;
        within(answers.len(), self.limits.values, "answers can be handed in")?;
        let sitting = Sitting { hints: *hints, closed: *closed };
        Ok(MarkResponse::of(&self.draw(variant)?, answers, *decimal, sitting))
    }
}

impl MarkResponse {
    /// Marks answers to a variant that was drawn. One with fewer figures than the sheet asks for is asked back.
    #[must_use]
    pub fn of(exercise: &Exercise, answers: &BTreeMap<String, String>, decimal: DecimalMark, sitting: Sitting) -> Self {
        let report = exercise.mark_or_ask(answers, decimal, sitting);
        let right = report.is_right();
        Self {
            parts: report.parts.into_iter().map(|part| MarkedPart::of(part, sitting.hints)).collect(),
            total: report.total,
            out_of: report.out_of,
            right,
            not_asked: report.not_asked,
        }
    }
}
