//! The work beside the answers: its lines judged, and points for the method where an answer is missing or wrong.

use std::collections::BTreeMap;

use momentous_grade::DecimalMark;
use momentous_grade::Points;
use momentous_grade::Report;
use momentous_grade::Sitting;
use momentous_problem::Worked;
use momentous_quantity::Rational;
use momentous_work::Letter;
use momentous_work::NextStep;
use momentous_work::WorkReport;

use super::Exercise;

/// The name under which work stands among answers.
pub const WORK: &str = "work";

impl Exercise {
    /// Judges the lines of a student's work, and says what comes next; nothing where they hold all that the answers need.
    #[must_use]
    pub fn judge_work(&self, work: &str, decimal: DecimalMark) -> (WorkReport, Option<NextStep>) {
        momentous_work::judge(self.worked(), work, decimal)
    }

    /// Whether there is work to be judged: something that is asked follows from equations, and no part is called so.
    #[must_use]
    pub fn takes_work(&self) -> bool {
        let worked = self.worked();
        work_among(worked, &[(WORK, "")]).is_some() && !worked.leaf().answer_steps().is_empty()
    }

    /// The letters that the lines of a student's work may hold.
    #[must_use]
    pub fn letters_for_work(&self) -> Vec<Letter> {
        momentous_work::letters(self.worked())
    }

    /// Marks answers and the work that led to them.
    #[must_use]
    pub fn mark_with_work(
        &self,
        answers: &BTreeMap<String, String>,
        work: &str,
        decimal: DecimalMark,
        sitting: Sitting,
    ) -> Report {
        let mut answers = answers.clone();
        answers.insert(WORK.to_owned(), work.to_owned());
        self.mark(&answers, decimal, sitting)
    }
}

/// The work among answers: what stands under its name, where no part is called so.
pub(super) fn work_among<'a>(worked: Worked<'_>, answers: &[(&str, &'a str)]) -> Option<&'a str> {
    let is_part = worked.form.parts.iter().any(|part| part.id == WORK);
    answers.iter().find(|(id, _)| *id == WORK && !is_part).map(|(_, work)| *work)
}

/// Gives each part whose answer is missing or wrong the share of its points that the method in the work is worth, times a factor.
pub(super) fn credit(report: &mut Report, worked: Worked<'_>, (work, factor): (&str, &Rational), decimal: DecimalMark) {
    if report.is_right() {
        return;
    }
    let (judged, _) = momentous_work::judge(worked, work, decimal);
    if judged.points == 0 {
        return;
    }
    let share = factor * Rational::from(judged.points) / Rational::from(judged.out_of);
    for part in &mut report.parts {
        let method = Points(Rational::from(part.out_of) * &share);
        if method > part.points {
            let said = format!("{} {method} of {} points for the work.", part.message, part.out_of);
            part.message = said.trim().to_owned().into();
            part.points = method;
        }
    }
    report.recount();
}
