//! Marking several attempts of one student at one variant.

use std::collections::BTreeMap;

use crate::grade;
use crate::grade::Attempt;
use crate::problem::Worked;

use super::Exercise;
use super::marker::Marker;
use super::marking::Sitting;

/// One set of answers, by part, and how many hints the student had seen by then.
#[derive(Clone, Debug, Default)]
pub struct Try<'a> {
    /// The answers, each with its part.
    pub answers: Vec<(&'a str, &'a str)>,
    /// The hints seen.
    pub hints: u32,
}

impl Marker {
    /// Marks a student's attempts at a variant, the earliest first; so many more were made `before` the first of them. The marks
    /// depend on these, the variant and its rubric, and on nothing else.
    #[must_use]
    pub fn mark_attempts(&mut self, worked: Worked<'_>, attempts: &[Try<'_>], before: u32) -> Vec<Attempt> {
        let most = self.rubric().attempts.most;
        let made = |index: usize| before.saturating_add(u32::try_from(index + 1).unwrap_or(u32::MAX));
        let marked = attempts.iter().enumerate().map(|(index, own)| {
            let hints = usize::try_from(own.hints).unwrap_or(usize::MAX);
            let sitting = Sitting { hints, closed: most.is_some_and(|most| made(index) >= most) };
            Attempt { report: self.mark(worked, &own.answers, sitting), hints: own.hints }
        });
        let mut marked: Vec<Attempt> = marked.collect();
        grade::weigh(&mut marked, before, self.rubric());
        marked
    }
}

impl Exercise {
    /// Marks a student's attempts at this variant, the earliest first, after so many hints were shown: of each part what counts.
    /// `None` where there is no attempt.
    #[must_use]
    pub fn grade_attempts(
        &self,
        attempts: &[BTreeMap<String, String>],
        hints: u32,
        mark: grade::DecimalMark,
    ) -> Option<grade::Report> {
        let worked = self.worked();
        let mut marker = Marker::of(worked.problem, worked.form, mark);
        let tries = attempts.iter().map(|answers| Try {
            answers: answers.iter().map(|(id, text)| (id.as_str(), text.as_str())).collect(),
            hints,
        });
        grade::counted(&marker.mark_attempts(worked, &tries.collect::<Vec<_>>(), 0))
    }
}
