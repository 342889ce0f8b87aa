//! The pages as one reader sees them.

use serde::Serialize;

use momentous_exercise::calls::{Engine, Refused};

use super::pages::{Beside, Pages};
use super::withheld::{Open, Withheld};

/// The pages as one reader sees them.
pub struct View<'a> {
    pub(super) pages: &'a Pages,
    beside: Beside,
    problems: Open<'a>,
}

impl<'a> View<'a> {
    /// Without what is withheld from that reader.
    pub fn new(pages: &'a Pages, beside: Beside, withheld: &'a dyn Withheld) -> Self {
        Self { pages, beside, problems: Open { problems: &pages.library, withheld } }
    }

    /// The engine.
    #[must_use]
    pub fn engine(&self) -> Engine<'_> {
        Engine { problems: &self.problems, ..self.pages.engine() }
    }

    /// Whether a problem is not withheld from that reader.
    pub(super) fn is_open(&self, problem: &str) -> bool {
        self.problems.withheld.check(problem).is_ok()
    }

    /// A page through the template of that name.
    pub(super) fn page(&self, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.pages.fill(&self.beside, None::<&()>, name, page)
    }
}
