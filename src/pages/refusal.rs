//! The page that says why there is none of the kind that was asked for.

use serde::Serialize;

use momentous_exercise::calls::{Refused, RefusedKind};

use super::again::Again;

/// Why a page was refused, as the template `refused` shows it.
#[derive(Serialize)]
pub struct Refusal<'a> {
    title: &'static str,
    status: u16,
    refused: &'a Refused,
    sentences: Vec<String>,
    /// The form that was refused.
    again: Option<Again>,
}

impl<'a> Refusal<'a> {
    /// With a status of HTTP, a title, and perhaps the form that was refused.
    #[must_use]
    pub fn new((status, title): (u16, &'static str), refused: &'a Refused, again: Option<Again>) -> Self {
        Self { title, status, refused, sentences: refused.sentences(), again }
    }
}

/// An address has no page.
#[must_use]
pub fn no_page() -> Refused {
    Refused::new(RefusedKind::Unknown, "there is no such page").help("the start page lists every problem")
}

/// The status of HTTP and the title for a kind of refusal.
#[must_use]
pub const fn heading(kind: RefusedKind) -> (u16, &'static str) {
    match kind {
        RefusedKind::Unknown => (404, "Not found"),
        RefusedKind::Reserved => (403, "Part of an assignment"),
        RefusedKind::Invalid => (400, "Not understood"),
        RefusedKind::TooLarge => (413, "Too large"),
        RefusedKind::Values => (422, "These values cannot be used"),
        RefusedKind::NotSimulated => (422, "Nothing to simulate"),
        RefusedKind::Fault => (500, "A fault in a file"),
    }
}
