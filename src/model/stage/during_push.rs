//! Where bodies are while a push acts on one of them, as functions of its time.

use crate::Builder;
use crate::Passage;
use crate::Reason;
use crate::course::Course;
use momentous_expr::Expr;
use momentous_scene::Axis;

use super::push::Pushed;

impl Builder<'_> {
    /// Notes the course of a body with that velocity at each time.
    pub(super) fn notes_course(&mut self, pushed: &Pushed<'_>, velocity: &Expr) {
        let Some(way) = velocity.definite(pushed.clock, &pushed.start, &pushed.clock.into()) else { return };
        let during = [pushed.start.clone(), pushed.end.clone()];
        let (stage, body) = (pushed.index, pushed.body.to_owned());
        self.courses.push(Course { stage, body, during, way: way.simplify() });
    }

    /// How far a body comes in a push whose force changes; none where that is not known.
    pub(super) fn whole_course(&self, index: usize, body: &str) -> Option<Expr> {
        let course = self.courses.iter().find(|course| course.stage == index && course.body == body)?;
        let clock = self.symbols.find("t")?;
        Some(course.way.substitute(&|symbol| (symbol == clock).then(|| course.during[1].clone())))
    }

    /// How far a body has come at each time of a push; one on which the push does not act goes on evenly.
    pub(super) fn way_during(&mut self, body: &str, index: usize, axis: Axis) -> Option<Expr> {
        let [start, _] = self.courses.iter().find(|course| course.stage == index)?.during.clone();
        if let Some(course) = self.courses.iter().find(|course| course.stage == index && course.body == body) {
            return Some(course.way.clone());
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
        let Some(course) = self.courses.iter().find(|course| course.stage == index) else { return };
        let ends = course.during.clone();
        let place = self.running_time();
        self.passages.push(Passage { place, ends, kinetic: something, reason, way: None });
    }
}
