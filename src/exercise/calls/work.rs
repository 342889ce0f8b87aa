//! The lines of a student's work, judged.

use serde::Deserialize;
use serde::Serialize;

use momentous_grade::DecimalMark;
use momentous_render::Fragment;
use momentous_work::NextStep;
use momentous_work::WorkReport;

use super::super::Exercise;
use super::Engine;
use super::refused::Refused;
use super::variant::VariantRequest;

/// The hint for the next step that tells its equation.
const EQUATION: usize = 2;
/// The strongest hint for the next step: the equation with numbers.
const STRONGEST: usize = 3;

/// Asks what each line of a student's work is worth.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct WorkRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// The lines.
    pub work: String,
    /// The sign between whole and decimal digits.
    #[serde(default)]
    pub decimal: DecimalMark,
    /// How plain a hint for the next step is asked for: 0 for none, up to 3.
    #[serde(default)]
    pub next: usize,
}

/// The lines, judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WorkResponse {
    /// Judges each line, and says what is established.
    #[serde(flatten)]
    pub report: WorkReport,
    /// The next step, as plain as it was asked for.
    pub next: Option<String>,
    /// Whether it can be asked for more plainly.
    pub more_next: bool,
    /// The next step with its equation as mathematics, where it is asked for as plainly.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_set: Option<NextSet>,
}

/// The next step, set for a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NextSet {
    /// Which principle to use, and where.
    pub principle: String,
    /// The equation in symbols.
    pub equation: Fragment,
    /// The equation with numbers, where it is asked for as plainly as that.
    pub numbers: Option<String>,
}

impl Engine<'_> {
    /// Judges the lines of a student's work on a variant.
    ///
    /// # Errors
    /// As for a sheet.
    pub fn work(&self, request: &WorkRequest) -> Result<WorkResponse, Refused> {
        let WorkRequest { variant, work, decimal, next } = request;
        Ok(WorkResponse::of(&self.draw(variant)?, work, *decimal, *next))
    }
}

impl NextSet {
    fn of(step: &NextStep, next: usize) -> Option<Self> {
        let equation = step.math.as_ref().filter(|_| next >= EQUATION)?;
        Some(Self {
            principle: step.principle.clone(),
            equation: Fragment::math(equation),
            numbers: (next >= STRONGEST).then(|| step.numbers.clone()),
        })
    }
}

impl WorkResponse {
    /// The lines of work on a variant that was drawn, judged.
    #[must_use]
    pub fn of(exercise: &Exercise, work: &str, decimal: DecimalMark, next: usize) -> Self {
        let (report, step) = exercise.judge_work(work, decimal);
        Self {
            report,
            more_next: step.is_some() && next < STRONGEST,
            next_set: step.as_ref().and_then(|step| NextSet::of(step, next)),
            next: step.filter(|_| next > 0).map(|step| step.strength(next)),
        }
    }
}
