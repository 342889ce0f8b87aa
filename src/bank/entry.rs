//! Entries of a list of problems.

use serde::Serialize;

use momentous_problem::Level;
use momentous_problem::Loaded;

use super::collection::topic_of;

/// An entry of a list of problems; the keys of `momentous list --format json`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Card {
    /// Its identity: `impact/two-carts`.
    pub id: String,
    /// The topic, before the first slash of the identity: `impact`.
    pub topic: String,
    /// How demanding it is: `intro`, `core` or `challenge`.
    pub level: &'static str,
    /// Its title.
    pub title: String,
    /// The names of its forms; empty where it has one form without a name.
    pub forms: Vec<String>,
    /// Words by which it is found.
    pub tags: Vec<String>,
    /// The path of its file.
    pub file: String,
}

impl Card {
    /// The card of a problem that was loaded.
    #[must_use]
    pub fn of(loaded: &Loaded) -> Self {
        let draft = &loaded.draft;
        Self {
            id: draft.id.clone(),
            topic: topic_of(&draft.id).to_owned(),
            level: match draft.level {
                Level::Intro => "intro",
                Level::Core => "core",
                Level::Challenge => "challenge",
            },
            title: draft.title.clone(),
            forms: draft.forms.names().map(str::to_owned).collect(),
            tags: draft.tags.clone(),
            file: loaded.source.name.to_string(),
        }
    }
}
