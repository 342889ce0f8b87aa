//! An easier problem on the same matter.

use super::entry::Card;

/// The number of words that must agree, at least, between two problems under different topics.
const ALIKE: usize = 2;

/// The levels, the easiest first.
const LEVELS: [&str; 3] = ["intro", "core", "challenge"];

impl Card {
    /// Its place among the levels, the easiest first.
    fn rank(&self) -> usize {
        LEVELS.iter().position(|level| *level == self.level).unwrap_or(LEVELS.len())
    }

    /// The problem, easier than this one, that is nearest to it by its words, before all others one of the same topic; nothing
    /// where none is about the same.
    ///
    /// ```
    /// use momentous_bank::{Bank, Card, load_in_course};
    /// let bank = Bank::built_in();
    /// let cards: Vec<Card> =
    ///     bank.sources().filter_map(|source| load_in_course(source.clone()).ok()).map(|own| Card::of(&own)).collect();
    /// let card = |id: &str| cards.iter().find(|card| card.id == id).unwrap();
    /// let easier = card("impact/hockey-pucks").easier(&cards).unwrap();
    /// assert_eq!((easier.id.as_str(), easier.level), ("impact/squash-wall", "core"));
    /// assert!(card("impact/two-carts").easier(&cards).is_none());
    /// ```
    #[must_use]
    pub fn easier<'a>(&self, cards: impl IntoIterator<Item = &'a Self>) -> Option<&'a Self> {
        let alike = |card: &Self| card.tags.iter().filter(|tag| self.tags.contains(tag)).count();
        let is_near = |card: &&'a Self| card.topic == self.topic && alike(card) > 0 || alike(card) >= ALIKE;
        let easier = cards.into_iter().filter(|card| card.rank() < self.rank()).filter(is_near);
        easier.min_by_key(|card| (card.topic != self.topic, usize::MAX - alike(card), card.rank()))
    }
}
