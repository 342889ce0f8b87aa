//! A rocket and whatever else throws mass away to be driven on.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A body is driven by mass that it expels steadily. Several stages of a rocket are several stages of this kind, each with its
/// own masses.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Thrust {
    /// A name for the stage, used in brackets: `dt[first]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// Its whole mass at the start and at the end, fuel included: `[m_0, m_1]`; or the mass at the start alone. Default: the mass of
    /// the body at the start, which a thrust alone does not need.
    #[serde(default = "untold")]
    pub mass: BurningMass,
    /// The speed of the exhaust, relative to the body; or several jets, each with its `speed` and its `flow`.
    pub exhaust: Exhaust,
    /// The mass expelled per unit time, if times or forces are wanted.
    #[serde(default)]
    pub flow: Option<Term>,
    /// The thrust, if it is given or wanted.
    #[serde(default)]
    pub force: Option<Term>,
    /// How long it burns, if that is given or wanted. In a vertical plane weight acts all this time.
    #[serde(default)]
    pub during: Option<Term>,
    /// The direction of the thrust: `upwards`. Default: along the first axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// Whether it stands on the ground at the start, so that it lifts off only when the thrust exceeds its remaining weight.
    #[serde(default)]
    pub on_ground: bool,
    /// The resistance divided by the square of the speed, where there is any; along a single level axis.
    #[serde(default)]
    pub resistance: Option<Term>,
}

impl Thrust {
    /// Whether nothing but thrust and weight acts all the time.
    #[must_use]
    pub fn is_free(&self) -> bool {
        !self.on_ground && self.resistance.is_none()
    }
}

/// A mass that is not told yet: that of the body.
fn untold() -> BurningMass {
    BurningMass::Start(Term(String::new()))
}

/// The mass of a body that burns fuel.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum BurningMass {
    /// At the start and at the end.
    Both([Term; 2]),
    /// At the start; at the end it follows from flow and time.
    Start(Term),
}

impl BurningMass {
    /// The mass at the start.
    #[must_use]
    pub fn at_start(&self) -> &Term {
        match self {
            Self::Both([start, _]) | Self::Start(start) => start,
        }
    }

    /// Makes the mass at the start that of the body where none is told.
    pub fn tell(&mut self, of_body: impl FnOnce() -> Term) {
        if let Self::Start(start) = self
            && start.0.is_empty()
        {
            *start = of_body();
        }
    }

    /// The mass at the end, where it is told.
    #[must_use]
    pub fn at_end(&self) -> Option<&Term> {
        match self {
            Self::Both([_, end]) => Some(end),
            Self::Start(_) => None,
        }
    }
}

/// What a body expels.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Exhaust {
    /// Several jets in the same direction.
    Jets(Vec<Jet>),
    /// One jet: its speed relative to the body.
    Speed(Term),
}

/// One of several jets.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Jet {
    /// Its speed relative to the body.
    pub speed: Term,
    /// The mass that it carries away per unit time.
    pub flow: Term,
}
