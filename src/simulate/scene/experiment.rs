//! Worlds that simulate a stage, and what is read off them at the end.

use crate::budget::Budget;
use crate::method::Method;
use crate::methods::{EventDriven, RungeKutta};
use crate::refusal::Refusal;
use crate::shown::Shown;
use crate::trajectory::{Ending, Trajectory};
use crate::world::World;

/// The tolerances of the two runs whose difference is the estimate of the error where a motion is integrated.
const TOLERANCES: [f64; 2] = [1e-10, 1e-12];

/// The number of units in the last place of the largest speed that an exact run may lose.
const ROUNDINGS: f64 = 64.0;

/// A quantity after a stage, as the simulation finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// Its name in the problem: `v_A2.x`.
    pub name: String,
    /// Its value in SI units.
    pub value: f64,
    /// A bound on the error of the run; what the inputs' own errors do comes on top.
    pub error: f64,
}

/// Readings off the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reading {
    /// A component of the velocity of a body.
    Velocity {
        /// The body's place in the list.
        body: usize,
        /// Which component.
        component: usize,
        /// -1 where it counts against the axis.
        sign: f64,
    },
    /// A component of the velocity of a body just before the rebound that ends the run.
    Arrival {
        /// The body's place in the list.
        body: usize,
        /// Which component.
        component: usize,
    },
    /// A component of the place of a body.
    Place {
        /// The body's place in the list.
        body: usize,
        /// Which component.
        component: usize,
    },
    /// The time of the last impact, or of coming to rest.
    Time {
        /// The time on the clock when the run starts, in s.
        start: f64,
    },
}

/// A world to run, and the names of what is read off it.
#[derive(Clone, Debug)]
pub struct Experiment<const D: usize> {
    /// The scene as numbers.
    pub world: World<D>,
    /// How long it runs.
    pub budget: Budget,
    /// The quantities that are read off the end, by their names in the problem.
    pub readings: Vec<(String, Reading)>,
}

/// The simulation of one stage.
#[derive(Debug, Default)]
pub struct Staged {
    /// Its parts that move on a line, each along one axis.
    pub on_lines: Vec<Experiment<1>>,
    /// Its parts that move in the plane.
    pub in_planes: Vec<Experiment<2>>,
}

impl Staged {
    pub(super) fn on_line(experiment: Experiment<1>) -> Self {
        Self { on_lines: vec![experiment], in_planes: Vec::new() }
    }

    pub(super) fn in_plane(experiment: Experiment<2>) -> Self {
        Self { on_lines: Vec::new(), in_planes: vec![experiment] }
    }

    /// Runs it by the cheapest method that can: event driven where the motion between impacts is known exactly, else
    /// adaptive Runge-Kutta, whose error is estimated from a second run with a finer step.
    ///
    /// # Errors
    /// No method treats it, by name.
    pub fn run(&self) -> Result<Vec<Reached>, Refusal> {
        let mut all = Vec::new();
        for experiment in &self.on_lines {
            all.extend(experiment.run()?);
        }
        for experiment in &self.in_planes {
            all.extend(experiment.run()?);
        }
        Ok(all)
    }
}

impl<const D: usize> Experiment<D> {
    /// Shows the part of it that is watched, from before an impact to after it.
    ///
    /// # Errors
    /// It has no end that could be found.
    pub fn shown(&self) -> Result<Shown<D>, Refusal> {
        let until_impact = self.readings.iter().any(|(_, reading)| matches!(reading, Reading::Arrival { .. }));
        Shown::of(&self.world, &self.budget, until_impact)
    }

    fn run(&self) -> Result<Vec<Reached>, Refusal> {
        match EventDriven.run(&self.world, &self.budget) {
            Ok(run) => {
                let rounding = ROUNDINGS * f64::EPSILON;
                Ok(self
                    .read(&run)
                    .map(|(name, value, scale)| Reached { name, value, error: rounding * scale })
                    .collect())
            }
            Err(Refusal::NoExactMotion { .. }) => {
                let [coarse, fine] =
                    TOLERANCES.map(|tolerance| RungeKutta { tolerance }.run(&self.world, &self.budget));
                let (coarse, fine) = (coarse?, fine?);
                let both = self.read(&coarse).zip(self.read(&fine));
                let reached = |((_, rough, _), (name, value, scale)): (_, (String, f64, f64))| {
                    let (rough, value): (f64, f64) = (rough, value);
                    Reached { name, value, error: (value - rough).abs() + TOLERANCES[1] * scale }
                };
                Ok(both.map(reached).collect())
            }
            Err(refusal) => Err(refusal),
        }
    }

    /// Names, values, and the sizes with which rounding errors go.
    pub fn read<'a>(&'a self, run: &'a Trajectory<D>) -> impl Iterator<Item = (String, f64, f64)> + 'a {
        let before = self.world.bodies.iter().map(|body| body.velocity.norm());
        let after = run.last.velocities.iter().map(nalgebra::Matrix::norm);
        let walls = self.world.walls.iter().map(|wall| wall.velocity.abs());
        let speeds: f64 = before.chain(after).chain(walls).sum();
        self.readings.iter().filter_map(move |(name, reading)| match *reading {
            Reading::Velocity { body, component, sign } => {
                Some((name.clone(), sign * run.last.velocities.get(body)?[component], speeds))
            }
            Reading::Arrival { body, component } => {
                Some((name.clone(), -run.last.velocities.get(body)?[component], speeds))
            }
            Reading::Place { body, component } => {
                let place = run.last.positions.get(body)?[component];
                Some((name.clone(), place, place.abs() + speeds * run.last.time))
            }
            Reading::Time { start } => {
                let time = match run.ending {
                    Ending::Rest { time, .. } => time,
                    _ => run.impacts.last()?.time,
                };
                Some((name.clone(), start + time, start + time))
            }
        })
    }
}
