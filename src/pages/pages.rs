//! The common part of all pages.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

use momentous_exercise::calls::{Engine, Limits, Refused};
use momentous_fault::Faults;
use momentous_render::Figures;
use momentous_render::Renderer;
use momentous_render::Site;

use super::assets::Assets;
use super::library::Library;
use super::words;

/// The common part of all pages: the problems, the templates and the files to which pages refer.
pub struct Pages {
    /// The problems of the bank.
    pub library: Library,
    /// Scripts, styles and fonts.
    pub assets: Assets,
    /// How much a request may take.
    pub limits: Limits,
    /// The beginning of the addresses of the pages, without a slash at its end.
    base: String,
    site: Site,
    renderer: Renderer,
}

/// The pages beside those of problems.
#[derive(Clone, Debug, Default)]
pub struct Beside {
    /// Whether there are pages of courses.
    pub has_courses: bool,
    /// The simulators to which no page leads at the moment, by their names in addresses.
    pub hidden_simulators: Vec<&'static str>,
}

/// The facts that every page knows besides its contents.
#[derive(Serialize)]
struct PageFrame<'a, Who, Page> {
    /// The beginning of the pages' addresses.
    base: &'a str,
    /// The address of scripts, styles and fonts.
    assets: String,
    /// The state of the watched files; nothing where none are watched.
    watch: Option<String>,
    /// Whether there are pages of courses.
    has_courses: bool,
    /// The simulators that the header offers: names in addresses, and titles.
    simulators: Vec<(&'static str, &'static str)>,
    /// The words on buttons and headings, by their names.
    say: BTreeMap<&'static str, &'static str>,
    /// The facts that a page of a course knows besides.
    who: Option<&'a Who>,
    page: &'a Page,
}

/// The simulators: names in addresses, and titles. The call of the same name is never refused; what it must not solve it leaves out.
pub const SIMULATORS: [(&str, &str); 3] =
    [("collision", "Collision"), ("discs", "Collision in the plane"), ("restitution", "Restitution")];

impl Pages {
    /// Everything that pages take; templates are those of a folder, where one is named, and tried before anybody asks for a page.
    ///
    /// # Errors
    /// A template cannot be read.
    pub fn new(library: Library, base: &str, limits: Limits, templates: Option<&Path>) -> Result<Self, Faults> {
        Ok(Self {
            library,
            assets: Assets::new(templates)?,
            limits,
            base: base.to_owned(),
            site: Site::new(templates)?,
            renderer: Renderer::new(templates)?.figures(Figures::Unstyled),
        })
    }

    /// The engine.
    pub fn engine(&self) -> Engine<'_> {
        Engine { problems: &self.library, renderer: &self.renderer, limits: self.limits }
    }

    /// The address below which scripts, styles and fonts are found: it changes with the contents of any of them.
    #[must_use]
    pub fn directory(&self) -> String {
        format!("{}/static/{}", self.base, self.assets.digest)
    }

    /// A page through the template of that name, for a visitor of whom its header tells something.
    ///
    /// # Errors
    /// The template is at fault.
    pub fn fill(
        &self,
        beside: &Beside,
        who: Option<&impl Serialize>,
        name: &str,
        page: &impl Serialize,
    ) -> Result<String, Refused> {
        let is_offered = |(name, _): &(&str, &str)| !beside.hidden_simulators.contains(name);
        let frame = PageFrame {
            base: &self.base,
            assets: self.directory(),
            watch: self.library.stamp().map(|stamp| stamp.to_string()),
            has_courses: beside.has_courses,
            simulators: SIMULATORS.into_iter().filter(is_offered).collect(),
            say: words::ALL.iter().copied().collect(),
            who,
            page,
        };
        self.site.page(name, &frame).map_err(|faults| Refused::fault(&faults))
    }
}
