//! Bodies that a stage does not name while it lasts and something acts on them. Weight draws them down, so that they keep their velocity
//! only where they stand still; a pressed spring or a string that an earlier stage left never lets them keep it. Either is looked at where
//! the velocity is used afterwards: a body of which nothing is said any more may move as it likes.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::bond::acting_on_others;
use super::left_alone::Acts;
use super::left_alone::LeftAlone;
use super::stage::Description;

impl Builder<'_> {
    /// Notes which bodies a stage does not name although something acts on them.
    pub(super) fn leaves_others_unheld(&mut self, index: usize, stage: &Stage) {
        // In a flight or a fall of others the clock of a body stands still.
        if !stage.takes_time() || matches!(stage, Stage::Flight(_) | Stage::Fall(_)) {
            return;
        }
        let described = Description::of(self.scene, stage);
        // Parts are named by none of these: they need not be there before.
        let named: Vec<&str> = described.bodies.iter().map(|(body, _)| *body).chain(described.changed()).collect();
        let bound = acting_on_others(self.scene, index, &named).into_iter();
        self.unheld.extend(bound.map(|(body, acts)| LeftAlone {
            stage: index,
            body: body.to_owned(),
            by: Acts::Bond(acts),
        }));
        let others = self.timeline.alive(index + 1).into_iter().filter(|body| !named.contains(body));
        let others: Vec<LeftAlone> =
            others.map(|body| LeftAlone { stage: index, body: body.to_owned(), by: Acts::Weight }).collect();
        self.unheld.extend(others);
    }

    /// Notes that a body, to be used as it was since its last stage, must not have been moved by anything meanwhile.
    pub(super) fn has_not_fallen(&mut self, body: &str, instant: usize) {
        let since = self.timeline.naming_instant(body, instant);
        let between = |left_alone: &mut LeftAlone| {
            left_alone.body == body && since <= left_alone.stage + 1 && left_alone.stage + 2 <= instant
        };
        let unheld: Vec<LeftAlone> = self.unheld.extract_if(.., between).collect();
        for left_alone in unheld {
            match left_alone.by {
                Acts::Weight => self.stands_still_under_weight(body, since, left_alone.stage),
                Acts::Bond(acts) => self.still_acts(body, acts, left_alone.stage),
            }
        }
    }

    /// Requires that a body which nothing holds neither rises nor sinks.
    fn stands_still_under_weight(&mut self, body: &str, since: usize, stage: usize) {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for (position, axis) in axes.into_iter().enumerate() {
            if self.downwards(position).is_none() {
                continue;
            }
            let velocity = self.velocity(body, since, axis);
            for relation in [Relation::AtMost, Relation::AtLeast] {
                let reason = Reason::Unsupported(self.called(body), self.stage_phrase(stage));
                self.require(velocity.clone(), relation, Expr::zero(), reason);
            }
        }
    }

    /// Refuses to use the velocity of a body that a bond changes in a stage without equations for it.
    fn still_acts(&mut self, body: &str, acts: &str, stage: usize) {
        let (body, phrase) = (self.called(body), self.stage_phrase(stage));
        let message = format!("{acts} on {body} in {phrase}, which does not name it, so that its velocity changes");
        let help = "end that before with a stage of its own, or ask for nothing of it afterwards";
        let path = Path::root().key("scene").key("stages").index(stage);
        self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path));
    }
}
