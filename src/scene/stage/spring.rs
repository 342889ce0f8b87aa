//! A spring that a body runs into or is pushed away by, or a spring between two bodies.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Until;

/// A light spring acts on a body, or between two bodies that are free to move.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that moves with the end of the spring; the other end is fixed.
    #[serde(default)]
    pub body: Option<String>,
    /// The two bodies between which the spring lies, the second ahead of the first.
    #[serde(default)]
    pub between: Option<[String; 2]>,
    /// The stiffness: force per deformation.
    pub stiffness: Term,
    /// By how much the spring is deformed at the start. Default: not at all.
    #[serde(default)]
    pub from: Option<Term>,
    /// By how much the spring is deformed at the end. Default: not at all, unless `travel` says otherwise.
    #[serde(default)]
    pub to: Option<Term>,
    /// The increase in the deformation of the spring during the stage; instead of `to`. On the way up from where the spring `carried` a
    /// body, how far it moves.
    #[serde(default)]
    pub travel: Option<Term>,
    /// The body (a pan, a platform) that the spring carried at rest before the stage, whose weight deforms it at the start.
    #[serde(default)]
    pub carried: Option<String>,
    /// The coefficient of kinetic friction between the body and the floor. Default: the floor is smooth.
    #[serde(default)]
    pub friction: Option<Term>,
    /// The slope of the floor against the level, as in a slide.
    #[serde(default)]
    pub incline: Option<Term>,
    /// Which way the body moves, along one axis: `downwards`. Default: along the axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// `rest` if the spring is deformed most, and the body is at rest.
    #[serde(default)]
    pub until: Option<Until>,
}

/// On what a spring acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends<'a> {
    /// One body; the other end is fixed.
    Fixed(&'a str),
    /// Two bodies, the second ahead of the first.
    Free(&'a str, &'a str),
}

impl Spring {
    /// On what the spring acts; `None` where the keys contradict each other or are missing.
    #[must_use]
    pub fn ends(&self) -> Option<Ends<'_>> {
        match (&self.body, &self.between) {
            (Some(body), None) => Some(Ends::Fixed(body)),
            (None, Some([first, second])) => Some(Ends::Free(first, second)),
            _ => None,
        }
    }

    /// Whether only values tell if the spring is deformed further or relaxes: it has a deformation at both ends.
    #[must_use]
    pub fn may_relax(&self) -> bool {
        let pressed = self.from.as_ref().is_some_and(|from| !from.0.trim_start().starts_with('-'));
        pressed && self.to.is_some() && !self.releases()
    }

    /// Whether the spring is let go rather than deformed further.
    #[must_use]
    pub fn releases(&self) -> bool {
        self.travel.is_none() && self.to.as_ref().is_none_or(Term::is_written_as_zero)
    }
}
