//! The result of a run: how every body moved between impacts, the impacts, and how the run ended.

use super::budget::{Budget, Keep};
use super::contact::Contact;
use super::exact::Orbit;
use super::state::{State, Vector};

/// The result of a run.
#[derive(Clone, Debug)]
pub struct Trajectory<const D: usize> {
    /// The pieces of each body's path, in order of time; empty where the budget did not ask for them.
    pub paths: Vec<Vec<Segment<D>>>,
    /// The states at the ends of the steps of a method that has steps; empty where the budget did not ask for them.
    pub states: Vec<State<D>>,
    /// The impacts in order of time; empty where the budget did not ask for them.
    pub impacts: Vec<Impact<D>>,
    /// How many impacts there were.
    pub impact_count: usize,
    /// How many steps (events, where a method has no steps) the run took.
    pub steps: usize,
    /// The number of times that forces, or the next event of a contact, were worked out: what a run takes on any machine.
    pub evaluations: usize,
    /// The state at the end.
    pub last: State<D>,
    /// Its end.
    pub ending: Ending,
}

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// At the time that was asked for.
    Time,
    /// With the number of impacts that was asked for.
    Impacts,
    /// Nothing will ever touch again, and no force acts on anything that could be asked for later.
    NoMoreImpacts,
    /// Infinitely many bounces end at this time, after which the body rests on the wall.
    Rest {
        /// The body and the wall.
        contact: Contact,
        /// The time, in s.
        time: f64,
    },
    /// The budget of steps is spent; the last state is what was reached.
    Exhausted,
}

/// A piece of a body's path.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment<const D: usize> {
    /// When it begins, in s.
    pub start: f64,
    /// When it ends, in s.
    pub end: f64,
    /// How the body moves on it.
    pub motion: Motion<D>,
}

/// A motion without impact, in the time since it began.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion<const D: usize> {
    /// Constant acceleration.
    Uniform {
        /// The position at the start.
        position: Vector<D>,
        /// The velocity at the start.
        velocity: Vector<D>,
        /// The acceleration.
        acceleration: Vector<D>,
    },
    /// A polynomial: the coefficients of 1, t, t², ...
    Polynomial(Vec<Vector<D>>),
    /// An orbit about a fixed centre.
    Orbit(Orbit<D>),
}

impl<const D: usize> Motion<D> {
    /// Position and velocity after a time.
    #[must_use]
    pub fn at(&self, elapsed: f64) -> (Vector<D>, Vector<D>) {
        match self {
            Self::Uniform { position, velocity, acceleration } => {
                (position + (velocity + acceleration * (elapsed / 2.0)) * elapsed, velocity + acceleration * elapsed)
            }
            Self::Polynomial(coefficients) => {
                let mut position = Vector::zeros();
                let mut velocity = Vector::zeros();
                for coefficient in coefficients.iter().rev() {
                    velocity = velocity * elapsed + position;
                    position = position * elapsed + coefficient;
                }
                (position, velocity)
            }
            Self::Orbit(orbit) => orbit.at(elapsed),
        }
    }
}

/// An impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact<const D: usize> {
    /// When, in s.
    pub time: f64,
    /// The contact.
    pub contact: Contact,
    /// The impulse on the second party of the contact, in N s; the first has the opposite one.
    pub impulse: Vector<D>,
    /// The kinetic energy of the bodies at the contact just before, in J.
    pub energy_before: f64,
    /// The kinetic energy that was lost, in J; from a form that does not subtract the energies. A moving wall can give energy, which makes it negative.
    pub energy_lost: f64,
}

impl<const D: usize> Impact<D> {
    /// The kinetic energy of the bodies at the contact just after, in J.
    #[must_use]
    pub fn energy_after(&self) -> f64 {
        self.energy_before - self.energy_lost
    }
}

impl<const D: usize> Trajectory<D> {
    /// An empty result that will keep what the budget asks for.
    pub(super) fn begin(start: State<D>) -> Self {
        Self {
            paths: vec![Vec::new(); start.positions.len()],
            states: Vec::new(),
            impacts: Vec::new(),
            impact_count: 0,
            steps: 0,
            evaluations: 0,
            last: start,
            ending: Ending::Time,
        }
    }

    /// Notes an impact.
    pub(super) fn note(&mut self, impact: Impact<D>, budget: &Budget) {
        self.impact_count += 1;
        if budget.keep != Keep::Count {
            self.impacts.push(impact);
        }
    }

    /// Notes how a body moved.
    pub(super) fn extend(&mut self, body: usize, segment: Segment<D>, budget: &Budget) {
        if budget.keep.has_paths() && segment.end > segment.start {
            self.paths[body].push(segment);
        }
    }

    /// Position and velocity of a body at a time; `None` outside the run, or where no path was kept.
    #[must_use]
    pub fn at(&self, body: usize, time: f64) -> Option<(Vector<D>, Vector<D>)> {
        let path = self.paths.get(body)?;
        let index = path.partition_point(|segment| segment.end < time);
        let segment = path.get(index).filter(|segment| segment.start <= time)?;
        Some(segment.motion.at(time - segment.start))
    }
    /// Position and velocity of a body just after what happens at a time; `None` outside the run, or where no path was kept.
    #[must_use]
    pub fn just_after(&self, body: usize, time: f64) -> Option<(Vector<D>, Vector<D>)> {
        let path = self.paths.get(body)?;
        let index = path.partition_point(|segment| segment.start <= time).checked_sub(1)?;
        let segment = path.get(index).filter(|segment| time <= segment.end)?;
        Some(segment.motion.at(time - segment.start))
    }
}
