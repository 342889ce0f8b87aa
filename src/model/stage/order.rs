//! The order of bodies along a line of impact: the first catches up with the second, which lies ahead.

use crate::Builder;
use crate::Reason;
use crate::frame::Direction;
use crate::guide::dot;
use momentous_expr::Expr;
use momentous_scene::Axis;
use momentous_solve::Relation;

use super::impact::Contact;

impl Builder<'_> {
    /// Along the line of impact, where there is one, the first body catches up with the second.
    pub(super) fn catches_up(&mut self, contact: &Contact<'_>, bodies: [&str; 2]) {
        let Some(frame) = self.line_of_impact(contact) else { return };
        let line = self.components(&frame.normal);
        let [a, b] = bodies.map(|body| dot(&self.velocities(body, contact.index + 1), &line));
        let [one, other] = bodies.map(|body| self.called(body));
        self.require(a, Relation::Greater, b, Reason::NoCatchingUp(one, other));
        self.lies_behind(contact, bodies);
    }

    /// Along the line of impact the first body lies behind the second, where the problem gives the places of both.
    pub(super) fn lies_behind(&mut self, contact: &Contact<'_>, bodies: [&str; 2]) {
        let Some(frame) = self.line_of_impact(contact) else { return };
        self.leads(contact.index, bodies, &frame.normal, [Reason::LiesAhead, Reason::LiesBeside]);
    }

    /// Along a string that is told the second body lies ahead of the first, where the problem gives the places of both.
    pub(super) fn lies_on_the_string(&mut self, index: usize, bodies: [&str; 2], direction: &Direction) {
        self.leads(index, bodies, direction, [Reason::OffTheString, Reason::OffTheString]);
    }

    /// A line that is told leads from one body to another, where the problem gives the places of both: the other lies ahead along it,
    /// and in a plane nearly on it, since what is given is rounded. The reasons say that it is not so.
    fn leads(
        &mut self,
        index: usize,
        bodies: [&str; 2],
        direction: &Direction,
        [behind, beside]: [fn(String, String) -> Reason; 2],
    ) {
        let placed = self.placed();
        if !bodies.iter().all(|body| placed.contains(*body)) {
            return;
        }
        let line = self.components(direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let [from, to] =
            bodies.map(|body| axes.iter().map(|axis| self.place(body, index + 1, *axis)).collect::<Vec<_>>());
        let [one, other] = bodies.map(|body| self.called(body));
        let reason = behind(one.clone(), other.clone());
        self.require(dot(&to, &line), Relation::AtLeast, dot(&from, &line), reason);
        if axes.len() > 1 {
            let apart: Vec<Expr> = to.into_iter().zip(from).map(|(to, from)| to - from).collect();
            let whole = Expr::sum(apart.iter().map(|part| part.clone().powi(2)));
            let share = dot(&apart, &line).powi(2);
            self.require(share, Relation::AtLeast, Expr::ratio(99, 100) * whole, beside(one, other));
        }
    }
}
