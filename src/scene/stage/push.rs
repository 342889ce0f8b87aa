//! Forces of known law that act on bodies for a time.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Force, Strength, Term};

use super::{Gain, Loss, MassChange, Resistance, Until};

/// Forces act on a body, or on several bodies, for a time.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Push {
    /// A name for the stage, used in brackets: `dt[push]`.
    #[serde(default)]
    pub name: Option<String>,
    /// What it is called, without an article: `braking`. Default: `push`, or `motion` where nothing pushes.
    #[serde(default)]
    pub called: Option<String>,
    /// The body, where there is one.
    #[serde(default)]
    pub body: Option<String>,
    /// Several bodies, on which forces act at the same time: `[A, B]`. Each force says on which it acts: `on: A`.
    #[serde(default)]
    pub bodies: Vec<String>,
    /// How long: a duration (`dt`, `4 s`), or the start and the end on the body's own clock (`[0 s, t_2]`). Default: `dt`.
    #[serde(default)]
    pub during: Option<During>,
    /// Over which distance the forces act, along one axis; they must not change with time.
    #[serde(default)]
    pub over: Option<Term>,
    /// Which way the body moves, along one axis, where there is a distance or friction: `downwards`. Default: along the axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// `rest` if the forces act until the body is at rest.
    #[serde(default)]
    pub until: Option<Until>,
    /// The slope of the floor against the level, along one axis: `alpha above +x` where the floor rises towards +x; the angle
    /// alone where the axis points up or down the slope. Directions of forces are counted from the axis along the slope.
    #[serde(default)]
    pub incline: Option<Term>,
    /// What resists the motion all the time, where anything does, beside forces that stay the same: `{ linear: b }` in proportion to the
    /// speed, or along one axis `{ quadratic: k }` in proportion to its square.
    #[serde(default)]
    pub resistance: Option<Resistance>,
    /// What falls onto the body all the time and stays there, along one level axis: `{ name: the sand, flow: q }`.
    #[serde(default)]
    pub gains: Option<Gain>,
    /// What leaves the body all the time with its velocity, along one level axis: `{ name: the sand, flow: q }`.
    #[serde(default)]
    pub loses: Option<Loss>,
    /// The forces. Weight acts by itself in a vertical plane.
    pub forces: Vec<Force>,
    /// `graph` if the sheet's graph tells the force that is given by points: it prints the time and the force of each, and the text
    /// need not. A time or a force is then a value, a name, or a multiple of one.
    #[serde(default)]
    pub told: Option<ToldBy>,
}

/// What tells the numbers of a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ToldBy {
    /// The graph on the sheet.
    Graph,
}

impl Push {
    /// All bodies that it pushes.
    pub fn pushed(&self) -> impl Iterator<Item = &str> {
        self.body.iter().chain(&self.bodies).map(String::as_str)
    }

    /// Whether it pushes several bodies.
    #[must_use]
    pub fn is_of_several(&self) -> bool {
        self.pushed().nth(1).is_some()
    }

    /// The forces on one of its bodies, each with its place in the list.
    pub fn forces_on<'a>(&'a self, body: &'a str) -> impl Iterator<Item = (usize, &'a Force)> {
        self.forces.iter().enumerate().filter(move |(_, force)| force.on().is_none_or(|on| on == body))
    }

    /// Whether some force is a term in the position along the axis of that letter.
    #[must_use]
    pub fn depends_on_place(&self, letter: &str) -> bool {
        self.forces.iter().any(|force| match force {
            Force::Pull(pull) => matches!(&pull.value, Strength::Term(term) if term.mentions(letter)),
            Force::Friction(_) => false,
        })
    }

    /// Whether a resistance acts and no pushes and pulls.
    #[must_use]
    pub fn is_resisted_alone(&self) -> bool {
        self.resistance.is_some() && self.forces.is_empty()
    }

    /// How the mass of the body changes, where it does.
    #[must_use]
    pub fn mass_change(&self) -> Option<MassChange<'_>> {
        let gain = self.gains.as_ref().map(|gain| MassChange {
            gains: true,
            name: &gain.name,
            flow: gain.flow.as_ref(),
            mass: gain.mass.as_ref(),
            velocity: gain.velocity.as_ref(),
        });
        let loss = self.loses.as_ref().map(|loss| MassChange {
            gains: false,
            name: &loss.name,
            flow: loss.flow.as_ref(),
            mass: loss.mass.as_ref(),
            velocity: None,
        });
        gain.or(loss)
    }

    /// The term that says how long it lasts, where one does.
    #[must_use]
    pub fn duration(&self) -> Option<&Term> {
        if let Some(During::For(term)) = &self.during { Some(term) } else { None }
    }

    /// Whether no pushes and pulls act, but the body moves against a resistance or its mass changes.
    #[must_use]
    pub fn is_motion(&self) -> bool {
        self.is_resisted_alone() || self.mass_change().is_some() && self.forces.is_empty()
    }

    /// The names of its pushes and pulls.
    pub fn force_names(&self) -> impl Iterator<Item = &str> {
        self.forces.iter().filter_map(|force| match force {
            Force::Pull(pull) => Some(pull.name.as_deref().unwrap_or("the force")),
            Force::Friction(_) => None,
        })
    }
}

/// How long a stage lasts.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum During {
    /// Start and end.
    Between([Term; 2]),
    /// A duration; the stage's clock starts at zero.
    For(Term),
}
