//! How a stream goes on where it has met a body: turned by a vane, thrown back, or spread over a smooth surface.

use crate::Builder;
use crate::Reason;
use crate::frame::Direction;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::stage::Stream;
use momentous_solve::Relation;

/// How a stream goes on.
pub(super) enum Way<'a> {
    /// A vane turns it.
    Turned(&'a Direction),
    /// It loses its velocity along the normal of a smooth surface, or gets a share of it back.
    Along(&'a Direction, &'a Expr),
    /// The same where it meets the surface squarely.
    Straight(&'a Expr),
}

impl Builder<'_> {
    /// The direction of the stream after the body, and the share of its relative speed with which it comes straight back.
    pub(super) fn stream_leaves(
        &mut self,
        stage: &Stream,
        direction: &Direction,
        path: &Path,
    ) -> (Option<Direction>, Expr) {
        match (&stage.turned, &stage.restitution, stage.stays) {
            (Some(term), None, false) => {
                self.counts_turns("the angle of `turned`", &path.key("turned"));
                let meaning = format!("the angle through which {} is turned", stage.by);
                let turn = self.read(term, Dimension::NONE, &meaning, &path.key("turned"));
                self.needs_unit(&turn, &path.key("turned"));
                let leaving = Direction::turned(direction.quarters, direction.turn.clone() + turn);
                (Some(leaving), Expr::zero())
            }
            (None, Some(term), false) => (None, self.restitution_coefficient(term, &path.key("restitution"))),
            (None, None, _) => (None, Expr::zero()),
            _ => {
                let fault = Fault::new(Code::Value, "a stream is turned, rebounds or stays: only one is possible");
                self.faults.push(fault.help("keep one of `turned`, `restitution` and `stays`").at_path(path.clone()));
                (None, Expr::zero())
            }
        }
    }

    /// The direction at right angles to the surface that a stream meets, where it is told. An oblique stream needs it.
    pub(super) fn surface_in_stream(
        &mut self,
        stage: &Stream,
        direction: &Direction,
        path: &Path,
    ) -> Option<Direction> {
        let name = self.called(&stage.body);
        let passes = stage.turned.is_some() || stage.stays;
        let Some(term) = &stage.normal else {
            if !passes && !direction.turn.is_zero() {
                let message = format!(
                    "{} comes at an angle to the axes, and nothing tells how the surface of {name} lies",
                    stage.by
                );
                let help = "write `normal: upwards`, the direction at right angles to the surface; for a stream that meets it squarely, that of the stream";
                self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path.clone()));
            }
            return None;
        };
        let at = path.key("normal");
        if passes || self.axes.len() < 2 {
            let message =
                "`normal` is that of a surface in a plane from which a stream rebounds, or over which it spreads";
            let help = "use two axes without `turned` and `stays`, or remove `normal`";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(at));
            return None;
        }
        let normal = self.direction(term, &at);
        let across = self.cosine_between(direction, &normal);
        let reason = Reason::NotReached(stage.by.clone(), name);
        self.require(across.powi(2), Relation::Greater, Expr::zero(), reason);
        Some(normal)
    }

    /// The cosine of the angle between two directions.
    fn cosine_between(&self, first: &Direction, second: &Direction) -> Expr {
        let both = self.components(first).into_iter().zip(self.components(second));
        Expr::sum(both.map(|(first, second)| first * second))
    }

    /// The velocities of the stream before and after along every axis, and before less after, as parts of the relative speed.
    pub(super) fn parts(&self, direction: &Direction, way: &Way<'_>) -> Vec<[Expr; 3]> {
        let before = self.components(direction).into_iter();
        match way {
            Way::Turned(leaving) => {
                let both = before.zip(self.components(leaving));
                both.map(|(before, after)| [before.clone(), after.clone(), before - after]).collect()
            }
            Way::Along(normal, back) => {
                let taken = self.cosine_between(direction, normal) * (Expr::one() + (*back).clone());
                let both = before.zip(self.components(normal));
                let parts = both.map(|(before, normal)| (before, normal * taken.clone()));
                parts.map(|(before, change)| [before.clone(), before - change.clone(), change]).collect()
            }
            Way::Straight(back) => {
                let rebounds = |part: Expr| {
                    [part.clone(), -(part.clone() * (*back).clone()), part * (Expr::one() + (*back).clone())]
                };
                before.map(rebounds).collect()
            }
        }
    }
}
