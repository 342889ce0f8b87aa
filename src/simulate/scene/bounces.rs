//! Bounces on a smooth floor, level or sloping, of a body that was dropped or that arrives somehow.

use crate::budget::Budget;
use crate::method::Method;
use crate::methods::EventDriven;
use crate::state::Vector;
use crate::world::{Body, Wall, World};
use momentous_scene::stage::Bounces;
use momentous_scene::{Axis, Stage};

use super::experiment::{Experiment, Reading, Staged};
use super::nothing::NothingToSimulate;
use super::values::Values;

/// The height from which a ball that bounces is dropped, where no fall before says it.
const DROP: &str = "h_0";

/// A bounce, as it is found by running to it.
pub(super) struct Bounce {
    /// When, in s.
    pub time: f64,
    /// The place along the floor, where the scene has two axes.
    pub along: Option<f64>,
    /// How fast the body leaves the floor.
    pub leaves: f64,
    /// The acceleration towards the floor.
    pub press: f64,
}

/// A body that bounces, along the axes of the scene.
struct Bouncing<const D: usize> {
    world: World<D>,
    /// The axis away from the floor, by its place, and the sense in which it points away.
    up: (usize, f64),
    axes: [Axis; D],
}

impl Values<'_> {
    /// The height from which the body is dropped: of the fall just before, or `h_0`; none where it arrives in another way.
    pub(super) fn drop_before(&self, stage: &Bounces) -> Result<Option<f64>, NothingToSimulate> {
        if self.axes().len() != 1 || stage.incline.is_some() {
            return Ok(None);
        }
        let Some(before) = self.index.checked_sub(1).and_then(|before| self.scene.stages.get(before)) else {
            return self.named(DROP).map(Some);
        };
        let Stage::Fall(fall) = before else { return Ok(None) };
        if fall.body == stage.body { self.term(&fall.height).map(Some) } else { Ok(None) }
    }

    /// The number of the bounce that is counted: `n` where the stage names none.
    pub(super) fn bounces_counted(&self, stage: &Bounces) -> Option<f64> {
        stage.count.as_ref().map_or_else(|| self.named("n"), |term| self.term(term)).ok()
    }

    /// The speed, the time and the place of a bounce, and when and where all end.
    pub(super) fn bounces(&self, stage: &Bounces) -> Result<Staged, NothingToSimulate> {
        let mut staged = Staged::default();
        match self.axes()[..] {
            [only] => staged.on_lines = self.experiments(stage, self.bouncing(stage, [only])?)?,
            [first, second] => staged.in_planes = self.experiments(stage, self.bouncing(stage, [first, second])?)?,
            _ => return Err(NothingToSimulate::Unread),
        }
        Ok(staged)
    }

    /// A bounce by its number.
    pub(super) fn bounce(&self, stage: &Bounces, number: f64) -> Result<Bounce, NothingToSimulate> {
        match self.axes()[..] {
            [only] => self.bouncing(stage, [only])?.bounce(number),
            [first, second] => self.bouncing(stage, [first, second])?.bounce(number),
            _ => Err(NothingToSimulate::Unread),
        }
    }

    fn bouncing<const D: usize>(&self, stage: &Bounces, axes: [Axis; D]) -> Result<Bouncing<D>, NothingToSimulate> {
        let falls = self.falls(stage.incline.as_ref())?;
        // Over a slope weight acts along both axes, of which the second points away from it.
        let up = falls.iter().rposition(|fall| *fall != 0.0).ok_or(NothingToSimulate::NothingChanges)?;
        let sense = -falls[up].signum();
        let (mut gravity, mut normal, mut place, mut velocity) = ([0.0; D], [0.0; D], [0.0; D], [0.0; D]);
        normal[up] = sense;
        for (component, fall) in falls.iter().enumerate().take(D) {
            gravity[component] = *fall;
        }
        match self.drop_before(stage)? {
            Some(height) => place[up] = sense * height,
            None => {
                velocity = self.velocities_before(&stage.body, axes)?;
                for (other, axis) in axes.into_iter().enumerate().filter(|(other, _)| *other != up) {
                    place[other] = self.place_before(&stage.body, axis).unwrap_or(0.0);
                }
            }
        }
        let mut world = World::<D>::new(self.term(&stage.restitution)?);
        world.gravity = Vector::from(gravity);
        world.bodies.push(Body::particle(&stage.body, self.any_mass(&stage.body), place, velocity));
        world.walls.push(Wall::new("the floor", normal, 0.0));
        Ok(Bouncing { world, up: (up, sense), axes })
    }

    fn experiments<const D: usize>(
        &self,
        stage: &Bounces,
        bouncing: Bouncing<D>,
    ) -> Result<Vec<Experiment<D>>, NothingToSimulate> {
        // A drop counts from the release, whatever the clock shows.
        let start = if self.drop_before(stage)?.is_some() { 0.0 } else { self.clock_before().unwrap_or(0.0) };
        let (component, sign) = bouncing.up;
        let time = |which: &str| (format!("t_{which}"), Reading::Time { start });
        let places = |which: &str| {
            let across = bouncing.axes.iter().enumerate().filter(|(other, _)| *other != component);
            let place = |(component, axis): (usize, &Axis)| {
                (format!("{}_{which}", axis.letter()), Reading::Place { body: 0, component })
            };
            across.map(place).collect::<Vec<_>>()
        };
        let mut all = Vec::new();
        if let Some(count) = self.bounces_counted(stage) {
            let mut readings = vec![("v_n".to_owned(), Reading::Velocity { body: 0, component, sign }), time("n")];
            readings.extend(places("n"));
            all.push(Experiment { world: bouncing.world.clone(), budget: until(count), readings });
        }
        if bouncing.world.restitution < 1.0 {
            let mut readings = vec![time("total")];
            readings.extend(places("total"));
            all.push(Experiment { world: bouncing.world, budget: Budget::impacts(usize::MAX), readings });
        }
        Ok(all)
    }
}

/// A run to a bounce by its number.
fn until(number: f64) -> Budget {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of bounces")]
    Budget::impacts(number.round() as usize)
}

impl<const D: usize> Bouncing<D> {
    fn bounce(&self, number: f64) -> Result<Bounce, NothingToSimulate> {
        let run = EventDriven.run(&self.world, &until(number)).map_err(|_| NothingToSimulate::NoMethod)?;
        let (up, sense) = self.up;
        let along = (0..D).find(|other| *other != up).map(|other| run.last.positions[0][other]);
        let leaves = sense * run.last.velocities[0][up];
        Ok(Bounce { time: run.last.time, along, leaves, press: -sense * self.world.gravity[up] })
    }
}
