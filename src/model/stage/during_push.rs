//! Where bodies are while a push acts on one of them, as functions of its time.

use crate::Builder;
use crate::Passage;
use crate::Reason;
use crate::displacement::Displacement;
use momentous_expr::Expr;
use momentous_scene::Axis;

use super::push::Pushed;

impl Builder<'_> {
    /// Notes the displacement of a body with that velocity at each time.
    pub(super) fn notes_displacement(&mut self, pushed: &Pushed<'_>, velocity: &Expr) {
        let Some(gone) = velocity.definite(pushed.clock, &pushed.start, &pushed.clock.into()) else { return };
        let during = [pushed.start.clone(), pushed.end.clone()];
        let (stage, body) = (pushed.index, pushed.body.to_owned());
        self.displacements.push(Displacement { stage, body, during, gone: gone.simplify() });
    }

    /// How far a body comes in a push whose force changes; none where that is not known.
    pub(super) fn whole_displacement(&self, index: usize, body: &str) -> Option<Expr> {
        let displacement =
            self.displacements.iter().find(|displacement| displacement.stage == index && displacement.body == body)?;
        let clock = self.symbols.find("t")?;
        Some(displacement.gone.substitute(&|symbol| (symbol == clock).then(|| displacement.during[1].clone())))
    }

    /// How far a body has come at each time of a push; one on which the push does not act goes on evenly.
    pub(super) fn displacement_during(&mut self, body: &str, index: usize, axis: Axis) -> Option<Expr> {
        let [start, _] = self.displacements.iter().find(|displacement| displacement.stage == index)?.during.clone();
        if let Some(displacement) =
            self.displacements.iter().find(|displacement| displacement.stage == index && displacement.body == body)
        {
            return Some(displacement.gone.clone());
        }
        // Two pushes at the same time are told one after the other.
        if self.begins != index + 1 || self.is_changed_in(body, index) {
            return None;
        }
        let clock = self.running_time();
        Some(self.velocity(body, index + 1, axis) * (Expr::from(clock) - start))
    }

    /// Requires that something stays positive all through a push.
    pub(super) fn stays_so(&mut self, index: usize, something: Expr, reason: Reason) {
        let Some(displacement) = self.displacements.iter().find(|displacement| displacement.stage == index) else {
            return;
        };
        let ends = displacement.during.clone();
        let place = self.running_time();
        self.passages.push(Passage { place, ends, kinetic: something, reason, way: None });
    }
}
