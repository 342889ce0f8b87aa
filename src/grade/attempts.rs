//! Several attempts at one variant: what each is worth after those before it, and which counts.

use crate::quantity::Rational;

use super::messages::Message;
use super::report::{PartReport, Points, Report};
use super::rubric::{Keep, Rubric};
use super::verdict::Verdict;

/// One of a student's attempts at a variant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// What was found.
    pub report: Report,
    /// How many hints the student had seen by then.
    pub hints: u32,
}

/// Takes from every attempt what the ones before it and the hints cost, and lets one of each part count: the best, or the last.
///
/// They stand in their order; so many more were made `before` the first. What cannot be read, or is empty, costs no attempt,
/// and counts only where nothing else does.
pub fn weigh(attempts: &mut [Attempt], before: u32, rubric: &Rubric) {
    let parts = attempts.iter().map(|attempt| attempt.report.parts.len()).max().unwrap_or(0);
    for position in 0..parts {
        let mut made = before;
        let mut kept: Option<(usize, Points)> = None;
        for (index, attempt) in attempts.iter_mut().enumerate() {
            let Some(part) = attempt.report.parts.get_mut(position) else { continue };
            part.counts = false;
            if matches!(part.verdict, Verdict::Unanswered | Verdict::Unreadable) {
                continue;
            }
            let counts = rubric.attempts.counts(made);
            reduce(part, made, attempt.hints, rubric);
            made = made.saturating_add(1);
            let better = kept.as_ref().is_none_or(|(_, best)| part.points > *best);
            if counts && (better || rubric.attempts.keep == Keep::Last) {
                kept = Some((index, part.points.clone()));
            }
        }
        let kept = kept.map_or(attempts.len().saturating_sub(1), |(index, _)| index);
        if let Some(part) = attempts.get_mut(kept).and_then(|attempt| attempt.report.parts.get_mut(position)) {
            part.counts = true;
        }
    }
    for attempt in attempts {
        attempt.report.recount();
    }
}

/// Takes from a part what the attempts before it and the hints cost; after the last attempt everything.
fn reduce(part: &mut PartReport, made: u32, hints: u32, rubric: &Rubric) {
    if !rubric.attempts.counts(made) {
        part.points = Points::default();
        part.message = format!("{} {}", part.message, Message::NoAttemptLeft).into();
        return;
    }
    if made == 0 && hints == 0 || part.points == Points::default() {
        return;
    }
    let left = rubric.attempts.left(made, hints);
    if left == Rational::ONE {
        return;
    }
    part.points = Points(&part.points.0 * &left);
    let percent = (Rational::from(100) * (Rational::ONE - left)).to_f64().value();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 100")]
    let reduced = Message::Reduced(libm::round(percent) as u32);
    part.message = format!("{} {reduced}", part.message).into();
}

/// The report on several attempts at one variant, the earliest first: of each part what counts.
///
/// `hints` is the number of hints that were shown. `None` where there is no attempt.
#[must_use]
pub fn over_attempts(attempts: &[Report], hints: u32, rubric: &Rubric) -> Option<Report> {
    let mut attempts: Vec<Attempt> = attempts.iter().map(|report| Attempt { report: report.clone(), hints }).collect();
    weigh(&mut attempts, 0, rubric);
    counted(&attempts)
}

/// Of each part the attempt that counts. `None` where there is no attempt.
#[must_use]
pub fn counted(attempts: &[Attempt]) -> Option<Report> {
    let mut whole = attempts.last()?.report.clone();
    for (position, part) in whole.parts.iter_mut().enumerate() {
        let own = attempts.iter().filter_map(|own| own.report.parts.get(position)).find(|part| part.counts);
        *part = own?.clone();
    }
    whole.recount();
    Some(whole)
}
