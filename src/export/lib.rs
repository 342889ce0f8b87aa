//! Items as files of other programs: a folder for each target. A target knows no physics, and computes nothing that the item
//! does not hold.

mod band;
mod canvas;
mod coded;
mod element;
mod feature;
mod features;
mod field;
mod moodle;
mod numbas;
mod package;
mod practice_page;
mod prairielearn;
mod qti;
mod question;
mod responses;
mod rexams;
mod target;

pub use coded::{Coded, CodedPart};
pub use feature::{Feature, Place};
pub use features::{FEATURES, Row};
pub use practice_page::{ENGINE_FILE, PAGE_FILE, PageProblem, PracticePage, Reported};
pub use question::Question;
pub use responses::{Response, Responses};
pub use target::{TARGETS, Target};

use std::io;

use momentous_fault::Faults;

/// A file on its way. Questions are written as they come; those of one form come one after the other.
pub trait Export {
    /// Writes a question that has something to ask.
    ///
    /// # Errors
    /// Where a text is not fit to print, or the file takes nothing.
    fn write(&mut self, question: &Question<'_>) -> Result<(), NotWritten>;

    /// Ends the file.
    ///
    /// # Errors
    /// Where the file takes nothing.
    fn finish(self: Box<Self>) -> Result<(), NotWritten>;
}

/// The export that a target begins, and that takes the questions.
type Begun<'w> = Result<Box<dyn Export + 'w>, NotWritten>;

/// Why an item was not written.
#[derive(Debug, thiserror::Error)]
pub enum NotWritten {
    /// The file takes nothing.
    #[error(transparent)]
    Output(#[from] io::Error),
    /// A text is not fit to print.
    #[error(transparent)]
    Text(#[from] Faults),
    /// A package takes no such file.
    #[error("the package cannot be written: {0}")]
    Package(#[from] zip::result::ZipError),
}

/// A text without the characters that XML has no way to write.
#[must_use]
pub fn printable(text: &str) -> std::borrow::Cow<'_, str> {
    let has_place = |letter: char| !matches!(letter, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}');
    if text.chars().all(has_place) { text.into() } else { text.chars().filter(|letter| has_place(*letter)).collect() }
}
