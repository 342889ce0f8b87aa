//! The forces of a push one by one, for diagrams; the equations need only their sums.

use std::borrow::Cow;

use crate::expr::Expr;

use super::Builder;
use super::Direction;
use super::incline::Incline;
use super::wording;

/// A force that acts on a body during a push.
#[derive(Clone, Debug)]
pub struct ActingForce {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body on which it acts.
    pub on: String,
    /// What it is.
    pub kind: ForceKind,
    /// What it is called: `the thrust`, `weight`.
    pub called: String,
    /// Its strength, a term in the time `t` where it changes.
    pub strength: Expr,
    /// Where it points.
    pub direction: Direction,
    /// From when to when it changes the momentum of the body.
    pub during: [Expr; 2],
}

impl ActingForce {
    /// What it is called in a sentence: `the thrust`, `the force of the club`.
    #[must_use]
    pub fn in_words(&self) -> Cow<'_, str> {
        wording::force_of(&self.called)
    }
}

/// What a force is.
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
    /// Where it goes before the body.
    pub direction: Direction,
    /// Where it goes after a vane, seen from there.
    pub leaving: Option<Direction>,
    /// Its speed relative to the body.
    pub relative: Expr,
}

/// Where and when the forces of one push act.
#[derive(Clone, Copy)]
pub(super) struct Acts<'a> {
    pub stage: usize,
    pub on: &'a str,
    pub during: [&'a Expr; 2],
}

impl Acts<'_> {
    pub(super) fn force(self, kind: ForceKind, called: &str, strength: Expr, direction: Direction) -> ActingForce {
        let (on, during) = (self.on.to_owned(), self.during.map(Clone::clone));
        ActingForce { stage: self.stage, on, kind, called: called.to_owned(), strength, direction, during }
    }
}

impl Builder<'_> {
    /// The components of a force when it begins to act, or at its end.
    pub(super) fn components_at(&self, force: &ActingForce, at_end: bool) -> Vec<Expr> {
        let clock = self.symbols.find("t");
        let time = &force.during[usize::from(at_end)];
        let strength = force.strength.substitute(&|symbol| (Some(symbol) == clock).then(|| time.clone()));
        let parts = self.components(&force.direction).into_iter();
        parts.map(|part| if part.is_zero() { part } else { strength.clone() * part }.simplify()).collect()
    }

    /// Notes a push or a pull.
    pub(super) fn note_pull(&mut self, acts: Acts<'_>, called: &str, strength: &Expr, direction: &Direction) {
        self.forces.push(acts.force(ForceKind::Pull, called, strength.clone(), direction.clone()));
    }

    /// Notes the weight of a body, where it acts in the plane of the scene.
    pub(super) fn note_weight(&mut self, acts: Acts<'_>) {
        let Some((position, down)) = (0..self.axes.len()).find_map(|place| Some((place, self.downwards(place)?)))
        else {
            return;
        };
        let strength = self.mass(acts.on) * self.gravity();
        let direction = Direction::axis(self.axis_place(position), down < 0);
        self.forces.push(acts.force(ForceKind::Weight, "weight", strength, direction));
    }

    /// Notes what a floor has to do with a body that slides on it along the axis, or `backwards`.
    pub(super) fn note_floor(
        &mut self,
        acts: Acts<'_>,
        incline: &Incline,
        weight: Expr,
        normal: Expr,
        kinetic: Expr,
        backwards: bool,
    ) {
        let friction = kinetic * normal.clone();
        self.forces.push(acts.force(ForceKind::Weight, "weight", weight, incline.downwards()));
        self.forces.push(acts.force(ForceKind::Normal, "the normal force", normal, Direction::axis(1, false)));
        if !friction.is_zero() {
            let against = Direction::axis(0, !backwards);
            self.forces.push(acts.force(ForceKind::Friction, "friction", friction, against));
        }
    }
}
