//! Forces that act during a stage.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Components, Term};

/// A force on a body during a stage.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Force {
    /// Dry friction of the floor: `{ friction: { kinetic: mu_k } }`.
    Friction(FrictionEntry),
    /// A push or a pull of known or sought strength.
    Pull(Pull),
}

impl Force {
    /// The body on which it acts, where it says so.
    #[must_use]
    pub fn on(&self) -> Option<&str> {
        match self {
            Self::Friction(_) => None,
            Self::Pull(pull) => pull.on.as_deref(),
        }
    }
}

/// The entry of a friction force.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrictionEntry {
    /// The coefficients of friction: `{ kinetic: mu_k }`, with `static` beside it for a body that may be at rest first.
    pub friction: Friction,
}

/// Coefficients of dry friction.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Friction {
    /// The static coefficient, which decides whether and when a body at rest starts to move. Default: the body slides all the time.
    #[serde(default, rename = "static")]
    pub at_rest: Option<Term>,
    /// The kinetic coefficient.
    pub kinetic: Term,
}

/// A push or a pull.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pull {
    /// How the force is called in a sentence: `the thrust`. Default: "the force".
    #[serde(default)]
    pub name: Option<String>,
    /// The body on which it acts, where several are pushed.
    #[serde(default)]
    pub on: Option<String>,
    /// Its strength: a term (which may contain the time `t`, from the start of the stage), pieces, points of a graph, or its
    /// components along the axes, which say where it points.
    pub value: Strength,
    /// Where it points: `to the left`, `30 deg above +x`. Default: along the first axis.
    #[serde(default)]
    pub direction: Option<Term>,
}

/// The strength of a force.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Strength {
    /// One term.
    Term(Term),
    /// Pieces in order of time.
    Pieces(Vec<Piece>),
    /// Straight lines between the points of a graph.
    Graph(Graph),
    /// Components along the axes, each a term in the time `t`: `{ x: 3 N, y: k*t }`. Those left out are zero.
    Components(Components),
}

/// Points of a force-time graph.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Graph {
    /// Pairs of time and force: `[[0 s, 0 N], [2 ms, 600 N], [5 ms, 0 N]]`.
    pub points: Vec<[Term; 2]>,
}

/// One piece of a force that changes its law.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Piece {
    /// The time until which the piece holds; the last piece may leave it out.
    #[serde(default)]
    pub until: Option<Term>,
    /// The strength, in the time `t`.
    pub is: Term,
}
