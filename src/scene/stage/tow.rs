//! Two bodies in a row that move together while forces act.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Until;

/// Two bodies in a row move together along the one axis of a scene: a lorry and its trailer, an engine and its train, two crates that
/// touch. Forces may act on each of them.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tow {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that goes ahead.
    pub front: Towed,
    /// The body behind it.
    pub rear: Towed,
    /// What joins them, as it is called in a sentence. It pulls or pushes, unless it is called a rope or the like. Default: the coupling.
    #[serde(default)]
    pub by: Option<String>,
    /// The string that joins them, as it is called in a sentence: `the rope`. It can only pull.
    #[serde(default)]
    pub string: Option<String>,
    /// The angle of the slope on which both are. Default: the path is level, or vertical where the axis is.
    #[serde(default)]
    pub incline: Option<Term>,
    /// How long. Default: `dt`.
    #[serde(default)]
    pub duration: Option<Term>,
    /// How far they move.
    #[serde(default)]
    pub distance: Option<Term>,
    /// `rest` if they move until they are at rest.
    #[serde(default)]
    pub until: Option<Until>,
}

/// One of two bodies in a row.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Towed {
    /// The body.
    pub body: String,
    /// A steady force on it along the axis: that of an engine is positive, that of a brake negative (`-B`). Default: none.
    #[serde(default)]
    pub force: Option<Term>,
    /// The coefficient of kinetic friction on its floor, or of its resistance to rolling. Default: smooth.
    #[serde(default)]
    pub friction: Option<Term>,
}

/// Words for what cannot push; the name of a coupling that ends in one of them says so.
const STRINGS: [&str; 7] = ["string", "rope", "cord", "cable", "chain", "thread", "wire"];

impl Tow {
    /// Whether what joins the bodies can only pull.
    #[must_use]
    pub fn pulls_only(&self) -> bool {
        let last = self.by.as_deref().and_then(|name| name.split_whitespace().last());
        self.string.is_some() || last.is_some_and(|word| STRINGS.contains(&word))
    }

    /// Both of them, the one in front first.
    #[must_use]
    pub fn both(&self) -> [&Towed; 2] {
        [&self.front, &self.rear]
    }

    /// What joins them, as it is called in a sentence.
    #[must_use]
    pub fn joint(&self) -> &str {
        self.string.as_ref().or(self.by.as_ref()).map_or("the coupling", String::as_str)
    }
}
