//! Bodies that a stage does not name while it lasts and weight acts: nothing holds them, so that they keep their velocity only where they
//! stand still. That is required where the velocity is used afterwards; a body of which nothing is said any more may fall as it likes.

use momentous_expr::Expr;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::stage::Description;

impl Builder<'_> {
    /// Notes which bodies a push or a burn does not name.
    pub(super) fn leaves_others_unheld(&mut self, index: usize, stage: &Stage) {
        if !matches!(stage, Stage::Push(_) | Stage::Thrust(_)) {
            return;
        }
        let named: Vec<&str> = Description::of(self.scene, stage).bodies.iter().map(|(body, _)| *body).collect();
        let others = self.timeline.alive(index + 1).into_iter().filter(|body| !named.contains(body));
        let others: Vec<(usize, String)> = others.map(|body| (index, body.to_owned())).collect();
        self.unheld.extend(others);
    }

    /// What is used of a body at an instant has been so since its last stage only if nothing has drawn it down meanwhile.
    pub(super) fn has_not_fallen(&mut self, body: &str, instant: usize) {
        let since = self.timeline.naming_instant(body, instant);
        let between = |(stage, own): &mut (usize, String)| own == body && since <= *stage + 1 && *stage + 2 <= instant;
        let stages: Vec<usize> = self.unheld.extract_if(.., between).map(|(stage, _)| stage).collect();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for stage in stages {
            for (position, axis) in axes.iter().enumerate() {
                if self.downwards(position).is_none() {
                    continue;
                }
                let velocity = self.velocity(body, since, *axis);
                for relation in [Relation::AtMost, Relation::AtLeast] {
                    let reason = Reason::Unsupported(self.called(body), self.stage_phrase(stage));
                    self.require(velocity.clone(), relation, Expr::zero(), reason);
                }
            }
        }
    }
}
