//! Places and velocities of bodies when a stage starts.

use momentous_scene::Axis;

use super::nothing::NothingToSimulate;
use super::particles::Particle;
use super::stage::same_place;
use super::values::Values;
use super::vector::{Vector, ZERO, add, part, times, unit};

impl Values<'_> {
    /// The velocity of a body before the stage.
    pub(super) fn moving(&self, body: &str) -> Result<Vector, NothingToSimulate> {
        let mut velocity = ZERO;
        for axis in self.axes() {
            let component = match self.velocity_before(body, axis) {
                Ok(component) => component,
                Err(missing) => self.held(body, axis).ok_or(missing)?,
            };
            velocity = add(velocity, times(component, unit(axis)));
        }
        Ok(velocity)
    }

    /// A body as it is when the stage starts: its mass, its velocity, and the guide that holds it. Weight is the stage's own.
    pub(super) fn particle<'s>(&self, body: &'s str) -> Result<Particle<'s>, NothingToSimulate> {
        let guide = self.guide(body).transpose()?;
        Ok(Particle { guide, ..Particle::free(body, self.mass(body)?, self.moving(body)?) })
    }

    /// A guided body does not move at right angles to its guide, whether somebody says so or not.
    fn held(&self, body: &str, axis: Axis) -> Option<f64> {
        let along = self.guide(body)?.ok()?;
        (part(along, axis).abs() < f64::EPSILON).then_some(0.0)
    }

    /// The direction in which a guide lets a body move, or something that it consists of.
    pub(super) fn guide(&self, body: &str) -> Option<Result<Vector, NothingToSimulate>> {
        let guided = |body: &&str| self.scene.bodies.get(*body)?.guide.as_ref();
        let guide = self.scene.members(body).iter().find_map(guided)?;
        Some(self.direction(&guide.along.0))
    }

    /// The acceleration of free fall.
    pub(super) fn falling(&self) -> Result<Vector, NothingToSimulate> {
        let mut all = ZERO;
        for axis in self.axes() {
            let component = self.gravity(axis)?;
            all = add(all, times(component, unit(axis)));
        }
        Ok(all)
    }

    /// The place of a body along an axis before the stage.
    pub(super) fn place_before(&self, body: &str, axis: Axis) -> Result<f64, NothingToSimulate> {
        let mut body = body;
        for instant in (1..=self.index + 1).rev() {
            if let Ok(place) = self.named(&self.place_name(body, instant, axis)) {
                return Ok(place);
            }
            // What came between left it where it was.
            let stage = instant.checked_sub(2).and_then(|stage| self.scene.stages.get(stage));
            match stage.and_then(|stage| same_place(stage, body)) {
                Some(before) => body = before,
                None => break,
            }
        }
        Err(NothingToSimulate::ValueMissing)
    }

    /// The name of the place of a body.
    pub(super) fn place_name(&self, body: &str, instant: usize, axis: Axis) -> String {
        format!("r_{body}{instant}{}", self.letter(axis))
    }

    /// The time at which the stage starts, where all that came before is known to have lasted so long.
    pub(super) fn clock_before(&self) -> Option<f64> {
        for instant in (1..=self.index + 1).rev() {
            let name = format!("t_{instant}");
            if instant == 1 {
                return Some((self.value)(&name).unwrap_or(0.0));
            }
            if let Some(time) = (self.value)(&name) {
                return Some(time);
            }
            self.scene.stages.get(instant - 2).filter(|before| !before.takes_time())?;
        }
        None
    }
}
