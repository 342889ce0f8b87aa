//! The problems that an assignment of a course can have: those of the bank, and those that the course has published.

use std::sync::Arc;

use serde::Serialize;

use momentous_bank::{Card, Exhibit, Query, load_in_course};

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
pub(super) struct Catalogue {
    offered: Vec<Offered>,
    /// The same with the words by which they are found.
    exhibits: Vec<Exhibit>,
}

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
                let mut exhibits: Vec<Exhibit> = loaded.map(|loaded| Exhibit::of(&loaded)).collect();
                let own_count = exhibits.len();
                let bank: Arc<Vec<Exhibit>> = app.pages.library.exhibits()?;
                let is_own = |id: &str, exhibits: &[Exhibit]| exhibits.iter().any(|mine| mine.card.id == id);
                let rest: Vec<Exhibit> =
                    bank.iter().filter(|exhibit| !is_own(&exhibit.card.id, &exhibits)).cloned().collect();
                exhibits.extend(rest);
                let offer = |(place, exhibit): (usize, &Exhibit)| Offered {
                    card: exhibit.card.clone(),
                    own: place < own_count,
                };
                Ok(Self { offered: exhibits.iter().enumerate().map(offer).collect(), exhibits })
            })
            .await
    }

    /// The problem of that identity.
    pub(super) fn find(&self, id: &str) -> Option<&Offered> {
        self.offered.iter().find(|offered| offered.card.id == id)
    }

    /// Those that a search finds, of that level where one is named.
    pub(super) fn search(&self, text: &str, level: &str) -> Vec<Offered> {
        let query = Query::of(text, &self.exhibits);
        let is_found = |(offered, exhibit): &(&Offered, &Exhibit)| {
            (level.is_empty() || offered.card.level == level) && query.finds(exhibit)
        };
        let matching = self.offered.iter().zip(&self.exhibits).filter(is_found);
        matching.map(|(offered, _)| offered.clone()).collect()
    }
}
