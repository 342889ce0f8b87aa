//! A rocket and whatever else throws mass away to be driven on.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::Term;

/// A body is driven by mass that it throws away steadily. Several stages of a rocket are several stages of this kind, each with its
/// own masses.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Thrust {
    /// A name for the stage, used in brackets: `dt[first]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// Its whole mass at the start and at the end, fuel included: `[m_0, m_1]`; or the mass at the start alone.
    pub mass: BurningMass,
    /// The speed of what is thrown away, relative to the body; or several jets, each with its `speed` and its `flow`.
    pub exhaust: Exhaust,
    /// The mass thrown away in each unit of time, where times or forces are spoken of.
    #[serde(default)]
    pub flow: Option<Term>,
    /// The thrust, where it is spoken of.
    #[serde(default)]
    pub force: Option<Term>,
    /// How long it burns, where that is spoken of. In a vertical plane weight acts all this time.
    #[serde(default)]
    pub during: Option<Term>,
    /// Where the thrust pushes: `upwards`. Default: along the first axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// Whether it stands on the ground at the start, so that it waits until the thrust exceeds the weight that is left.
    #[serde(default)]
    pub on_ground: bool,
    /// The resistance divided by the square of the speed, where there is any; along a single level axis.
    #[serde(default)]
    pub resistance: Option<Term>,
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

/// What a body throws away.
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
    /// The mass that it carries away in each unit of time.
    pub flow: Term,
}
