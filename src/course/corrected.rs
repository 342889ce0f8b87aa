//! A corrected problem, or another policy, over what was handed in before: what would change for whom.

use std::sync::Arc;

use serde::Serialize;

use momentous_exercise::Exercise;
use momentous_exercise::Remark;
use momentous_exercise::WORK;
use momentous_problem::Problem;
use momentous_quantity::Rational;

use super::account::{Accounts, Deciding, GradeMark};
use super::assignment::{CorrectionChoice, Item};
use super::hand_in::HandIn;
use super::handed_in::{Attempt, HintShown, Sheet};
use super::key::Key;
use super::people::Member;
use super::policy::Policy;
use super::redaction::is_redacted;
use super::score::Score;
use super::stored_report::{StoredPart, StoredReport};
use super::window::{Late, Phase, Window};

/// A sheet with all that was handed in on it.
#[derive(Clone, Debug)]
pub struct WorkedSheet<'a> {
    /// The sheet.
    pub sheet: &'a Sheet,
    /// The attempts, the earliest first.
    pub attempts: &'a [Attempt],
    /// The hints that were shown.
    pub hints: &'a [HintShown],
    /// The stored reports of the attempts when they were marked last.
    pub reports: &'a [StoredReport],
    /// The times of the assignment for its student.
    pub window: Window,
}

/// The effect of a correction on a sheet.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Effect {
    /// The sheet.
    pub sheet: Key<Sheet>,
    /// Its student.
    pub member: Key<Member>,
    /// The sheet marked again.
    pub after: Remarked,
}

/// How a corrected problem is taken in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Regrading {
    /// The choice about the old sheets.
    pub choice: CorrectionChoice,
    /// Whether nobody has fewer points afterwards. An item that is dropped has none.
    pub never_lower: bool,
}

/// The standing of a student for an item after a correction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Regraded {
    /// The points, and how they come about.
    pub mark: GradeMark,
    /// The points that the student must keep by a record of their own, because marking would find fewer.
    pub keeps: Option<Rational>,
}

/// The outcome of marking a sheet again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Remarked {
    /// It is the sheet of the problem as it is now: the attempts as they are marked anew, in their order.
    Same(Vec<StoredReport>),
    /// The problem no longer draws or asks the same, or its file no longer loads. The kept reports stand until somebody chooses.
    Differs,
    /// An answer that counted was redacted, so that it cannot be marked. The kept reports stand.
    Redacted,
}

/// Marks sheets again when their problem is corrected, or their policy is another. The problem is `None` where its file no longer
/// loads.
#[must_use]
pub fn effects(sheets: &[WorkedSheet<'_>], policy: &Policy, problem: Option<&Arc<Problem>>) -> Vec<Effect> {
    let effect = |worked: &WorkedSheet<'_>| Effect {
        sheet: worked.sheet.key,
        member: worked.sheet.member,
        after: worked.remarked(policy, problem),
    };
    sheets.iter().map(effect).collect()
}

impl Accounts<'_> {
    /// The standing of a sheet's student for its item once a correction is taken in so.
    #[must_use]
    pub fn regraded(&self, effect: &Effect, item: &Item, regrading: Regrading) -> Regraded {
        let before = self.deciding(effect.member, item);
        let mut after = Deciding { full_marks: before.full_marks && regrading.never_lower, ..before.clone() };
        if let Remarked::Same(reports) = &effect.after {
            after.score = reports.last().and_then(Score::of);
        }
        // Points set by hand stand before and after, and what is under them must not have become less when they are taken back.
        let mut bare = Deciding { by_hand: None, ..before.clone() };
        match regrading.choice {
            CorrectionChoice::Remark => {}
            CorrectionChoice::FullMarks => after.full_marks = true,
            CorrectionChoice::Drop => after.dropped = true,
            CorrectionChoice::IssueAnew => {
                // They were set for the old sheet.
                after = Deciding { by_hand: None, score: None, ..after };
                bare = before;
            }
        }
        let (old, new) = (bare.mark(), Deciding { by_hand: None, ..after.clone() }.mark());
        let is_lower = regrading.never_lower && !after.dropped && new.points() < old.points();
        let keeps = old.points().filter(|_| is_lower).cloned();
        after.at_least = after.at_least.max(keeps.clone());
        Regraded { mark: after.mark(), keeps }
    }
}

impl WorkedSheet<'_> {
    /// The attempts marked anew, by the problem as it is now.
    #[must_use]
    pub fn remarked(&self, policy: &Policy, problem: Option<&Arc<Problem>>) -> Remarked {
        let issued = &self.sheet.issued;
        let same = problem.filter(|problem| issued.remark(problem) == Remark::Same);
        let Some(exercise) = same.and_then(|problem| issued.draw(problem).ok()) else { return Remarked::Differs };
        let is_lost = |(attempt, report): (&Attempt, &StoredReport)| {
            let counted = |part: &StoredPart| part.since == Some(attempt.received) && is_redacted(attempt, &part.id);
            report.parts.iter().any(counted) || is_redacted(attempt, WORK)
        };
        if self.attempts.iter().zip(self.reports).any(is_lost) {
            return Remarked::Redacted;
        }
        Remarked::Same(self.anew(policy, &exercise))
    }

    /// Marks all attempts. One that would no longer be taken keeps what its time cost.
    fn anew(&self, policy: &Policy, exercise: &Exercise) -> Vec<StoredReport> {
        let mut reports: Vec<StoredReport> = Vec::with_capacity(self.attempts.len());
        for (place, attempt) in self.attempts.iter().enumerate() {
            let kept = || -> Option<Late> { self.reports.get(place)?.late.clone() };
            let late = match self.window.phase(attempt.received) {
                Phase::Open => None,
                Phase::Late(late) => Some(late),
                Phase::NotOpen | Phase::Over | Phase::Closed => kept(),
            };
            let hand_in = HandIn {
                exercise,
                decimal: self.sheet.issued.decimal,
                last: reports.last(),
                answers: &attempt.answers,
                hints: self.hints,
                policy,
                window: &self.window,
                at: attempt.received,
            };
            let report = hand_in.marked(late);
            reports.push(report);
        }
        reports
    }
}
