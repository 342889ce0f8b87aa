//! Problems that are not shown at the moment, since somebody's assignment holds them.

use std::sync::Arc;

use momentous_exercise::calls::{Problems, Refused};
use momentous_problem::Problem;

/// The problems that are shown and solved nowhere at the moment.
pub trait Withheld: Send + Sync {
    /// Refuses a problem that is withheld, by its id.
    ///
    /// # Errors
    /// The problem is withheld: why, and until when.
    fn check(&self, problem: &str) -> Result<(), Refused>;

    /// Refuses to solve a problem with numbers of whoever asks.
    ///
    /// # Errors
    /// Problems of this kind are not solved: why, and until when.
    fn check_own_numbers(&self, problem: &Problem) -> Result<(), Refused>;
}

/// Nothing is withheld: there are no courses.
pub struct Nothing;

impl Withheld for Nothing {
    fn check(&self, _: &str) -> Result<(), Refused> {
        Ok(())
    }

    fn check_own_numbers(&self, _: &Problem) -> Result<(), Refused> {
        Ok(())
    }
}

/// The problems without those that are withheld.
pub struct Open<'a> {
    /// All problems.
    pub problems: &'a dyn Problems,
    /// Those that are withheld.
    pub withheld: &'a dyn Withheld,
}

impl Problems for Open<'_> {
    fn problem(&self, id: &str) -> Result<Arc<Problem>, Refused> {
        self.withheld.check(id)?;
        self.problems.problem(id)
    }

    fn own_numbers(&self, problem: &Problem) -> Result<(), Refused> {
        self.withheld.check_own_numbers(problem)
    }
}
