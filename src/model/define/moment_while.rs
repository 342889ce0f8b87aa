//! The moment of all external forces at any time of a stage in which the forces are told and bodies move as these let them.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_laws::angular;
use momentous_scene::Axis;
use momentous_scene::Stage;

use super::super::Builder;
use super::super::Effect;
use super::super::Influence;
use super::super::Moment;
use super::super::Name;
use super::super::QuantityKind;
use super::super::name::MASS_CENTRE;

impl Builder<'_> {
    /// The moments about a point, terms in the time `t`, of forces that act on bodies from outside; none where a force or the place
    /// of a body is not told, or something else bends the paths.
    pub fn moment_while(&mut self, stage: usize, about: &str, outside: &[Influence]) -> Option<Vec<Expr>> {
        let is_free = matches!(self.scene.stages.get(stage)?, Stage::Push(_) | Stage::Flight(_));
        let is_told = |influence: &Influence| {
            let is_force = matches!(influence.moment, Moment::OfForce);
            is_force && (0..self.axes.len()).all(|position| matches!(influence.along(position), Effect::Of(_)))
        };
        let placed = self.placed();
        let bodies: BTreeSet<String> = outside.iter().map(|influence| influence.on.clone()).collect();
        if !is_free
            || self.axes.len() < 2
            || about == MASS_CENTRE
            || !outside.iter().all(is_told)
            || !bodies.iter().all(|body| placed.contains(body))
        {
            return None;
        }
        let clock = self.running_time();
        let start = self.span_of(stage).map_or_else(Expr::zero, |[start, _]| start);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut total: Vec<Expr> = Vec::new();
        for body in bodies {
            let (mass, arm) = (self.mass_at(&body, stage + 1), self.arm(&body, stage + 1, about)?);
            let mut forces = Vec::new();
            let mut way = Vec::new();
            for (position, (axis, arm)) in axes.iter().zip(arm).enumerate() {
                let on_it = outside.iter().filter(|influence| influence.on == body);
                let parts =
                    on_it.filter_map(
                        |influence| if let Effect::Of(part) = influence.along(position) { Some(part) } else { None },
                    );
                let force = Expr::sum(parts.cloned()).simplify();
                let gained = force.definite(clock, &start, &clock.into())?.simplify() / mass.clone();
                let velocity = self.velocity(&body, stage + 1, *axis) + gained;
                way.push(arm + velocity.definite(clock, &start, &clock.into())?);
                forces.push(force);
            }
            let moments = angular::moments(&way, &forces).into_iter();
            total = if total.is_empty() {
                moments.collect()
            } else {
                moments.zip(total).map(|(one, other)| one + other).collect()
            };
        }
        Some(total.into_iter().map(|moment| moment.simplify()).collect())
    }

    /// The bodies whose place is given at some instant.
    pub(crate) fn placed(&self) -> BTreeSet<String> {
        let is_place = |kind: &QuantityKind| matches!(kind, QuantityKind::Position | QuantityKind::Coordinate(_));
        let names = self.given.iter().filter_map(|name| Name::parse(name));
        names.filter(|name| is_place(&name.kind)).map(|name| name.subject).collect()
    }
}
