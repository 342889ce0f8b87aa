//! Files that are read, and what an author did wrong in them: what, where (file, line, column), and the way out.

#[cfg(feature = "files")]
mod input;
mod path;
mod source;
mod suggest;

#[cfg(feature = "files")]
pub use input::Input;
pub use path::{Path, Segment};
pub use source::{Source, Span};
pub use suggest::{did_you_mean, unknown_name};

use std::fmt;

/// A stable name for each kind of author fault; it is what tests and tools match on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Code {
    /// The file cannot be read.
    Unreadable,
    /// The text is not YAML, or uses a part of YAML that the language does not allow.
    Syntax,
    /// A key that the language does not have.
    UnknownKey,
    /// A key that must be there is missing.
    MissingKey,
    /// A value of the wrong form.
    Value,
    /// A name that the scene does not make.
    UnknownName,
    /// A unit that is not known.
    UnknownUnit,
    /// Two sides, or a value and its name, of different dimensions.
    Dimension,
    /// A name that is given or defined twice.
    Duplicate,
    /// More equations than unknowns, and they do not agree.
    OverDetermined,
    /// The quantity asked does not follow from those given.
    UnderDetermined,
    /// No tactic closes a block of equations.
    Stuck,
    /// More than one true solution where one is asked.
    Ambiguous,
    /// A text prints what is asked, or does not print what is needed.
    Text,
    /// A range or a step that draws nothing, or cannot be drawn within the bounded number of tries.
    Range,
    /// A template that does not load or render.
    Template,
    /// Something unphysical, which no declaration allows.
    Unphysical,
}

/// One fault of an author, with the place and the way out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Its kind.
    pub code: Code,
    /// The fault, in a sentence without a full stop.
    pub message: String,
    /// The way out.
    pub help: Option<String>,
    /// The place, as bytes of the source. Code that knows only a path leaves this to the loader.
    pub span: Option<Span>,
    /// The place, as the position in the YAML document.
    pub path: Option<Path>,
    /// The place in the text of the scalar at `path`: bytes of that text, for a fault inside an expression.
    pub within: Option<Span>,
}

impl Fault {
    /// A fault of that kind, nowhere in particular yet.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), help: None, span: None, path: None, within: None }
    }

    /// The same fault, at a place.
    #[must_use]
    pub fn at(mut self, span: Span) -> Self {
        self.span = Some(span);
        self
    }

    /// The same fault, at a place where one is known.
    #[must_use]
    pub fn at_maybe(mut self, span: Option<Span>) -> Self {
        self.span = span.or(self.span);
        self
    }

    /// The same fault, at a position in the YAML document.
    #[must_use]
    pub fn at_path(mut self, path: Path) -> Self {
        self.path = Some(path);
        self
    }

    /// The same fault, at these bytes of the text of the scalar at its path.
    #[must_use]
    pub fn within(mut self, span: Span) -> Self {
        self.within = Some(span);
        self
    }

    /// The same fault with a way out.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// Every fault found in one source, never empty; printing it shows each with its excerpt.
#[derive(Clone, Debug)]
pub struct Faults {
    /// The source in which they were found.
    pub source: Source,
    /// The faults in the order of their places.
    pub list: Vec<Fault>,
}

impl fmt::Display for Faults {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, fault) in self.list.iter().take(MOST_PRINTED).enumerate() {
            if index > 0 {
                writeln!(out)?;
            }
            write!(out, "{}", self.source.render(fault))?;
        }
        match self.list.len().checked_sub(MOST_PRINTED) {
            Some(more) if more > 0 => writeln!(out, "\nand {more} more faults"),
            _ => Ok(()),
        }
    }
}

/// The number of faults of one source that are printed: nobody reads more at a time.
const MOST_PRINTED: usize = 50;

impl std::error::Error for Faults {}
