//! The work beside the answers: its lines judged, and points for the method where an answer is missing or wrong.

use std::collections::BTreeMap;

use momentous_grade::DecimalMark;
use momentous_grade::Points;
use momentous_grade::Report;
use momentous_grade::Sitting;
use momentous_quantity::Rational;
use momentous_work::Judge;
use momentous_work::NextStep;
use momentous_work::WorkReport;

use super::Exercise;

impl Exercise {
    /// Judges the lines of a student's work.
    #[must_use]
    pub fn judge_work(&self, work: &str, decimal: DecimalMark) -> WorkReport {
        momentous_work::judge(self.worked(), work, decimal)
    }

    /// The next step behind a student's lines; none where they hold all that the answers need.
    #[must_use]
    pub fn next_step(&self, work: &str, decimal: DecimalMark) -> Option<NextStep> {
        let mut judge = Judge::new(self.worked(), decimal);
        momentous_work::lines(work).for_each(|line| {
            judge.line(line);
        });
        judge.next_step()
    }

    /// Marks answers and the work that led to them: a part whose answer is missing or wrong gets the share of its points that the
    /// method is worth.
    #[must_use]
    pub fn mark_with_work(
        &self,
        answers: &BTreeMap<String, String>,
        work: &str,
        decimal: DecimalMark,
        sitting: Sitting,
    ) -> (Report, WorkReport) {
        let mut report = self.mark(answers, decimal, sitting);
        let judged = self.judge_work(work, decimal);
        let share = if judged.out_of == 0 {
            Rational::ZERO
        } else {
            Rational::from(judged.points) / Rational::from(judged.out_of)
        };
        for part in &mut report.parts {
            let method = Points(Rational::from(part.out_of) * &share);
            if method > part.points {
                part.message = format!("{} {method} of {} points for the work.", part.message, part.out_of)
                    .trim()
                    .to_owned()
                    .into();
                part.points = method;
            }
        }
        report.recount();
        (report, judged)
    }
}
