//! Problems that are not shown, solved or played while an assignment has them.

use std::collections::BTreeSet;

use super::assignment::{Assignment, Extension, Item};
use super::moment::Moment;
use super::window::RELEASED_AFTER;

/// The problems of open assignments, by their identities: any version, any form.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reserved {
    problems: BTreeSet<String>,
}

impl Reserved {
    /// Adds the problems of an assignment where it is open at a moment for anybody, students with an extension included, or closed so
    /// lately that answers may still be on their way.
    pub fn add(&mut self, assignment: &Assignment, items: &[Item], extensions: &[Extension], at: Moment) {
        let is_for_assignment = |extension: &&Extension| extension.assignment == assignment.key;
        let closes = extensions.iter().filter(is_for_assignment).map(|extension| extension.closes);
        let closes = closes.fold(assignment.policy.closes, Moment::max);
        if (assignment.policy.opens..=closes.after(RELEASED_AFTER)).contains(&at) {
            let items = items.iter().filter(|item| item.assignment == assignment.key && !item.dropped);
            self.problems.extend(items.map(|item| item.problem.clone()));
        }
    }

    /// The earliest close of an assignment whose problems are still reserved at a moment.
    #[must_use]
    pub fn closed_since(at: Moment) -> Moment {
        at.after(-RELEASED_AFTER)
    }

    /// Whether practice, own numbers, solutions and playing must refuse a problem to somebody.
    #[must_use]
    pub fn refuses(&self, problem: &str, is_staff: bool) -> bool {
        !is_staff && self.problems.contains(problem)
    }
}
