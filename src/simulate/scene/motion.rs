//! Motions between impacts: pushes, falls, flights.

use std::sync::Arc;

use crate::budget::Budget;
use crate::force::{Force, Piece, Strength};
use crate::state::Vector;
use crate::world::{Body, Wall, World};
use momentous_scene::stage::{During, Fall, Flight, Push};
use momentous_scene::{Axis, Force as Acting, Pull, Strength as Told};

use super::experiment::{Experiment, Reading, Staged};
use super::nothing::NothingToSimulate;
use super::values::Values;
use super::vector::part;

impl Values<'_> {
    /// Forces of known law for a known time: each axis for itself.
    pub(super) fn push(&self, stage: &Push) -> Result<Staged, NothingToSimulate> {
        if stage.incline.is_some() || stage.resistance.is_some() || stage.mass_change().is_some() {
            return Err(NothingToSimulate::NoMethod);
        }
        // What a guide takes up is no force of known law.
        if stage.pushed().any(|body| self.guide(body).is_some()) {
            return Err(NothingToSimulate::NoMethod);
        }
        let [start, end] = match &stage.during {
            Some(During::For(term)) => [0.0, self.term(term)?],
            Some(During::Between([from, to])) => [self.term(from)?, self.term(to)?],
            None => [0.0, self.duration()?],
        };
        let mut staged = Staged::default();
        for axis in self.axes() {
            for body in stage.pushed() {
                let mut world = self.alone(body, self.mass(body)?, axis)?;
                for (_, force) in stage.forces_on(body) {
                    let Acting::Pull(pull) = force else { return Err(NothingToSimulate::NoMethod) };
                    self.pull(&mut world, pull, axis, start)?;
                }
                staged.on_lines.push(self.until(world, body, axis, end - start));
            }
        }
        Ok(staged)
    }

    /// A force along one axis, on the clock of a stage that starts at `start`.
    fn pull(&self, world: &mut World<1>, pull: &Pull, axis: Axis, start: f64) -> Result<(), NothingToSimulate> {
        let (along, told) = match (&pull.value, &pull.direction) {
            (Told::Components(parts), _) => match parts.get(axis) {
                Some(term) => (1.0, &Told::Term(term.clone())),
                None => return Ok(()),
            },
            (told, Some(term)) => (part(self.direction(&term.0)?, axis), told),
            (told, None) => (f64::from(u8::from(self.axes().first() == Some(&axis))), told),
        };
        let direction = Vector::from([along]);
        if let Some(pieces) = self.polynomials(told, start) {
            world.forces.push(Force::Varying { body: 0, direction, strength: Strength::Pieces(pieces) });
            return Ok(());
        }
        let (strength, changes) = self.strength(told)?;
        let strength = Strength::Function(Arc::new(move |time| strength.at(time + start)));
        world.forces.push(Force::Varying { body: 0, direction, strength });
        // A force of no strength that changes its law at the same times, so that no step goes across one.
        let pieces = changes.into_iter().map(|until| Piece { until: until - start, coefficients: vec![0.0] }).collect();
        world.forces.push(Force::Varying { body: 0, direction, strength: Strength::Pieces(pieces) });
        Ok(())
    }

    /// One body along one axis, under its weight where that acts along it.
    fn alone(&self, body: &str, mass: f64, axis: Axis) -> Result<World<1>, NothingToSimulate> {
        let mut world = World::new(1.0);
        world.gravity = Vector::from([self.gravity(axis)?]);
        world.bodies.push(Body::particle(body, mass, [0.0], [self.velocity_before(body, axis)?]));
        Ok(world)
    }

    /// The one body of a world until a time.
    fn until(&self, world: World<1>, body: &str, axis: Axis, time: f64) -> Experiment<1> {
        let reading = Reading::Velocity { body: 0, component: 0, sign: 1.0 };
        Experiment { world, budget: Budget::until(time), readings: vec![(self.velocity_after(body, axis), reading)] }
    }

    /// Free flight for a known time.
    pub(super) fn flight(&self, stage: &Flight) -> Result<Staged, NothingToSimulate> {
        if !stage.is_free() {
            return Err(NothingToSimulate::NoMethod);
        }
        let time = stage.during.as_ref().map_or_else(|| self.duration(), |term| self.term(term))?;
        let falls = self.falls(stage.incline.as_ref())?;
        let mut staged = Staged::default();
        for body in stage.flying() {
            for (axis, fall) in self.axes().into_iter().zip(&falls) {
                let mut world = self.alone(body, self.any_mass(body), axis)?;
                world.gravity = Vector::from([*fall]);
                staged.on_lines.push(self.until(world, body, axis, time));
            }
        }
        Ok(staged)
    }

    /// A fall onto a floor that lies so far below, with the velocity just before the rebound that would follow.
    pub(super) fn fall(&self, stage: &Fall) -> Result<Staged, NothingToSimulate> {
        let height = self.term(&stage.height)?;
        let mut staged = Staged::default();
        for axis in self.axes() {
            let mut world = self.alone(&stage.body, self.any_mass(&stage.body), axis)?;
            let down = self.sinking(&stage.body, axis)?;
            world.gravity = Vector::from([down]);
            if down == 0.0 {
                continue;
            }
            world.walls.push(Wall::new("the end of the fall", [-down.signum()], -height));
            let reading = Reading::Arrival { body: 0, component: 0 };
            let readings = vec![(self.velocity_after(&stage.body, axis), reading)];
            staged.on_lines.push(Experiment { world, budget: Budget::impacts(1), readings });
        }
        Ok(staged)
    }
}
