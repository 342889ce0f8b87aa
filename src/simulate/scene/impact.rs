//! Impacts: bodies that touch, and are run over the one impact.

use crate::budget::Budget;
use crate::world::{Body, Wall, World};
use momentous_scene::Axis;
use momentous_scene::stage::{Impact, Partners};

use super::experiment::{Experiment, Reading, Staged};
use super::nothing::NothingToSimulate;
use super::values::Values;
use super::vector::{Vector, part, unit};

/// How far the centres of bodies that touch are apart, in m; any distance will do.
const APART: f64 = 0.4;

/// The least share of it that is the radius of one of them.
const LEAST: f64 = 0.2;

/// The radii of two bodies that touch, in m; the heavier one is seen to be so.
fn radii(masses: [f64; 2]) -> [f64; 2] {
    let [one, other] = masses.map(libm::cbrt);
    let share = (one / (one + other)).clamp(LEAST, 1.0 - LEAST);
    [share * APART, APART - share * APART]
}

impl Values<'_> {
    pub(super) fn impact(&self, stage: &Impact) -> Result<Staged, NothingToSimulate> {
        match stage.partners() {
            Some(Partners::Bodies(first, second)) => {
                let guided = |body: &str| self.scene.bodies.get(body).is_some_and(|body| body.guide.is_some());
                if guided(first) || guided(second) {
                    return Err(NothingToSimulate::NoMethod);
                }
                if stage.plastic { self.union(stage, [first, second]) } else { self.contact(stage, [first, second]) }
            }
            // What a guide takes up, and what weight gives meanwhile, is in no world.
            Some(Partners::Surface(body, _)) if self.guide(body).is_some() || !stage.include.is_empty() => {
                Err(NothingToSimulate::NoMethod)
            }
            Some(Partners::Surface(body, surface)) => self.at_surface(stage, body, surface),
            None => Err(NothingToSimulate::NoStage),
        }
    }

    pub(super) fn coefficient(&self, stage: &Impact) -> Result<f64, NothingToSimulate> {
        match &stage.restitution {
            Some(term) => self.term(term),
            None if stage.plastic => Ok(0.0),
            None if stage.elastic => Ok(1.0),
            None => Err(NothingToSimulate::NoRestitution),
        }
    }

    /// Bodies that stay together: whatever holds them stops their relative motion along each axis, one after another.
    fn union(&self, stage: &Impact, bodies: [&str; 2]) -> Result<Staged, NothingToSimulate> {
        let masses = [self.mass(bodies[0])?, self.mass(bodies[1])?];
        let radii = radii(masses);
        let mut staged = Staged::default();
        for axis in self.axes() {
            let before = [self.velocity_before(bodies[0], axis)?, self.velocity_before(bodies[1], axis)?];
            // The one that is faster along the axis stands behind.
            let side = if before[0] >= before[1] { -1.0 } else { 1.0 };
            let mut world = World::<1>::new(0.0);
            for (index, side) in [(0, side), (1, -side)] {
                let place = side * radii[index];
                world.bodies.push(Body::sphere(bodies[index], masses[index], radii[index], [place], [before[index]]));
            }
            let after = |index: usize| {
                let body = stage.becomes.as_deref().unwrap_or(bodies[index]);
                (self.velocity_after(body, axis), Reading::Velocity { body: index, component: 0, sign: 1.0 })
            };
            staged.on_lines.push(Experiment { world, budget: Budget::impacts(1), readings: vec![after(0), after(1)] });
        }
        Ok(staged)
    }

    /// Bodies that separate again: the second stands ahead of the first on the line of impact.
    fn contact(&self, stage: &Impact, bodies: [&str; 2]) -> Result<Staged, NothingToSimulate> {
        let axes = self.axes();
        let line = match &stage.line_of_impact {
            Some(term) => self.direction(&term.0)?,
            None => match axes[..] {
                [only] => unit(only),
                _ => return Err(NothingToSimulate::NoLineOfImpact),
            },
        };
        let restitution = self.coefficient(stage)?;
        match axes[..] {
            [only] => Ok(Staged::on_line(self.contact_in([only], restitution, line, bodies)?)),
            [first, second] => Ok(Staged::in_plane(self.contact_in([first, second], restitution, line, bodies)?)),
            _ => Err(NothingToSimulate::Unread),
        }
    }

    fn contact_in<const D: usize>(
        &self,
        axes: [Axis; D],
        restitution: f64,
        line: Vector,
        bodies: [&str; 2],
    ) -> Result<Experiment<D>, NothingToSimulate> {
        let mut world = World::new(restitution);
        let masses = [self.mass(bodies[0])?, self.mass(bodies[1])?];
        for (index, (radius, sign)) in radii(masses).into_iter().zip([-1.0, 1.0]).enumerate() {
            let place = axes.map(|axis| sign * radius * part(line, axis));
            let velocity = self.velocities_before(bodies[index], axes)?;
            world.bodies.push(Body::sphere(bodies[index], masses[index], radius, place, velocity));
        }
        Ok(self.one_impact(axes, world))
    }

    /// A body at a surface, whose mass does not matter.
    fn at_surface(&self, stage: &Impact, body: &str, surface: &str) -> Result<Staged, NothingToSimulate> {
        let entry = self.scene.surfaces.get(surface).ok_or(NothingToSimulate::NoStage)?;
        let normal = self.direction(&entry.normal.0)?;
        let moves = entry.velocity.as_ref().map_or(Ok(0.0), |term| self.term(term))?;
        let restitution = self.coefficient(stage)?;
        match self.axes()[..] {
            [only] => {
                let world = self.surface_in([only], restitution, normal, moves, [body, surface])?;
                Ok(Staged::on_line(self.one_impact([only], world)))
            }
            [first, second] => {
                let world = self.surface_in([first, second], restitution, normal, moves, [body, surface])?;
                Ok(Staged::in_plane(self.one_impact([first, second], world)))
            }
            _ => Err(NothingToSimulate::Unread),
        }
    }

    fn surface_in<const D: usize>(
        &self,
        axes: [Axis; D],
        restitution: f64,
        normal: Vector,
        moves: f64,
        [body, surface]: [&str; 2],
    ) -> Result<World<D>, NothingToSimulate> {
        let mut world = World::new(restitution);
        let velocity = self.velocities_before(body, axes)?;
        world.bodies.push(Body::particle(body, self.any_mass(body), [0.0; D], velocity));
        world.walls.push(Wall::new(surface, axes.map(|axis| part(normal, axis)), 0.0).moving(moves));
        Ok(world)
    }

    /// A run over the one impact of bodies that touch.
    fn one_impact<const D: usize>(&self, axes: [Axis; D], world: World<D>) -> Experiment<D> {
        let readings = world.bodies.iter().enumerate().flat_map(|(body, sphere)| {
            let reading = move |component| Reading::Velocity { body, component, sign: 1.0 };
            axes.into_iter()
                .enumerate()
                .map(move |(component, axis)| (self.velocity_after(&sphere.name, axis), reading(component)))
        });
        let readings = readings.collect();
        Experiment { world, budget: Budget::impacts(1), readings }
    }
}
