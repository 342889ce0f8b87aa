//! The words of everything that marking says: one catalogue for each language.

mod english;
mod english_input;

pub use english::English;

use std::borrow::Cow;

use super::messages::Message;
use super::read::Unreadable;

/// A language: the words of every message. Another language is another implementation; nothing else holds words.
pub trait Catalogue {
    /// A message, in whole sentences.
    fn message(&self, message: &Message) -> Cow<'static, str>;
    /// Why an answer cannot be read, with its place and the way out.
    fn unreadable(&self, fault: &Unreadable) -> String;
}
