//! What all requests share.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use momentous_exercise::calls::{Engine, Refused};
use momentous_fault::Faults;
use momentous_render::Figures;
use momentous_render::Renderer;
use momentous_render::Site;

use super::assets::Assets;
use super::companion::Companion;
use super::library::Library;
use super::log::Log;
use super::metrics::Metrics;
use super::settings::Settings;
use super::words;
use super::workers::Workers;

/// What all requests share: the problems, the templates, the files of the pages and the workers.
pub struct App {
    /// How the server is set up.
    pub settings: Settings,
    /// The problems of the bank.
    pub library: Library,
    /// The workers that do what takes a processor's time.
    pub workers: Workers,
    pub(super) assets: Assets,
    pub(super) metrics: Metrics,
    pub(super) log: Log,
    /// The pages of courses, where there are any.
    pub(super) companion: Option<Arc<dyn Companion>>,
    site: Site,
    renderer: Renderer,
}

/// What every page knows besides its own.
#[derive(Serialize)]
struct Around<'a, Who, Page> {
    /// Where the pages begin.
    base: &'a str,
    /// Where scripts, styles and fonts are.
    assets: String,
    /// The state of the watched files; nothing where none are watched.
    watch: Option<String>,
    /// Whether there are pages of courses.
    has_courses: bool,
    /// The simulators that the header offers: names in addresses, and titles.
    simulators: Vec<(&'static str, &'static str)>,
    /// What buttons and headings are called, by their names.
    say: BTreeMap<&'static str, &'static str>,
    /// What a page of a course knows besides.
    who: Option<&'a Who>,
    page: &'a Page,
}

/// The simulators: names in addresses, and titles.
const SIMULATORS: [(&str, &str); 2] = [("collision", "Collision"), ("restitution", "Restitution")];

impl App {
    /// Everything that serving takes; templates are tried once before anybody asks for a page.
    ///
    /// # Errors
    /// Where the bank or a template cannot be read.
    pub fn new(settings: Settings) -> Result<Self, Faults> {
        let templates = settings.templates.as_deref();
        Ok(Self {
            library: Library::open(settings.watch.as_deref())?,
            assets: Assets::new(templates)?,
            workers: Workers::new(),
            metrics: Metrics::new(),
            log: if settings.log { Log::started() } else { Log::default() },
            companion: None,
            site: Site::new(templates)?,
            renderer: Renderer::new(templates)?.figures(Figures::Unstyled),
            settings,
        })
    }

    /// How often a problem was looked up, in all requests: the measure of the work that a page or a call begins with.
    #[must_use]
    pub fn looked_up(&self) -> u64 {
        self.library.looked_up()
    }

    /// The engine.
    pub fn engine(&self) -> Engine<'_> {
        Engine { problems: &self.library, renderer: &self.renderer, limits: self.settings.limits }
    }

    /// The same with pages of courses.
    #[must_use]
    pub fn with_companion(self, companion: Arc<dyn Companion>) -> Self {
        Self { companion: Some(companion), ..self }
    }

    /// A page through the template of that name.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn page(&self, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.filled(None::<&()>, name, page)
    }

    /// A page of a course.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn page_for(&self, who: &impl Serialize, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        self.filled(Some(who), name, page)
    }

    fn filled(&self, who: Option<&impl Serialize>, name: &str, page: &impl Serialize) -> Result<String, Refused> {
        let base = self.settings.base_path.as_str();
        let watch = self.settings.watch.is_some().then(|| self.library.stamp().to_string());
        let assets = format!("{base}/static/{}", self.assets.digest);
        let hidden = self.companion.as_ref().map(|companion| companion.hidden_simulators()).unwrap_or_default();
        let simulators = SIMULATORS.into_iter().filter(|(name, _)| !hidden.contains(name)).collect();
        let has_courses = self.companion.is_some();
        let say = words::ALL.iter().copied().collect();
        let around = Around { base, assets, watch, has_courses, simulators, say, who, page };
        self.site.page(name, &around).map_err(|faults| Refused::fault(&faults))
    }
}

/// The application as requests hold it.
pub type SharedApp = Arc<App>;
