//! The problems that an assignment of a course can have: those of the bank, and those that the course has published.

use std::sync::Arc;

use serde::Serialize;

use momentous_bank::Card;
use momentous_bank::load_in_course;

use super::super::super::library::source;
use super::super::super::outcome::NotShown;
use super::super::super::visit::Visit;

/// A problem that can be chosen.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Offered {
    pub(super) card: Card,
    /// Whether it is one of the course's own.
    pub(super) own: bool,
}

/// The problems that can be chosen, the course's own first.
pub(super) struct Catalogue(Vec<Offered>);

impl Catalogue {
    pub(super) async fn of(visit: &Visit) -> Result<Self, NotShown> {
        let mut files = visit.store().problem_files(visit.course()?.key).await?;
        files.retain(|file| file.published.is_some());
        // Of several versions the last one published counts; they follow each other by identity.
        files.sort_by(|one, other| (&one.problem, other.published).cmp(&(&other.problem, one.published)));
        files.dedup_by(|later, first| later.problem == first.problem);
        visit
            .work(move |app| {
                let loaded = files.iter().filter_map(|file| load_in_course(source(file)).ok());
                let own: Vec<Card> = loaded.map(|loaded| Card::of(&loaded)).collect();
                let bank: Arc<Vec<Card>> = app.library.cards()?;
                let rest = bank.iter().filter(|card| own.iter().all(|mine| mine.id != card.id)).cloned();
                let rest: Vec<Offered> = rest.map(|card| Offered { card, own: false }).collect();
                Ok(Self(own.into_iter().map(|card| Offered { card, own: true }).chain(rest).collect()))
            })
            .await
    }

    /// The problem of that identity.
    pub(super) fn find(&self, id: &str) -> Option<&Offered> {
        self.0.iter().find(|offered| offered.card.id == id)
    }

    /// Those that a search finds.
    pub(super) fn search(&self, text: &str, level: &str) -> Vec<Offered> {
        self.0.iter().filter(|offered| offered.card.is_found(text, level)).cloned().collect()
    }
}
