//! The built-in templates, the user's in their place, and faults in either.

use std::collections::BTreeMap;
use std::path::Path;

use tera::{Delimiters, Error, ErrorKind, Kwargs, State, Tera, Value};

use momentous_explain::capitalised;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_fault::Span;

use super::built_in::{STYLE, built_in_templates};
use super::document::Format;
use super::html;
use super::latex_text;
use super::markdown;
use super::typst_text;

/// The template that a document starts from.
const ROOT: &str = "document.tera";

/// The templates of one folder, compiled, and their sources for faults.
pub(super) struct Templates {
    tera: Tera,
    folder: &'static str,
    sources: BTreeMap<String, Source>,
    /// The style sheet; empty in formats without one.
    pub style: String,
}

impl Templates {
    /// Loads the templates of a format, a user's file instead of the built-in one of the same path.
    pub fn load(format: Format, overrides: Option<&Path>) -> Result<Self, Faults> {
        Self::load_folder(format.name(), format, overrides)
    }

    /// Loads the templates of a folder, which are written in that format.
    pub fn load_folder(folder: &'static str, format: Format, overrides: Option<&Path>) -> Result<Self, Faults> {
        let mut sources = BTreeMap::new();
        for (path, text) in built_in_templates() {
            if path.split('/').next() == Some(folder) {
                sources.insert(path.to_owned(), Source::new(&format!("templates/{path}"), text));
            }
        }
        if let Some(override_folder) = overrides {
            add_overrides(folder, override_folder, &mut sources)?;
        }
        let style = sources.remove(STYLE).map(|source| source.text.to_string()).unwrap_or_default();
        let mut templates = Self { tera: engine(format), folder, sources, style };
        let texts: Vec<(&str, &str)> =
            templates.sources.iter().map(|(name, source)| (name.as_str(), source.text.as_ref())).collect();
        templates.tera.add_raw_templates(texts).map_err(|error| locate(&error, folder, &templates.sources))?;
        Ok(templates)
    }

    /// Renders a document from its values.
    pub fn render(&self, context: &tera::Context) -> Result<String, Faults> {
        self.render_from(ROOT, context)
    }

    /// Renders another template of the folder.
    pub fn render_from(&self, root: &str, context: &tera::Context) -> Result<String, Faults> {
        let root = format!("{}/{root}", self.folder);
        self.tera.render(&root, context).map_err(|error| locate(&error, self.folder, &self.sources))
    }
}

/// A template engine that speaks the format: its escapes, and in LaTeX and Typst signs that these do not use.
fn engine(format: Format) -> Tera {
    let mut tera = Tera::new();
    tera.autoescape_on([".tera"]);
    match format {
        Format::Html => {
            tera.set_escape_fn(|text, out| out.write_all(html::escape(text).as_bytes()));
            // Tera's own filter would take the capitals from the names within.
            tera.register_filter("initial_capital", |text: &str, _: Kwargs, _: &State<'_>| capitalised(text));
            tera.register_filter("said", |text: &str, _: Kwargs, _: &State<'_>| Value::safe_string(&html::said(text)));
        }
        Format::Markdown => tera.set_escape_fn(|text, out| out.write_all(markdown::escape(text).as_bytes())),
        Format::Latex => tera.set_escape_fn(|text, out| out.write_all(latex_text::escape(text).as_bytes())),
        Format::Typst => tera.set_escape_fn(|text, out| out.write_all(typst_text::escape(text).as_bytes())),
    }
    if matches!(format, Format::Latex | Format::Typst) {
        let set = tera.set_delimiters(Delimiters {
            block_start: "<%".into(),
            block_end: "%>".into(),
            variable_start: "<<".into(),
            variable_end: ">>".into(),
            comment_start: "<#".into(),
            comment_end: "#>".into(),
        });
        debug_assert!(set.is_ok(), "the delimiters differ from each other, and no template is loaded yet");
    }
    tera
}

/// Adds a course's own files of that name.
#[cfg(feature = "files")]
fn add_overrides(name: &str, folder: &Path, sources: &mut BTreeMap<String, Source>) -> Result<(), Faults> {
    super::overrides::add(name, folder, sources)
}

/// Without the feature `files` there is nothing to add from.
#[cfg(not(feature = "files"))]
fn add_overrides(_: &str, folder: &Path, _: &mut BTreeMap<String, Source>) -> Result<(), Faults> {
    let fault = Fault::new(Code::Unreadable, "this build of momentous reads no files");
    Err(Faults { source: Source::new(&folder.display().to_string(), ""), list: vec![fault] })
}

/// A fault of tera's as ours, at its file and place.
fn locate(error: &Error, folder: &str, sources: &BTreeMap<String, Source>) -> Faults {
    let placed = match error.kind() {
        ErrorKind::SyntaxError(report) | ErrorKind::RenderingError(report) => {
            let range = &report.span().range;
            vec![Placed {
                file: report.filename().to_owned(),
                message: report.message().to_owned(),
                span: Some(Span { start: range.start, end: range.end }),
            }]
        }
        kind => reports(&kind.to_string(), sources),
    };
    let file = placed.first().map_or_else(String::new, |first| first.file.clone());
    let root = format!("{folder}/{ROOT}");
    let source = sources.get(&file).or_else(|| sources.get(&root)).cloned();
    let list = placed.into_iter().filter(|fault| fault.file == file).map(Placed::into_fault).collect();
    Faults { source: source.unwrap_or_else(|| Source::new(&root, "")), list }
}

/// A message of tera's and where it points.
struct Placed {
    file: String,
    message: String,
    span: Option<Span>,
}

impl Placed {
    fn into_fault(self) -> Fault {
        let message = self.message.trim_end_matches('.').to_owned();
        Fault::new(Code::Template, message).at_maybe(self.span)
    }
}

/// Unknown filters, components and the like, which tera reports all at once but only as text:
/// `error: MESSAGE`, then ` --> FILE:LINE:COLUMN`.
fn reports(text: &str, sources: &BTreeMap<String, Source>) -> Vec<Placed> {
    let mut placed = Vec::new();
    let mut message = None;
    for line in text.lines() {
        if let Some(text) = line.strip_prefix("error: ") {
            message = Some(text.to_owned());
        } else if let Some(place) = line.trim_start().strip_prefix("--> ") {
            let mut fields = place.rsplitn(3, ':');
            let mut number = || fields.next().and_then(|field| field.parse::<usize>().ok()).unwrap_or(1);
            let (column, line) = (number(), number());
            let file = fields.next().unwrap_or_default().to_owned();
            let span = sources.get(&file).map(|source| byte_at(source, line, column));
            placed.extend(message.take().map(|message| Placed { file, message, span }));
        }
    }
    if placed.is_empty() {
        placed.push(Placed { file: String::new(), message: text.to_owned(), span: None });
    }
    placed
}

fn byte_at(source: &Source, line: usize, column: usize) -> Span {
    let before: usize = source.text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let within: usize = source.text[before..].chars().take(column.saturating_sub(1)).map(char::len_utf8).sum();
    let start = before + within;
    let next = source.text[start..].chars().next().map_or(0, char::len_utf8);
    Span { start, end: start + next }
}
