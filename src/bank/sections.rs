//! The sections of the gallery, in the order of a course.

use momentous_exercise::titled;

use super::entry::Card;

/// A section of the gallery.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// Its name in addresses: `restitution`.
    pub name: String,
    /// Its title: `Coefficient of restitution`.
    pub title: String,
    /// Its place; those that a bank makes by topics of its own come last, by their names.
    pub place: usize,
}

/// The sections of the built-in topics, in the order of a course: name, title, topic, and the tag that a problem of that topic has where
/// the section takes some of them only.
const SECTIONS: [(&str, &str, &str, Option<&str>); 13] = [
    ("impulse", "Impulse and momentum", "impulse", None),
    ("vectors", "Impulse as a vector", "vectors", None),
    ("conservation", "Conservation of momentum", "conservation", None),
    ("impact", "Impact", "impact", None),
    ("restitution", "Coefficient of restitution", "impact", Some("restitution")),
    ("bouncing", "Bouncing", "bouncing", None),
    ("chains", "Impact and what comes of it", "chains", None),
    ("concepts", "Reasoning and symbols", "concepts", None),
    ("strings", "Bodies on strings", "strings", None),
    ("mass-centre", "Systems and their mass centre", "mass-centre", None),
    ("angular-momentum", "Angular momentum", "angular-momentum", None),
    ("central-force", "Central forces and orbits", "central-force", None),
    ("streams", "Streams and variable mass", "streams", None),
];

impl Section {
    /// The section of a problem. A topic that is none of the built-in ones is a section of its own.
    ///
    /// ```
    /// use momentous_bank::{Bank, Card, Section, load_in_course};
    /// let loaded = load_in_course(Bank::built_in().find("impact/two-carts")?.clone())?;
    /// assert_eq!(Section::of(&Card::of(&loaded)).title, "Coefficient of restitution");
    /// # Ok::<(), momentous_fault::Faults>(())
    /// ```
    #[must_use]
    pub fn of(card: &Card) -> Self {
        let has = |tag: &str| card.tags.iter().any(|listed| listed == tag);
        let rows = || SECTIONS.iter().enumerate().filter(|(_, (_, _, topic, _))| *topic == card.topic);
        // Of those of a topic the one that takes some of its problems comes before the one that takes the rest.
        let some = rows().find(|(_, (.., tag))| tag.is_some_and(has));
        match some.or_else(|| rows().find(|(_, (.., tag))| tag.is_none())) {
            Some((place, (name, title, ..))) => Self { name: (*name).to_owned(), title: (*title).to_owned(), place },
            None => Self { name: card.topic.clone(), title: titled(&card.topic), place: SECTIONS.len() },
        }
    }
}
