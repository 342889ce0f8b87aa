//! Several attempts at the same question: which of them counts, and what the others cost.

use crate::quantity::Rational;

use super::messages::Message;
use super::report::{PartReport, Points, Report};
use super::rubric::{Keep, Rubric};
use super::verdict::Verdict;

/// The report on all attempts together, given that on each as if it were the only one, in their order, and the number of
/// hints that were shown before. An attempt that cannot be read, or that is empty, counts as none; part by part.
/// `None` where there is no attempt.
///
/// It depends on nothing but its arguments, so marking again after a correction of the problem gives every mark anew.
#[must_use]
pub fn over_attempts(attempts: &[Report], hints: u32, rubric: &Rubric) -> Option<Report> {
    let mut report = attempts.last()?.clone();
    for (position, part) in report.parts.iter_mut().enumerate() {
        let tries: Vec<&PartReport> = attempts.iter().filter_map(|attempt| attempt.parts.get(position)).collect();
        *part = counted(&tries, hints, rubric).unwrap_or_else(|| part.clone());
    }
    report.total = Points(report.parts.iter().fold(Rational::ZERO, |sum, part| sum + &part.points.0));
    Some(report)
}

/// The attempt at a part that counts, with the points that are left of it.
fn counted(tries: &[&PartReport], hints: u32, rubric: &Rubric) -> Option<PartReport> {
    let read = tries.iter().filter(|part| !matches!(part.verdict, Verdict::Unanswered | Verdict::Unreadable));
    let mut kept: Option<PartReport> = None;
    for (before, part) in (0..).zip(read).take_while(|(before, _)| rubric.attempts.counts(*before)) {
        let left = rubric.attempts.left(before, hints);
        let points = Points(&part.points.0 * &left);
        let better = kept.as_ref().is_none_or(|kept| points > kept.points);
        if better || rubric.attempts.keep == Keep::Last {
            let mut part = (*part).clone();
            if points != part.points {
                let percent = (Rational::from(100) * (Rational::ONE - left)).to_f64().value();
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 100")]
                let reduced = Message::Reduced(libm::round(percent) as u32);
                part.message = format!("{} {reduced}", part.message);
            }
            part.points = points;
            kept = Some(part);
        }
    }
    kept
}
