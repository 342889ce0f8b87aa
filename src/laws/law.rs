//! A law: what it says, when it applies and where it comes from.

use super::wrong::WrongForm;

/// One law, as a row of its chapter's table.
#[derive(Debug)]
pub struct Law {
    /// A stable name for tools and tests: `conservation-of-momentum`.
    pub id: &'static str,
    /// Its name in a sentence: `conservation of linear momentum`.
    pub name: &'static str,
    /// Its statement, in words.
    pub statement: &'static str,
    /// Which directions count as positive.
    pub signs: &'static str,
    /// When it may be used.
    pub when: &'static str,
    /// Its source: the chapter of mechanics, or the law that it follows from.
    pub source: &'static str,
    /// The forms in which it is usually got wrong.
    pub wrong: &'static [WrongForm],
}

impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Law {}
