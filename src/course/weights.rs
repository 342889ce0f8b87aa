//! How much the parts of an item count beside each other.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use momentous_problem::Part;

/// How much parts count, by their names; one that is not named counts as in the problem's file.
///
/// ```
/// use momentous_course::Weights;
/// let weights: Weights = "v_A2: 2, T_lost: 1".parse()?;
/// assert_eq!(weights.to_string(), "T_lost: 1, v_A2: 2");
/// assert!("v_A2 2".parse::<Weights>().is_err() && "v_A2: 1, v_A2: 2".parse::<Weights>().is_err());
/// # Ok::<(), momentous_course::NoWeights>(())
/// ```
#[derive(Clone, Debug, Default, Deserialize, Eq, Hash, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Weights(BTreeMap<String, u32>);

/// A text that is no list of weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("weights are written `v_A2: 2, T_lost: 1`, as whole numbers and each part once")]
pub struct NoWeights;

impl Weights {
    /// Whether none is named.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The weight of each of these parts.
    #[must_use]
    pub fn over(&self, parts: &[Part]) -> Vec<u32> {
        parts.iter().map(|part| self.0.get(&part.id).copied().unwrap_or(part.points)).collect()
    }

    /// The fault of the weights for these parts; a line `help:` says the way out.
    #[must_use]
    pub fn fault(&self, parts: &[Part]) -> Option<String> {
        let names = || parts.iter().map(|part| part.id.as_str()).collect::<Vec<_>>().join(", ");
        if let Some(name) = self.0.keys().find(|name| parts.iter().all(|part| part.id != **name)) {
            return Some(format!("it does not ask for `{name}`\nhelp: its parts are {}", names()));
        }
        let weighs_nothing = !self.is_empty() && self.over(parts).iter().all(|weight| *weight == 0);
        weighs_nothing.then(|| "all its parts weigh nothing\nhelp: give one of them a weight of at least 1".to_owned())
    }
}

impl FromIterator<(String, u32)> for Weights {
    fn from_iter<I: IntoIterator<Item = (String, u32)>>(named: I) -> Self {
        Self(named.into_iter().collect())
    }
}

impl FromStr for Weights {
    type Err = NoWeights;

    fn from_str(text: &str) -> Result<Self, NoWeights> {
        let mut named = BTreeMap::new();
        for entry in text.split(',').map(str::trim).filter(|entry| !entry.is_empty()) {
            let (name, weight) = entry.split_once(':').ok_or(NoWeights)?;
            let weight = weight.trim().parse().map_err(|_| NoWeights)?;
            if named.insert(name.trim().to_owned(), weight).is_some() {
                return Err(NoWeights);
            }
        }
        Ok(Self(named))
    }
}

impl fmt::Display for Weights {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = self.0.iter().map(|(name, weight)| format!("{name}: {weight}"));
        out.write_str(&named.collect::<Vec<_>>().join(", "))
    }
}
