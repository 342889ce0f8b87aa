//! Instants by the author's names and words.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

/// An instant: its name, or its name with the words that say when it is.
///
/// ```
/// use momentous_scene::Instant;
///
/// let top = Instant::Words([("top".to_owned(), "at the top".to_owned())].into());
/// assert_eq!((top.name(), top.words()), ("top", Some("at the top")));
/// assert_eq!(Instant::Name("top".to_owned()).words(), None);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a name, or a name with words that say when it is, `{ top: at the top }`")]
pub enum Instant {
    /// Used after `@`: `[before, after]` lets `v_A@after` be written.
    Name(String),
    /// With words for questions, solutions and figures: `{ top: at the top of the swing }`.
    #[schemars(extend("minProperties" = 1, "maxProperties" = 1))]
    Words(BTreeMap<String, String>),
}

impl Instant {
    /// The name; empty where there is none.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Name(name) => name,
            Self::Words(named) => named.keys().next().map_or("", String::as_str),
        }
    }

    /// Whether it has one name, and no words that are empty.
    #[must_use]
    pub fn is_one(&self) -> bool {
        match self {
            Self::Name(name) => !name.is_empty(),
            Self::Words(named) => {
                named.len() == 1 && named.iter().all(|(name, words)| !name.is_empty() && !words.is_empty())
            }
        }
    }

    /// When it is, as an adverbial phrase.
    #[must_use]
    pub fn words(&self) -> Option<&str> {
        match self {
            Self::Name(_) => None,
            Self::Words(named) => named.values().next().map(String::as_str),
        }
    }
}
