//! Items as files of other programs: one file for each target. A target knows no physics, and computes nothing that the item
//! does not hold.

mod feature;
mod field;
mod moodle;

pub use feature::{FEATURES, Feature, Row, TARGETS};
pub use moodle::Moodle;

use std::io;

use crate::fault::Faults;

/// Why an item was not written.
#[derive(Debug, thiserror::Error)]
pub enum NotWritten {
    /// The file takes nothing.
    #[error(transparent)]
    Output(#[from] io::Error),
    /// A text or a template is not fit to print.
    #[error(transparent)]
    Text(#[from] Faults),
}

/// A text without the characters that XML has no way to write.
pub(crate) fn printable(text: &str) -> std::borrow::Cow<'_, str> {
    let has_place = |letter: char| !matches!(letter, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}');
    if text.chars().all(has_place) { text.into() } else { text.chars().filter(|letter| has_place(*letter)).collect() }
}
