//! The state that all requests share.

use std::sync::Arc;

use serde::Serialize;

use momentous_exercise::calls::{Engine, Refused};
use momentous_fault::Faults;
use momentous_pages::{Beside, Library, Pages, View, Withheld};

use super::companion::Companion;
use super::log::Log;
use super::metrics::Metrics;
use super::settings::Settings;
use super::workers::Workers;

/// The state that all requests share: the pages and the workers that make them.
pub struct App {
    /// How the server is set up.
    pub settings: Settings,
    /// The pages of problems.
    pub pages: Pages,
    /// The workers that do what takes a processor's time.
    pub workers: Workers,
    pub(super) metrics: Metrics,
    pub(super) log: Log,
    /// The pages of courses, where there are any.
    pub(super) companion: Option<Arc<dyn Companion>>,
}

impl App {
    /// Everything that serving takes; templates are tried once before anybody asks for a page.
    ///
    /// # Errors
    /// Where the bank or a template cannot be read.
    pub fn new(settings: Settings) -> Result<Self, Faults> {
        let library = Library::open(settings.watch.as_deref())?;
        Ok(Self {
            pages: Pages::new(library, &settings.base_path, settings.limits, settings.templates.as_deref())?,
            workers: Workers::new(),
            metrics: Metrics::new(),
            log: if settings.log { Log::started() } else { Log::default() },
            companion: None,
            settings,
        })
    }

    /// The number of times that a problem was looked up, in all requests: the measure of the work that a page or a call begins
    /// with.
    #[must_use]
    pub fn looked_up(&self) -> u64 {
        self.pages.library.looked_up()
    }

    /// The engine.
    pub fn engine(&self) -> Engine<'_> {
        self.pages.engine()
    }

    /// The same with pages of courses.
    #[must_use]
    pub fn with_companion(self, companion: Arc<dyn Companion>) -> Self {
        Self { companion: Some(companion), ..self }
    }

    /// The pages of problems as one reader sees them, without what is withheld.
    pub(super) fn view<'a>(&'a self, withheld: &'a dyn Withheld) -> View<'a> {
        View::new(&self.pages, self.beside(), withheld)
    }

    /// A page through the template of that name.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn page(&self, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.pages.fill(&self.beside(), None::<&()>, name, page)
    }

    /// A page of a course.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn page_for(&self, who: &impl Serialize, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.pages.fill(&self.beside(), Some(who), name, page)
    }

    fn beside(&self) -> Beside {
        let hidden_simulators = self.companion.as_ref().map(|companion| companion.hidden_simulators());
        Beside { has_courses: self.companion.is_some(), hidden_simulators: hidden_simulators.unwrap_or_default() }
    }
}

/// The application as requests hold it.
pub type SharedApp = Arc<App>;
