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
        let placed = self.placed();
        let Some(frame) = self.line_of_impact(contact).filter(|_| bodies.iter().all(|body| placed.contains(*body)))
        else {
            return;
        };
        let line = self.components(&frame.normal);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let [behind, ahead] = bodies.map(|body| {
            let places = axes.iter().map(|axis| self.place(body, contact.index + 1, *axis)).collect::<Vec<_>>();
            dot(&places, &line)
        });
        let [one, other] = bodies.map(|body| self.called(body));
        self.require(ahead, Relation::AtLeast, behind, Reason::LiesAhead(one, other));
        self.lies_along(contact.index, bodies, &frame.normal, Reason::LiesBeside);
    }

    /// A line that is told leads from one body to another, where the problem gives the places of both: nearly so, since these are
    /// rounded.
    pub(super) fn lies_along(
        &mut self,
        index: usize,
        bodies: [&str; 2],
        direction: &Direction,
        otherwise: fn(String, String) -> Reason,
    ) {
        let placed = self.placed();
        if self.axes.len() < 2 || !bodies.iter().all(|body| placed.contains(*body)) {
            return;
        }
        let along = self.components(direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let apart: Vec<Expr> = axes
            .iter()
            .map(|axis| self.place(bodies[1], index + 1, *axis) - self.place(bodies[0], index + 1, *axis))
            .collect();
        let whole = Expr::sum(apart.iter().map(|part| part.clone().powi(2)));
        let share = dot(&apart, &along).powi(2);
        let [one, other] = bodies.map(|body| self.called(body));
        self.require(share, Relation::AtLeast, Expr::ratio(99, 100) * whole, otherwise(one, other));
    }

    /// Along a string that is told the second body lies ahead of the first, where the problem gives the places of both.
    pub(super) fn lies_on_the_string(&mut self, index: usize, bodies: [&str; 2], direction: &Direction) {
        let placed = self.placed();
        if !bodies.iter().all(|body| placed.contains(*body)) {
            return;
        }
        let along = self.components(direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let [behind, ahead] = bodies.map(|body| {
            let places = axes.iter().map(|axis| self.place(body, index + 1, *axis)).collect::<Vec<_>>();
            dot(&places, &along)
        });
        let [one, other] = bodies.map(|body| self.called(body));
        self.require(ahead, Relation::AtLeast, behind, Reason::OffTheString(one, other));
        self.lies_along(index, bodies, direction, Reason::OffTheString);
    }
}
