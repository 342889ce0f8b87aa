//! The application as one reader sees it.

use serde::Serialize;

use momentous_exercise::calls::{Engine, Refused};

use super::app::App;
use super::companion::{Open, Withheld};

/// The application as one reader sees it.
pub(super) struct View<'a> {
    pub(super) app: &'a App,
    problems: Open<'a>,
}

impl<'a> View<'a> {
    /// Without what is withheld from that reader.
    pub(super) fn new(app: &'a App, withheld: &'a dyn Withheld) -> Self {
        Self { app, problems: Open { problems: &app.library, withheld } }
    }

    /// The engine.
    pub(super) fn engine(&self) -> Engine<'_> {
        Engine { problems: &self.problems, ..self.app.engine() }
    }

    /// Whether a problem is not withheld from that reader.
    pub(super) fn is_open(&self, problem: &str) -> bool {
        self.problems.withheld.check(problem).is_ok()
    }

    /// A page through the template of that name.
    pub(super) fn page(&self, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.app.page(name, page)
    }
}
