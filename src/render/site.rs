//! The pages of the web application.

use std::path::Path;

use serde::Serialize;

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Source;

use super::document::Format;
use super::templates::Templates;

/// The templates of the web pages, the user's in place of the built-in ones of the same name.
pub struct Site {
    templates: Templates,
}

impl Site {
    /// The built-in templates, or those of a folder in their place: `web/practice.tera`.
    ///
    /// # Errors
    /// Where the folder cannot be read, or a template is not well formed.
    pub fn new(overrides: Option<&Path>) -> Result<Self, Faults> {
        Ok(Self { templates: Templates::load_folder("web", Format::Html, overrides)? })
    }

    /// The template of the file that holds pages and engine, so that no server is needed; that of a folder in its place.
    ///
    /// # Errors
    /// Where the folder cannot be read, or the template is not well formed.
    pub fn practice_page(overrides: Option<&Path>) -> Result<Self, Faults> {
        Ok(Self { templates: Templates::load_folder("page", Format::Html, overrides)? })
    }

    /// A page: the template of that name with these values. Strings are escaped; a [`super::Fragment`] is written with
    /// `| safe`.
    ///
    /// # Errors
    /// Where the template fails.
    pub fn page(&self, name: &str, values: &impl Serialize) -> Result<String, Faults> {
        let context = tera::Context::from_serialize(values).map_err(|error| Faults {
            source: Source::new(name, ""),
            list: vec![Fault::new(Code::Template, error.to_string())],
        })?;
        self.templates.render_from(&format!("{name}.tera"), &context)
    }
}
