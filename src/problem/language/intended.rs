//! Which of several true solutions an author means.

use schemars::JsonSchema;
use serde::Deserialize;

use momentous_fault::Path;
use momentous_model::Reason;

/// A condition that holds in the intended solution only.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Intended {
    /// The condition: `v_A1 > 0 m/s`.
    Condition(String),
    /// The condition, and what would be so in the other solution.
    Explained(Explained),
}

/// A condition, and why the other solution is none.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Explained {
    /// The condition: `v_A1 > 0 m/s`.
    pub condition: String,
    /// What would be so in the other solution, as a clause: `the bob would move clockwise`.
    pub otherwise: String,
}

impl Intended {
    /// The condition as it is written.
    pub fn text(&self) -> &str {
        match self {
            Self::Condition(condition) => condition,
            Self::Explained(explained) => &explained.condition,
        }
    }

    /// The place of the condition, from that of the whole.
    pub(crate) fn place(&self, path: &Path) -> Path {
        match self {
            Self::Condition(_) => path.clone(),
            Self::Explained(_) => path.key("condition"),
        }
    }

    /// Why the other solution is none.
    pub(crate) fn reason(&self) -> Reason {
        match self {
            Self::Condition(_) => Reason::OtherSolutionAsked,
            Self::Explained(explained) => Reason::Otherwise(explained.otherwise.clone()),
        }
    }
}
