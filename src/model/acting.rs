//! Forces that act during a stage, as diagrams show them: one by one, the slopes of floors, streams.

use std::borrow::Cow;

use momentous_expr::Expr;

use super::frame::Direction;
use super::wording;

/// A force that acts on a body during a push.
#[derive(Clone, Debug)]
pub struct ActingForce {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body on which it acts.
    pub on: String,
    /// Its kind.
    pub kind: ForceKind,
    /// Its name: `the thrust`, `weight`.
    pub called: String,
    /// Its strength, a term in the time `t` where it changes.
    pub strength: Expr,
    /// Its direction.
    pub direction: Direction,
    /// From when to when it changes the momentum of the body.
    pub during: [Expr; 2],
}

impl ActingForce {
    /// Its name in a sentence: `the thrust`, `the force of the club`.
    #[must_use]
    pub fn in_words(&self) -> Cow<'_, str> {
        wording::force_of(&self.called)
    }
}

/// The kinds of force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceKind {
    /// A push or a pull that the problem refers to.
    Pull,
    /// Weight.
    Weight,
    /// The push of a floor.
    Normal,
    /// Kinetic friction.
    Friction,
}

/// The slope of the floor in a stage.
#[derive(Clone, Debug)]
pub struct Slope {
    /// The stage, counted from 0.
    pub stage: usize,
    /// Its angle against the level.
    pub angle: Expr,
    /// Whether it rises along the positive axis.
    pub rises: bool,
}

/// A stream that meets a body.
#[derive(Clone, Debug)]
pub struct Flowing {
    /// The stage, counted from 0.
    pub stage: usize,
    /// Its speed.
    pub speed: Expr,
    /// Its direction before the body.
    pub direction: Direction,
    /// Its direction after a vane, seen from there.
    pub leaving: Option<Direction>,
    /// The direction at right angles to the smooth surface that it meets, where that is told.
    pub normal: Option<Direction>,
    /// Its speed relative to the body.
    pub relative: Expr,
    /// Its velocity after the body along each axis, seen from there, as shares of that speed.
    pub after: Vec<Expr>,
    /// The mass that the body has caught of a stream that stays, where that is told.
    pub caught: Option<Expr>,
}
